#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/split/reference.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace planetree::test {

/// How the boxes of a random set of references are drawn.
struct ReferenceStyle {
  const char* name;
  bool hasIntegerCoordinates = false;  ///< from a small grid, so that ends coincide
  double planarChance = 0.0;           ///< per axis
  double duplicateChance = 0.0;        ///< of repeating an earlier box
  double largestSize = 1.0;            ///< as a part of the cell
  bool sticksOut = false;              ///< boxes may begin and end outside the cell
};

inline constexpr ReferenceStyle kReferenceStyles[] = {
    {.name = "continuous"},
    {.name = "small", .largestSize = 0.1},
    {.name = "grid", .hasIntegerCoordinates = true},
    {.name = "planar", .planarChance = 0.6},
    {.name = "planar grid", .hasIntegerCoordinates = true, .planarChance = 0.6},
    {.name = "points", .planarChance = 1.0},
    {.name = "grid points", .hasIntegerCoordinates = true, .planarChance = 1.0},
    {.name = "duplicates", .planarChance = 0.2, .duplicateChance = 0.7},
    {.name = "sticking out", .planarChance = 0.2, .sticksOut = true},
    {.name = "grid sticking out",
     .hasIntegerCoordinates = true,
     .planarChance = 0.3,
     .duplicateChance = 0.2,
     .sticksOut = true},
};

/// A cell and the references in it.
struct ReferenceSet {
  Box3 cell;
  std::vector<Reference> references;
};

class ReferenceGenerator {
 public:
  explicit ReferenceGenerator(std::uint32_t seed) : random_(seed) {}

  [[nodiscard]] std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  [[nodiscard]] bool withChance(double chance) {
    return std::uniform_real_distribution<double>(0.0, 1.0)(random_) < chance;
  }

  [[nodiscard]] float between(float lower, float upper) {
    return std::uniform_real_distribution<float>(lower, upper)(random_);
  }

  /// A cell; each extent is zero with the given chance.
  [[nodiscard]] Box3 cell(bool hasIntegerCoordinates, double flatChance) {
    Box3 cell;
    for (const Axis axis : kAxes) {
      const float lower =
          hasIntegerCoordinates ? static_cast<float>(below(5)) - 2.0f : between(-10.0f, 10.0f);
      const float size =
          hasIntegerCoordinates ? 1.0f + static_cast<float>(below(8)) : between(0.5f, 20.0f);
      cell.lower[axis] = lower;
      cell.upper[axis] = withChance(flatChance) ? lower : lower + size;
    }
    return cell;
  }

  [[nodiscard]] Reference reference(const ReferenceStyle& style, const Box3& cell) {
    Reference reference;
    reference.leftSides = static_cast<std::uint32_t>(below(8));
    for (const Axis axis : kAxes) {
      const auto [lower, upper] = interval(style, cell.lower[axis], cell.upper[axis]);
      reference.bounds.lower[axis] = lower;
      reference.bounds.upper[axis] = withChance(style.planarChance) ? lower : upper;
    }
    return reference;
  }

  [[nodiscard]] ReferenceSet set(const ReferenceStyle& style, std::size_t count,
                                 double flatChance) {
    ReferenceSet set{.cell = cell(style.hasIntegerCoordinates, flatChance), .references = {}};
    for (std::size_t i = 0; i < count; ++i) {
      const bool repeats = i > 0 && withChance(style.duplicateChance);
      Reference next = repeats ? set.references[below(i)] : reference(style, set.cell);
      if (repeats)
        next.leftSides = static_cast<std::uint32_t>(below(8));
      next.object = static_cast<std::uint32_t>(i);
      set.references.push_back(next);
    }
    return set;
  }

 private:
  /// The ends of a box along one axis, where the cell reaches from `lower` to `upper`.
  std::pair<float, float> interval(const ReferenceStyle& style, float lower, float upper) {
    const float margin = style.sticksOut ? 2.0f : 0.0f;
    const float from = lower - margin;
    const float to = upper + margin;
    if (style.hasIntegerCoordinates) {
      const auto stepCount = static_cast<std::size_t>(to - from) + 1;
      const float first = from + static_cast<float>(below(stepCount));
      const float second = from + static_cast<float>(below(stepCount));
      return {std::min(first, second), std::max(first, second)};
    }
    const float size = (to - from) * static_cast<float>(style.largestSize) * between(0.0f, 1.0f);
    const float first = std::min(from + (to - from) * between(0.0f, 1.0f), to);
    return {first, std::min(first + size, to)};
  }

  std::mt19937 random_;
};

}  // namespace planetree::test
