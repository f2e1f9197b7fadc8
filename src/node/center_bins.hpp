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

/// Divides objects of one leaf after the other by the bin that the center of their box falls into,
/// along the axis on which the centers reach farthest. Wald, "On fast construction of SAH-based
/// bounding volume hierarchies", IEEE Symposium on Interactive Ray Tracing 2007.
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
  void scaleTo(const Box3& centers) noexcept;
  [[nodiscard]] std::size_t binOf(const Box3& box) const noexcept;
  void count(std::span<const Box3> boxes, std::span<const std::uint32_t> places) noexcept;
  /// The bin above the cheapest edge; 0 if there is none.
  [[nodiscard]] std::size_t findCheapestEdge(double perTest) const noexcept;

  Axis axis_ = Axis::X;
  float lower_ = 0.0f;
  float scale_ = 0.0f;
  std::array<Bin, kBinCount> bins_;
  std::vector<std::uint32_t> right_;  ///< places; room that is used again
};

/// Of equally long ones the first.
[[nodiscard]] inline Axis longestAxis(const Box3& box) noexcept {
  const Vec3f size = box.size();
  if (size.x >= size.y && size.x >= size.z)
    return Axis::X;
  return size.y >= size.z ? Axis::Y : Axis::Z;
}

/// The middle of a box along an axis.
[[nodiscard]] inline float centerAlong(const Box3& box, Axis axis) noexcept {
  return 0.5f * box.lower[axis] + 0.5f * box.upper[axis];
}

}  // namespace planetree::detail
