#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/split/cost_model.hpp>
#include <planetree/split/reference.hpp>

#include "split/end_counting.hpp"
#include "support/bin_of.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace planetree::detail {

/// Divides a cell along each axis into bins of equal width. Whatever is rounded, a position never
/// falls into a lower bin than one below it; positions outside the cell fall into the outermost
/// bins.
class BinScale {
 public:
  BinScale(const Box3& cell, std::size_t binCount) noexcept;

  [[nodiscard]] std::size_t binCount() const noexcept { return binCount_; }

  [[nodiscard]] std::size_t binOf(Axis axis, float position) const noexcept {
    return detail::binOf(position, lower(axis), binsPerLength(axis), last_);
  }

  /// For counting.
  [[nodiscard]] float lower(Axis axis) const noexcept {
    return lower_[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] float binsPerLength(Axis axis) const noexcept {
    return scale_[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] float lastBin() const noexcept { return last_; }

  /// How far from the lower wall of the cell the positions of a bin are, at least and at most.
  /// Rounding is allowed for.
  [[nodiscard]] double lowestIn(Axis axis, std::size_t bin) const noexcept;
  [[nodiscard]] double highestIn(Axis axis, std::size_t bin) const noexcept;

 private:
  std::size_t binCount_;
  float last_;
  std::array<float, 3> lower_;
  std::array<float, 3> scale_;
  std::array<double, 3> size_;
};

/// How many boxes begin, and how many end, in each bin of each axis. Hurley, Kapustin, Reshetov,
/// Soupikov, "Fast ray tracing for modern general purpose CPU", GraphiCon 2002; Shevtsov, Soupikov,
/// Kapustin, "Highly parallel fast kd-tree construction for interactive ray tracing of dynamic
/// scenes", Eurographics 2007 ("min-max binning").
struct BinCounts {
  static constexpr std::size_t kMaxBinCount = EndCounting::kMaxBinCount;

  /// By axis and bin. One behind the other, as the kernels count them.
  using Counts = std::array<std::uint32_t, kMaxBinCount>;
  std::array<Counts, 3> lowerEnds = {};
  std::array<Counts, 3> upperEnds = {};

  /// Counts the references in; linear in them.
  void add(std::span<const Reference> references, const BinScale& scale) noexcept;
  void add(const BinCounts& other) noexcept;
  void clear(std::size_t binCount) noexcept;
};

}  // namespace planetree::detail
