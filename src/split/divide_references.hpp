#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/reference.hpp>
#include <planetree/split/split_plane.hpp>

#include "support/memory_meter.hpp"
#include "support/plain_array.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

namespace planetree::detail {

/// Shrinks the boxes of references to what their objects have inside a cell.
using ClipReferences = std::function<void(const Box3& cell, std::span<Reference> references)>;

/// Divides the references of one cell after the other by a plane, with room that is used again.
class ReferenceDivider {
 public:
  /// Both must outlive the divider.
  ReferenceDivider(const BuildOptions& options, const ClipReferences& clip)
      : options_(options), clip_(clip) {}

  /// Makes `left` and `right` those of these references that have a part there, in their order. The
  /// boxes of objects on both sides are clipped, under `clipsReferences`. Linear.
  void divide(std::span<const Reference> references, const SplitPlane& plane, const Box3& cell);

  /// Until the next cell is divided.
  [[nodiscard]] std::span<const Reference> left() const noexcept { return left_.values(); }
  [[nodiscard]] std::span<const Reference> right() const noexcept { return right_.values(); }

 private:
  template <Axis kAxis>
  std::size_t divideAlong(std::span<const Reference> references, const SplitPlane& plane) noexcept;
  void clipStraddling(PlainArray<Reference>& side, std::span<const std::uint32_t> straddling,
                      const Box3& cell);

  const BuildOptions& options_;
  const ClipReferences& clip_;
  PlainArray<Reference> left_;
  PlainArray<Reference> right_;
  PlainArray<std::uint32_t> straddlingLeft_;   ///< where they are on the left
  PlainArray<std::uint32_t> straddlingRight_;  ///< where they are on the right
  PlainArray<Reference> clipped_;
};

/// The references of a cell in an array of their own.
struct CellReferences {
  CellReferences() = default;
  CellReferences(std::size_t count, MemoryMeter& memory)
      : charge(memory, count * sizeof(Reference)), references(count) {}

  MemoryCharge charge;
  PlainArray<Reference> references;
};

/// Arrays for the references of cells, which are used again: memory that the system hands out anew
/// has to be cleared first, which takes longer than to fill it. Any thread may use it.
class ReferencePool {
 public:
  /// `memory` must outlive the pool.
  explicit ReferencePool(MemoryMeter& memory) : memory_(memory) {}

  [[nodiscard]] CellReferences take(std::size_t count);
  void giveBack(CellReferences references);

 private:
  MemoryMeter& memory_;
  std::mutex mutex_;
  std::vector<CellReferences> free_;
};

/// The references on both sides of a plane.
struct DividedReferences {
  CellReferences left;
  CellReferences right;
};

/// Does the same as a `ReferenceDivider` with all threads of the current arena, and gives back what
/// was divided.
[[nodiscard]] DividedReferences divideTogether(CellReferences cellReferences,
                                               const SplitPlane& plane, const Box3& cell,
                                               const BuildOptions& options,
                                               const ClipReferences& clip, ReferencePool& pool);

}  // namespace planetree::detail
