#pragma once

#include <planetree/traversal/query_options.hpp>
#include <planetree/traversal/tree_view.hpp>

#include "batch/columns.hpp"
#include "batch/packet_order.hpp"
#include "isa/kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace planetree::detail {

/// Traces portions of a batch: rays that go the same way in packets, the others one by one. May be
/// asked by any number of threads at once.
template <class T>
class PortionTracer {
 public:
  /// All must outlive it.
  PortionTracer(const TreeView<T>& tree, const RayColumns<T>& rays,
                const QueryOptions& options) noexcept;

  [[nodiscard]] std::size_t packetCount() const noexcept { return order_.packetCount(); }

  /// The nearest hits of the packets from `begin` to `end`. Returns how many rays hit something.
  std::size_t findNearest(std::size_t begin, std::size_t end,
                          const HitColumns<T>& hits) const noexcept;
  /// The same for any hit.
  std::size_t findAny(std::size_t begin, std::size_t end,
                      std::span<std::uint8_t> flags) const noexcept;

 private:
  using SearchPackets = decltype(Kernels::findNearestOfPackets);

  template <class Visit>
  void forEachRay(std::size_t begin, std::size_t end, const Visit& visit) const;
  /// Rays of packets that `search` leaves unanswered go to `traceAlone`, the others to `write`;
  /// `fetch` is told of each some time before.
  template <class TraceAlone, class Fetch, class Write>
  void traceGroups(std::size_t begin, std::size_t end, SearchPackets search,
                   const TraceAlone& traceAlone, const Fetch& fetch, const Write& write) const;

  const TreeView<T>& tree_;
  const RayColumns<T>& rays_;
  PacketOrder order_;
  const QueryOptions& options_;
  const Kernels* kernels_ = nullptr;  ///< null if there are no packets for such a query
};

extern template class PortionTracer<float>;
extern template class PortionTracer<double>;

}  // namespace planetree::detail
