#include "scene/json_format/transform_reader.hpp"

#include "scene/json_format/value_reader.hpp"

#include <array>
#include <numbers>
#include <variant>

namespace planetree::scene::json_format {

namespace {

constexpr const char* kSingularAdvice =
    "Nothing can be seen of what is pressed flat: scale by factors other than 0.";

Affine readScale(const JsonText& text, const Value& value) {
  if (const auto* factor = std::get_if<double>(&value.content))
    return Affine::scaling({*factor, *factor, *factor});
  if (!std::holds_alternative<Array>(value.content))
    throw wrongType(text, value, "\"scale\"", "a number or a list of three");
  return Affine::scaling(vectorOf(text, value, "\"scale\""));
}

Affine readRotation(const JsonText& text, const Value& value) {
  const ObjectReader rotation(text, value, kRotationSyntax);
  const Vec3d axis = directionOf(text, rotation.at("axis"), "the axis");
  const double degrees = numberOf(text, rotation.at("degrees"), "\"degrees\"");
  return Affine::rotation(axis, degrees * (std::numbers::pi / 180.0));
}

/// Four rows of four numbers, as it is written before a column.
Affine readMatrix(const JsonText& text, const Value& value) {
  constexpr const char* kAdvice =
      "Give four rows of four numbers, the shift in the last column, and [0, 0, 0, 1] at the end.";
  const Array& rows = arrayOf(text, value, "\"matrix\"");
  if (rows.size() != 4)
    throw text.malformed(value.offset, "the matrix does not have four rows", kAdvice);
  std::array<std::array<double, 4>, 4> matrix{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Array& row = arrayOf(text, rows[i], "a row of the matrix");
    if (row.size() != 4)
      throw text.malformed(rows[i].offset, "the row does not have four numbers", kAdvice);
    for (std::size_t j = 0; j < 4; ++j)
      matrix[i][j] = numberOf(text, row[j], "an entry of the matrix");
  }
  if (matrix[3] != std::array{0.0, 0.0, 0.0, 1.0})
    throw text.malformed(rows[3].offset, "the last row of the matrix is not 0, 0, 0, 1", kAdvice);
  const auto column = [&](std::size_t j) {
    return Vec3d{matrix[0][j], matrix[1][j], matrix[2][j]};
  };
  return {column(0), column(1), column(2), column(3)};
}

Affine readStep(const JsonText& text, const Value& value) {
  // Which key it is decides all; a step with several would hide their order.
  const ObjectReader step(text, value, kTransformStepSyntax);
  const Object& members = objectOf(text, value, "the step");
  if (members.size() != 1) {
    throw text.malformed(value.offset, "a step of a transform needs one key",
                         "Give one of \"translate\", \"rotate\", \"scale\", \"matrix\" in each.");
  }
  const auto& [key, keyOffset, argument] = members.front();
  if (key == "translate")
    return Affine::translation(vectorOf(text, argument, "\"translate\""));
  if (key == "rotate")
    return readRotation(text, argument);
  if (key == "scale")
    return readScale(text, argument);
  return readMatrix(text, argument);
}

}  // namespace

Affine readTransform(const JsonText& text, const Value& value) {
  Affine transform;
  for (const Value& item : arrayOf(text, value, "\"transform\"")) {
    const Affine step = readStep(text, item);
    if (!step.inverse())
      throw text.malformed(item.offset, "the transform is singular", kSingularAdvice);
    transform = step * transform;
  }
  if (!transform.isFinite() || !transform.inverse()) {
    throw text.malformed(value.offset, "the transform is too large or too small",
                         "Scale by less in all.");
  }
  return transform;
}

}  // namespace planetree::scene::json_format
