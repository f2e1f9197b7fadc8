#include "scene/ray_format/transform_reader.hpp"

#include <array>
#include <string>
#include <string_view>

namespace planetree::scene::ray_format {
namespace {

constexpr std::string_view kTranslateAdvice = "Write translate(x, y, z, what)";
constexpr std::string_view kRotateAdvice = "Write rotate(x, y, z, angle, what)";
constexpr std::string_view kScaleAdvice = "Write scale(s, what) or scale(x, y, z, what)";
constexpr std::string_view kTransformAdvice = "Write transform(row, row, row, row, what)";

/// "x, y, z,"
Vec3d threeNumbers(TokenReader& tokens, std::string_view advice) {
  Vec3d v;
  for (const Axis axis : kAxes) {
    v[axis] = tokens.number();
    tokens.expect(',', "behind the number", advice);
  }
  return v;
}

Affine readRotation(TokenReader& tokens, const Token& keyword) {
  const Vec3d axis = threeNumbers(tokens, kRotateAdvice);
  const double angle = tokens.number();
  tokens.expect(',', "behind the angle", kRotateAdvice);
  if (axis == Vec3d{0, 0, 0}) {
    throw tokens.malformed(keyword.place, "the axis of the rotation is (0, 0, 0)",
                           "Choose another axis: (0, 0, 1) turns x to y");
  }
  return Affine::rotation(axis, angle);
}

Affine readScaling(TokenReader& tokens) {
  const double x = tokens.number();
  tokens.expect(',', "behind the number", kScaleAdvice);
  if (tokens.peek().kind != TokenKind::Number)
    return Affine::scaling({x, x, x});
  const double y = tokens.number();
  tokens.expect(',', "behind the number", kScaleAdvice);
  const double z = tokens.number();
  tokens.expect(',', "behind the number", kScaleAdvice);
  return Affine::scaling({x, y, z});
}

Affine readMatrix(TokenReader& tokens) {
  std::array<std::array<double, 4>, 4> rows;
  TextPlace lastRow;
  for (std::array<double, 4>& row : rows) {
    lastRow = tokens.peek().place;
    row = tokens.fourNumbers();
    tokens.expect(',', "behind the row", kTransformAdvice);
  }
  if (rows[3] != std::array{0.0, 0.0, 0.0, 1.0}) {
    throw tokens.malformed(lastRow, "the last row of the transform is not (0, 0, 0, 1)",
                           "Projections cannot be used. If the matrix is for rows of points, "
                           "write its columns as rows");
  }
  const auto column = [&](std::size_t i) { return Vec3d{rows[0][i], rows[1][i], rows[2][i]}; };
  return {column(0), column(1), column(2), column(3)};
}

Affine readLocal(TokenReader& tokens, const Token& keyword) {
  if (keyword.text == "translate") {
    tokens.expect('(', "behind \"translate\"", kTranslateAdvice);
    return Affine::translation(threeNumbers(tokens, kTranslateAdvice));
  }
  if (keyword.text == "rotate") {
    tokens.expect('(', "behind \"rotate\"", kRotateAdvice);
    return readRotation(tokens, keyword);
  }
  if (keyword.text == "scale") {
    tokens.expect('(', "behind \"scale\"", kScaleAdvice);
    return readScaling(tokens);
  }
  tokens.expect('(', "behind \"transform\"", kTransformAdvice);
  return readMatrix(tokens);
}

}  // namespace

Affine readTransform(TokenReader& tokens, const Token& keyword, const Affine& outer) {
  const Affine local = readLocal(tokens, keyword);
  if (!local.inverse()) {
    throw tokens.malformed(keyword.place,
                           "this \"" + std::string(keyword.text) +
                               "\" is singular: it makes shapes flat, or is beyond all numbers",
                           "Scale by a small number instead of 0");
  }
  const Affine placement = outer * local;
  if (!placement.isFinite() || !placement.inverse()) {
    throw tokens.malformed(keyword.place,
                           "this \"" + std::string(keyword.text) +
                               "\" and those around it make shapes too small or too large",
                           "Scale by numbers nearer to 1");
  }
  return placement;
}

}  // namespace planetree::scene::ray_format
