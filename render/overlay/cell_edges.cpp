#include "render/overlay/cell_edges.hpp"

#include <array>

namespace planetree::render {

namespace {

using Visit = std::function<void(const CellEdge&)>;

/// The other two axes.
std::array<Axis, 2> axesBeside(Axis axis) noexcept {
  switch (axis) {
    case Axis::X:
      return {Axis::Y, Axis::Z};
    case Axis::Y:
      return {Axis::Z, Axis::X};
    case Axis::Z:
      break;
  }
  return {Axis::X, Axis::Y};
}

/// The four edges that run along an axis.
void visitEdgesAlong(Axis axis, const Box3& box, const Visit& visit) {
  const auto [second, third] = axesBeside(axis);
  for (const float atSecond : {box.lower[second], box.upper[second]}) {
    for (const float atThird : {box.lower[third], box.upper[third]}) {
      CellEdge edge{box.lower, box.upper};
      edge.a[second] = edge.b[second] = atSecond;
      edge.a[third] = edge.b[third] = atThird;
      visit(edge);
    }
  }
}

/// The edges of the rectangle that a plane cuts out of a cell.
void visitRectangle(const Box3& cell, Axis axis, float position, const Visit& visit) {
  const auto [second, third] = axesBeside(axis);
  Vec3f a = cell.lower;
  a[axis] = position;
  Vec3f c = cell.upper;
  c[axis] = position;
  Vec3f b = a;
  b[second] = c[second];
  Vec3f d = a;
  d[third] = c[third];
  for (const CellEdge& edge : {CellEdge{a, b}, {b, c}, {c, d}, {d, a}})
    visit(edge);
}

void visitBelow(const Node& node, const Box3& cell, std::uint32_t levels, const Visit& visit) {
  if (levels == 0 || node.isLeaf())
    return;
  const SplitNode& split = node.split();
  visitRectangle(cell, split.axis(), split.position(), visit);
  visitBelow(split.left(), leftPart(cell, split.axis(), split.position()), levels - 1, visit);
  visitBelow(split.right(), rightPart(cell, split.axis(), split.position()), levels - 1, visit);
}

}  // namespace

void forEachCellEdge(std::span<const Node> nodes, const Box3& bounds, std::uint32_t depth,
                     const Visit& visit) {
  if (bounds.isEmpty())
    return;
  for (const Axis axis : kAxes)
    visitEdgesAlong(axis, bounds, visit);
  visitBelow(nodes.front(), bounds, depth - 1, visit);
}

}  // namespace planetree::render
