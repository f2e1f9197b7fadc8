#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/reference.hpp>
#include <planetree/split/split_plane.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

/// The algorithm as it is taught, written down line by line and slowly: every candidate plane
/// counts both sides by looking at every object again. It shares no code with the library but the
/// types and `CostModel::splitCost`, and decides what the library's sweep has to find.
namespace planetree::test {

/// 2 (xy + yz + zx) in double; the order of the operations is that of `Box3::surfaceArea`, since
/// costs are compared bit for bit.
[[nodiscard]] inline double areaOf(const Box3& box) {
  const auto extent = [&](Axis axis) {
    return static_cast<double>(box.upper[axis]) - static_cast<double>(box.lower[axis]);
  };
  const double x = extent(Axis::X);
  const double y = extent(Axis::Y);
  const double z = extent(Axis::Z);
  return 2.0 * (x * y + y * z + z * x);
}

[[nodiscard]] inline Box3 leftBoxOf(Box3 cell, Axis axis, float position) {
  cell.upper[axis] = position;
  return cell;
}

[[nodiscard]] inline Box3 rightBoxOf(Box3 cell, Axis axis, float position) {
  cell.lower[axis] = position;
  return cell;
}

/// Left and right of a plane by the four lines of the taught `buildTree`. Objects in the plane go
/// by the sign of the normal.
struct TextbookSides {
  bool left = false;
  bool right = false;
};

[[nodiscard]] inline TextbookSides textbookSidesOf(const Reference& object, Axis axis,
                                                   float position) {
  const float lower = object.bounds.lower[axis];
  const float upper = object.bounds.upper[axis];
  const bool normalIsNegative = (object.leftSides & (1u << static_cast<unsigned>(axis))) != 0;
  TextbookSides sides;
  if (lower < position)
    sides.left = true;
  if (upper > position)
    sides.right = true;
  if (position == upper && position == lower && normalIsNegative)
    sides.left = true;
  else if (position == upper && position == lower && !normalIsNegative)
    sides.right = true;
  return sides;
}

/// What the taught `findBestSplitPlane` returns.
struct TextbookPlane {
  Axis axis = Axis::X;
  float position = 0.0f;
  std::uint64_t leftCount = 0;
  std::uint64_t rightCount = 0;
  double sam = std::numeric_limits<double>::infinity();
};

/// SAM = (nL AL + nR AR) / A of one plane. Small integers make it exact up to the division.
[[nodiscard]] inline TextbookPlane textbookPlane(std::span<const Reference> objects,
                                                 const Box3& cell, Axis axis, float position) {
  TextbookPlane plane{.axis = axis, .position = position};
  for (const Reference& object : objects) {
    const TextbookSides sides = textbookSidesOf(object, axis, position);
    plane.leftCount += sides.left ? 1 : 0;
    plane.rightCount += sides.right ? 1 : 0;
  }
  const double leftArea = areaOf(leftBoxOf(cell, axis, position));
  const double rightArea = areaOf(rightBoxOf(cell, axis, position));
  plane.sam = (static_cast<double>(plane.leftCount) * leftArea +
               static_cast<double>(plane.rightCount) * rightArea) /
              areaOf(cell);
  return plane;
}

/// The taught `findBestSplitPlane`. Left open there: a candidate outside the cell does not divide
/// it, and is no candidate here.
[[nodiscard]] inline std::optional<TextbookPlane> findTextbookPlane(
    std::span<const Reference> objects, const Box3& cell) {
  std::vector<std::pair<Axis, float>> candidates;
  for (const Axis axis : kAxes) {
    for (const Reference& object : objects) {
      candidates.emplace_back(axis, object.bounds.lower[axis]);
      candidates.emplace_back(axis, object.bounds.upper[axis]);
    }
  }
  double minSam = std::numeric_limits<double>::infinity();
  std::optional<TextbookPlane> best;
  for (const auto& [axis, position] : candidates) {
    if (position < cell.lower[axis] || position > cell.upper[axis])
      continue;
    const TextbookPlane plane = textbookPlane(objects, cell, axis, position);
    if (plane.sam < minSam) {
      minSam = plane.sam;
      best = plane;
    }
  }
  return best;
}

/// One way to put a plane: where it is, and who gets the objects that lie in it.
struct OraclePlane {
  Axis axis = Axis::X;
  float position = 0.0f;
  Side planarSide = Side::Right;
  std::uint64_t leftCount = 0;
  std::uint64_t rightCount = 0;
  double cost = 0.0;

  /// Cheaper first; then by axis, then the lower position, then planar objects on the right.
  [[nodiscard]] bool isBetterThan(const OraclePlane& other) const {
    const auto rank = [](const OraclePlane& plane) {
      return std::tuple(plane.cost, plane.axis, plane.position, plane.planarSide == Side::Left);
    };
    return rank(*this) < rank(other);
  }
};

[[nodiscard]] inline OraclePlane oraclePlane(std::span<const Reference> objects, const Box3& cell,
                                             Axis axis, float position, Side planarSide,
                                             const BuildOptions& options) {
  OraclePlane plane{.axis = axis, .position = position, .planarSide = planarSide};
  for (const Reference& object : objects) {
    TextbookSides sides = textbookSidesOf(object, axis, position);
    const bool liesInPlane =
        object.bounds.lower[axis] == position && object.bounds.upper[axis] == position;
    if (liesInPlane && options.planarRule == PlanarRule::CheaperSide)
      sides = {.left = planarSide == Side::Left, .right = planarSide == Side::Right};
    plane.leftCount += sides.left ? 1 : 0;
    plane.rightCount += sides.right ? 1 : 0;
  }
  plane.cost = options.cost.splitCost(plane.leftCount, areaOf(leftBoxOf(cell, axis, position)),
                                      plane.rightCount, areaOf(rightBoxOf(cell, axis, position)),
                                      areaOf(cell));
  return plane;
}

/// The same search by the library's rules: its costs and ties, planes on the walls of the cell only
/// without `allowsEmptyCells`, and planar objects tried on both sides unless their normal decides.
[[nodiscard]] inline std::optional<OraclePlane> findBestSplitPlaneByCounting(
    std::span<const Reference> objects, const Box3& cell, const BuildOptions& options) {
  std::optional<OraclePlane> best;
  const auto improve = [&](Axis axis, float position, Side planarSide) {
    const OraclePlane plane = oraclePlane(objects, cell, axis, position, planarSide, options);
    if (!best || plane.isBetterThan(*best))
      best = plane;
  };
  for (const Axis axis : kAxes) {
    for (const Reference& object : objects) {
      for (const float position : {object.bounds.lower[axis], object.bounds.upper[axis]}) {
        const bool isInside = position > cell.lower[axis] && position < cell.upper[axis];
        const bool isOnWall = position == cell.lower[axis] || position == cell.upper[axis];
        if (!isInside && !(isOnWall && !options.allowsEmptyCells))
          continue;
        improve(axis, position, Side::Right);
        if (options.planarRule == PlanarRule::CheaperSide)
          improve(axis, position, Side::Left);
      }
    }
  }
  return best;
}

/// What the taught `buildTree` returns: a leaf with its objects, or a plane and two children.
struct TextbookNode {
  std::vector<std::uint32_t> objects;
  Axis axis = Axis::X;
  float position = 0.0f;
  std::unique_ptr<TextbookNode> left;
  std::unique_ptr<TextbookNode> right;

  [[nodiscard]] bool isLeaf() const { return left == nullptr; }
};

[[nodiscard]] inline std::unique_ptr<TextbookNode> textbookLeaf(
    const std::vector<Reference>& objects) {
  auto leaf = std::make_unique<TextbookNode>();
  for (const Reference& object : objects)
    leaf->objects.push_back(object.object);
  return leaf;
}

/// The taught `buildTree`, with `leafSize` and `depthLimit` of the options. `depth` is 0 at the
/// root. Equal costs are broken as the library breaks them, or the trees could not be compared.
[[nodiscard]] inline std::unique_ptr<TextbookNode> buildTextbookTree(
    const std::vector<Reference>& objects, const Box3& cell, std::uint32_t depth,
    const BuildOptions& options) {
  if (objects.size() <= options.leafSize || ++depth == options.depthLimit)
    return textbookLeaf(objects);
  const std::optional<OraclePlane> plane = findBestSplitPlaneByCounting(objects, cell, options);
  if (!plane)
    return textbookLeaf(objects);
  std::vector<Reference> leftList;
  std::vector<Reference> rightList;
  for (const Reference& object : objects) {
    const TextbookSides sides = textbookSidesOf(object, plane->axis, plane->position);
    if (sides.left)
      leftList.push_back(object);
    if (sides.right)
      rightList.push_back(object);
  }
  if (leftList.empty() || rightList.empty())
    return textbookLeaf(objects);
  auto node = std::make_unique<TextbookNode>();
  node->axis = plane->axis;
  node->position = plane->position;
  node->left =
      buildTextbookTree(leftList, leftBoxOf(cell, plane->axis, plane->position), depth, options);
  node->right =
      buildTextbookTree(rightList, rightBoxOf(cell, plane->axis, plane->position), depth, options);
  return node;
}

}  // namespace planetree::test
