#pragma once

#include <assimp/scene.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace planetree::importing {

/// A transform in double: products of many nodes then round far below the float of a coordinate.
class Placement {
 public:
  Placement() = default;

  explicit Placement(const aiMatrix4x4& m) noexcept
      : rows_{{{m.a1, m.a2, m.a3, m.a4}, {m.b1, m.b2, m.b3, m.b4}, {m.c1, m.c2, m.c3, m.c4}}} {}

  /// The placement of a child: its own transform first, then this one.
  [[nodiscard]] Placement of(const Placement& child) const noexcept {
    Placement product;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        double sum = column == 3 ? rows_[row][3] : 0.0;
        for (std::size_t i = 0; i < 3; ++i)
          sum += rows_[row][i] * child.rows_[i][column];
        product.rows_[row][column] = sum;
      }
    }
    return product;
  }

  [[nodiscard]] std::array<double, 3> point(const aiVector3D& p) const noexcept {
    std::array<double, 3> result;
    for (std::size_t row = 0; row < 3; ++row)
      result[row] = rowTimes(row, p) + rows_[row][3];
    return result;
  }

  [[nodiscard]] std::array<double, 3> direction(const aiVector3D& d) const noexcept {
    return {rowTimes(0, d), rowTimes(1, d), rowTimes(2, d)};
  }

  /// The images of the axes and of the origin, one after the other.
  [[nodiscard]] std::array<double, 12> columns() const noexcept {
    std::array<double, 12> numbers;
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t row = 0; row < 3; ++row)
        numbers[3 * column + row] = rows_[row][column];
    }
    return numbers;
  }

 private:
  [[nodiscard]] double rowTimes(std::size_t row, const aiVector3D& v) const noexcept {
    return rows_[row][0] * static_cast<double>(v.x) + rows_[row][1] * static_cast<double>(v.y) +
           rows_[row][2] * static_cast<double>(v.z);
  }

  std::array<std::array<double, 4>, 3> rows_ = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
};

/// A node and where it is in the world.
struct PlacedNode {
  const aiNode* node;
  Placement placement;
};

/// All nodes in the order of the file, parents before children.
[[nodiscard]] std::vector<PlacedNode> placedNodes(const aiScene& scene);

}  // namespace planetree::importing
