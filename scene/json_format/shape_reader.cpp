#include "scene/json_format/shape_reader.hpp"

#include "scene/json_format/transform_reader.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>
#include <vector>

namespace planetree::scene::json_format {

namespace {

const std::array kShapeSyntaxes = {&kSphereSyntax, &kBoxSyntax,   &kSquareSyntax, &kCylinderSyntax,
                                   &kConeSyntax,   &kModelSyntax, &kGroupSyntax};

/// The syntax that the type of a shape names.
const ObjectSyntax& syntaxOf(const JsonText& text, const Value& value) {
  const Object& object = objectOf(text, value, "a shape");
  const auto type = std::ranges::find(object, "type", &Member::key);
  std::vector<std::string> known;
  for (const ObjectSyntax* syntax : kShapeSyntaxes)
    known.emplace_back(syntax->name);
  if (type == object.end())
    throw text.malformed(value.offset, "the shape has no \"type\"", adviceOf("", known));
  const std::string& name = stringOf(text, type->value, "\"type\"");
  for (const ObjectSyntax* syntax : kShapeSyntaxes) {
    if (syntax->name == name)
      return *syntax;
  }
  throw text.malformed(type->value.offset, "there is no shape " + inQuotes(name),
                       adviceOf(name, known));
}

std::size_t objectCount(const ShapeDescription& shape) noexcept {
  const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&shape);
  return mesh == nullptr || *mesh == nullptr ? 1 : 1 + (*mesh)->faces.size();
}

}  // namespace

void ShapeReader::readList(const Value& value, const Surroundings& around) {
  for (const Value& item : arrayOf(text_, value, "the list of shapes"))
    readShape(item, around);
}

// The depth of groups is that of the file, which has a limit.
void ShapeReader::readShape(const Value& value, const Surroundings& around) {
  const ObjectSyntax& syntax = syntaxOf(text_, value);
  const ObjectReader object(text_, value, syntax);
  const Value* name = object.find("name");
  const std::string shownName = name == nullptr ? "" : stringOf(text_, *name, "\"name\"");
  Surroundings own = at(object, around);
  if (&syntax == &kModelSyntax)
    return readModel(value, object, own);
  own.placement = own.placement * transformOf(object);
  if (&syntax == &kGroupSyntax)
    return readList(object.at("children"), own);
  PlacedShape shape = readSolid(syntax, object);
  shape.placement = own.placement * shape.placement;
  shape.material = own.material ? *own.material : materials_.defaultIndex();
  shape.name = shownName;
  place(value, std::move(shape));
}

ShapeReader::Surroundings ShapeReader::at(const ObjectReader& object, const Surroundings& around) {
  Surroundings own = around;
  if (const Value* position = object.find("position"))
    own.placement = own.placement * Affine::translation(vectorOf(text_, *position, "\"position\""));
  if (const Value* material = object.find("material"))
    own.material = materials_.indexOf(*material);
  return own;
}

Affine ShapeReader::transformOf(const ObjectReader& object) const {
  const Value* transform = object.find("transform");
  return transform == nullptr ? Affine() : readTransform(text_, *transform);
}

PlacedShape ShapeReader::readSolid(const ObjectSyntax& syntax, const ObjectReader& object) const {
  const auto positive = [&](const char* key, double usual) {
    const Value* value = object.find(key);
    return value == nullptr ? usual : positiveNumberOf(text_, *value, inQuotes(key));
  };
  const auto amount = [&](const char* key, double usual) {
    const Value* value = object.find(key);
    return value == nullptr ? usual : amountOf(text_, *value, inQuotes(key));
  };
  const auto isCapped = [&] {
    const Value* value = object.find("capped");
    return value == nullptr || boolOf(text_, *value, "\"capped\"");
  };
  const auto scaled = [](ShapeDescription shape, const Vec3d& factors) {
    return PlacedShape{.shape = std::move(shape), .placement = Affine::scaling(factors)};
  };
  const auto sizes = [&] {
    const Value* value = object.find("size");
    return value == nullptr ? Vec3d{1, 1, 1} : sizesOf(text_, *value, "\"size\"");
  };
  if (&syntax == &kSphereSyntax) {
    const double radius = positive("radius", 1.0);
    return scaled(UnitSphere{}, {radius, radius, radius});
  }
  if (&syntax == &kBoxSyntax)
    return scaled(UnitBox{}, sizes());
  if (&syntax == &kSquareSyntax) {
    const double size = positive("size", 1.0);
    return scaled(UnitSquare{}, {size, size, 1.0});
  }
  if (&syntax == &kCylinderSyntax) {
    const double radius = positive("radius", 1.0);
    return scaled(UnitCylinder{.isCapped = isCapped()}, {radius, radius, positive("height", 1.0)});
  }
  return {.shape = ConeShape{.height = positive("height", 1.0),
                             .bottomRadius = amount("bottom_radius", 1.0),
                             .topRadius = amount("top_radius", 0.0),
                             .isCapped = isCapped()},
          .placement = {}};
}

void ShapeReader::readModel(const Value& value, const ObjectReader& object,
                            const Surroundings& around) {
  std::vector<PlacedShape> shapes = models_.shapesOf(object.at("file"), around.material);
  const Affine transform = transformOf(object);
  for (PlacedShape& shape : shapes)
    shape.placement = transform * shape.placement;
  Affine placement = around.placement;
  if (const Value* fit = object.find("fit"))
    placement = placement * readFit(*fit, boundsOf(shapes));
  const Value* name = object.find("name");
  for (PlacedShape& shape : shapes) {
    shape.placement = placement * shape.placement;
    if (name != nullptr)
      shape.name = stringOf(text_, *name, "\"name\"");
    place(value, std::move(shape));
  }
}

/// Scaled evenly, as large as fits; in the middle along x and z, and standing on the floor along y.
Affine ShapeReader::readFit(const Value& value, const Box3& bounds) const {
  const ObjectReader fit(text_, value, kFitSyntax);
  const Vec3d lower = vectorOf(text_, fit.at("lower"), "\"lower\"");
  const Vec3d upper = vectorOf(text_, fit.at("upper"), "\"upper\"");
  const Vec3d room = upper - lower;
  if (!(room.x > 0.0 && room.y > 0.0 && room.z > 0.0)) {
    throw text_.malformed(value.offset, "there is no room in the box of \"fit\"",
                          "Give an \"upper\" that is larger than \"lower\" in all three.");
  }
  if (bounds.isEmpty())
    return {};
  const Vec3d least(bounds.lower);
  const Vec3d size = Vec3d(bounds.upper) - least;
  // A flat model is as small as can be along one axis, and division by zero is no limit there.
  const double scale = std::min({room.x / size.x, room.y / size.y, room.z / size.z});
  const Affine fitted =
      Affine::translation({(lower.x + upper.x) / 2, lower.y, (lower.z + upper.z) / 2}) *
      Affine::scaling({scale, scale, scale}) *
      Affine::translation({-(least.x + size.x / 2), -least.y, -(least.z + size.z / 2)});
  if (!fitted.inverse())
    throw text_.malformed(value.offset, "the model does not fit: it is a point, or endless",
                          "Leave out \"fit\".");
  return fitted;
}

void ShapeReader::place(const Value& value, PlacedShape shape) {
  if (!shape.placement.isFinite() || !shape.placement.inverse()) {
    throw text_.malformed(value.offset, "the transform is singular, or too large or too small",
                          "Look at the transforms of the groups around it, too.");
  }
  placedCount_ += objectCount(shape.shape);
  if (placedCount_ > kMaxPlacedObjectCount) {
    throw Error(ErrorCode::CapacityExceeded,
                "the scene has more than " + std::to_string(kMaxPlacedObjectCount) + " objects",
                "Place large models less often.", text_.placeOf(value.offset));
  }
  scene_.shapes.push_back(std::move(shape));
}

}  // namespace planetree::scene::json_format
