#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace planetree::detail {

/// Divides objects of one leaf after the other by the bin that the center of their box falls into.
/// Wald, "On fast construction of SAH-based bounding volume hierarchies", IEEE Symposium on
/// Interactive Ray Tracing 2007.
class CenterBins {
 public:
  struct Cut {
    Axis axis = Axis::X;
    std::size_t leftCount = 0;
  };

  /// Moves the places of those below the cheapest edge between bins to the front, in their order,
  /// and returns how many they are; nothing if all centers fall into one bin. A side costs its area
  /// times the tests it takes, `perTest` objects in each. `centers` bounds the centers of the
  /// boxes. Linear.
  [[nodiscard]] std::optional<Cut> divide(std::span<const Box3> boxes, const Box3& centers,
                                          std::span<std::uint32_t> places, double perTest);

 private:
  static constexpr std::size_t kBinCount = 16;

  struct Bin {
    Box3 bounds;
    std::uint32_t count = 0;

    void add(const Bin& other) noexcept;
  };
  struct Edge {
    Axis axis = Axis::X;
    std::size_t bin = 0;  ///< the one above; 0 stands for no edge
  };

  void scaleTo(const Box3& centers) noexcept;
  [[nodiscard]] std::size_t binOf(const Box3& box, Axis axis) const noexcept;
  void count(std::span<const Box3> boxes, std::span<const std::uint32_t> places) noexcept;
  [[nodiscard]] Edge findCheapestEdge(double perTest) const noexcept;

  std::array<float, 3> lower_ = {};
  std::array<float, 3> scale_ = {};
  std::array<std::array<Bin, kBinCount>, 3> bins_;
  std::vector<std::uint32_t> right_;  ///< places; room that is used again
};

/// The middle of a box along an axis.
[[nodiscard]] inline float centerAlong(const Box3& box, Axis axis) noexcept {
  return 0.5f * box.lower[axis] + 0.5f * box.upper[axis];
}

}  // namespace planetree::detail
