#pragma once

#include <planetree/split/build_options.hpp>
#include <planetree/split/reference.hpp>
#include <planetree/split/split_plane.hpp>

#include "split/plane_bins.hpp"
#include "support/plain_array.hpp"
#include "support/sort_words.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace planetree::detail {

/// Finds the best plane of one cell after the other, with room that is used again.
///
/// By branch and bound: bins say how many objects are at least on each side of any plane through a
/// bin, and thus what such a plane costs at least. Only the ends in bins that may hold the best
/// plane are sorted and swept. The result is that of a sweep over all ends, plane for plane, in
/// little more than the time of a search among the edges of the bins, unless very many planes cost
/// the same. Without `exactPlanes` no more than the bins next to the best edge are opened, where
/// there is a plane in them.
class PlaneSearch {
 public:
  /// `options` must outlive the search.
  explicit PlaneSearch(const BuildOptions& options) : options_(options) {}

  /// What `findBestSplitPlane` returns, if that costs less than `limit`; else nothing. Uses more
  /// than one thread for many references, those of the arena that it is called in.
  [[nodiscard]] std::optional<SplitPlane> find(
      std::span<const Reference> references, const Box3& cell,
      double limit = std::numeric_limits<double>::infinity());

 private:
  static constexpr std::size_t kMaxBinCount = BinCounts::kMaxBinCount;

  /// An end of a box, or a box that is flat: its position, and below it what it is. Their order is
  /// that of their positions.
  using Event = std::uint64_t;
  struct EventList {
    PlainArray<Event> room;  ///< only grows
    std::size_t count = 0;

    [[nodiscard]] std::span<Event> events() noexcept { return room.values().first(count); }
  };
  using Events = std::array<EventList, 3>;

  /// What a plane costs, as a function of its distance from the lower wall: but for rounding that
  /// of `CostModel::splitCost`.
  struct AxisCost {
    double constant = 0.0;  ///< of one object
    double slope = 0.0;     ///< of one object
    double size = 0.0;      ///< of the cell
  };

  /// Between two bins of an axis.
  struct Edge {
    double cost = std::numeric_limits<double>::infinity();  ///< of a plane there
    Axis axis = Axis::X;
    std::size_t bin = 0;  ///< the one above; 0 if there is no edge
  };

  enum class Edges : std::uint8_t {
    All,
    /// Not those of axes along which all objects lie in an outermost bin. They cut off empty space
    /// at no cost, but where the objects lie in the wall itself there is no such plane.
    WithPlanes,
  };

  void count(std::span<const Reference> references, const BinScale& scale);
  void sumUp(std::size_t binCount) noexcept;
  void prepareCosts(const Box3& cell) noexcept;
  [[nodiscard]] double costOf(std::size_t axis, double distance, double leftCount,
                              double rightCount) const noexcept;
  [[nodiscard]] Edge cheapestEdge(const BinScale& scale, Edges edges) const noexcept;
  /// The cheapest plane next to the best edge; nothing if there is none.
  [[nodiscard]] std::optional<SplitPlane> searchAtBestEdge(std::span<const Reference> references,
                                                           const Box3& cell, const BinScale& scale);
  /// Opens the bins next to an edge, on both sides up to the first one that is not empty.
  void openBinsAt(const Edge& edge, const BinScale& scale) noexcept;
  /// The cheapest plane in open bins.
  [[nodiscard]] std::optional<SplitPlane> searchOpenBins(std::span<const Reference> references,
                                                         const Box3& cell, const BinScale& scale);
  /// Opens the bins that may hold a plane of at most this cost; false if there are none.
  bool openBins(const BinScale& scale, double cost) noexcept;
  void gather(std::span<const Reference> references, const BinScale& scale);
  void gatherInto(Events& events, std::span<const Reference> references,
                  const BinScale& scale) const;
  void sweep(Axis axis, const Box3& cell, const BinScale& scale, std::optional<SplitPlane>& best);

  const BuildOptions& options_;
  double cellArea_ = 0.0;
  std::array<AxisCost, 3> costs_ = {};
  BinCounts counts_;
  /// By axis and bin: ends of boxes in lower bins, and in this and higher ones.
  std::array<std::array<std::uint32_t, kMaxBinCount + 1>, 3> lowerEndsBefore_ = {};
  std::array<std::array<std::uint32_t, kMaxBinCount + 1>, 3> upperEndsFrom_ = {};
  std::array<std::array<bool, kMaxBinCount>, 3> isOpen_ = {};
  Events events_;
  std::array<WordSorter, 3> sorters_;
};

}  // namespace planetree::detail
