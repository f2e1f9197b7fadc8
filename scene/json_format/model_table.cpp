#include "scene/json_format/model_table.hpp"

#include "scene/json_format/texture_table.hpp"
#include "scene/json_format/value_reader.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>

namespace planetree::scene::json_format {

namespace {

using MeshPointer = std::shared_ptr<const MeshShape>;

void shift(std::optional<std::uint32_t>& texture, std::uint32_t first) noexcept {
  if (texture)
    *texture += first;
}

Material withTexturesFrom(Material material, std::uint32_t first) {
  for (ColourSource* source : {&material.emissive, &material.ambient, &material.diffuse,
                               &material.specular, &material.reflective, &material.transmissive})
    shift(source->texture, first);
  shift(material.index.texture, first);
  shift(material.shininess.texture, first);
  return material;
}

bool hasMaterials(const MeshShape& mesh) noexcept {
  return !mesh.vertexMaterials.empty() || !mesh.faceMaterials.empty();
}

MeshPointer withMaterialsFrom(const MeshPointer& mesh, std::uint32_t first) {
  if (first == 0 || mesh == nullptr || !hasMaterials(*mesh))
    return mesh;
  auto shifted = std::make_shared<MeshShape>(*mesh);
  for (auto* list : {&shifted->vertexMaterials, &shifted->faceMaterials}) {
    for (std::uint32_t& material : *list)
      material += first;
  }
  return shifted;
}

/// Corners of a box that the shape lies in, or its vertices.
std::vector<Vec3d> outline(const ShapeDescription& shape) {
  if (const auto* mesh = std::get_if<MeshPointer>(&shape))
    return *mesh == nullptr ? std::vector<Vec3d>() : (*mesh)->positions;
  const auto [lower, upper] = std::visit(
      [](const auto& kind) -> std::pair<Vec3d, Vec3d> {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Kind, UnitBox>)
          return {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
        if constexpr (std::is_same_v<Kind, UnitSquare>)
          return {{-0.5, -0.5, 0.0}, {0.5, 0.5, 0.0}};
        if constexpr (std::is_same_v<Kind, UnitCylinder>)
          return {{-1.0, -1.0, 0.0}, {1.0, 1.0, 1.0}};
        if constexpr (std::is_same_v<Kind, ConeShape>) {
          const double r = std::max(std::fabs(kind.bottomRadius), std::fabs(kind.topRadius));
          return {{-r, -r, 0.0}, {r, r, kind.height}};
        }
        return {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
      },
      shape);
  std::vector<Vec3d> corners;
  for (const double x : {lower.x, upper.x}) {
    for (const double y : {lower.y, upper.y}) {
      for (const double z : {lower.z, upper.z})
        corners.push_back({x, y, z});
    }
  }
  return corners;
}

}  // namespace

std::vector<PlacedShape> ModelTable::shapesOf(const Value& value,
                                              std::optional<std::uint32_t> material) {
  std::vector<PlacedShape> shapes = read(value);
  if (!material)
    return shapes;
  for (PlacedShape& shape : shapes) {
    shape.material = *material;
    auto* mesh = std::get_if<MeshPointer>(&shape.shape);
    if (mesh == nullptr || *mesh == nullptr || !hasMaterials(**mesh))
      continue;
    MeshPointer& plain = plainMeshes_[mesh->get()];
    if (plain == nullptr) {
      auto copy = std::make_shared<MeshShape>(**mesh);
      copy->vertexMaterials.clear();
      copy->faceMaterials.clear();
      plain = std::move(copy);
    }
    *mesh = plain;
  }
  return shapes;
}

const std::vector<PlacedShape>& ModelTable::read(const Value& value) {
  const std::filesystem::path path = filePathOf(text_, value, folder_, "\"file\"");
  const auto [entry, isNew] = models_.try_emplace(path.string());
  if (!isNew)
    return entry->second;
  if (!readers_.model) {
    throw text_.malformed(value.offset, "models cannot be read here",
                          "Give shapes alone, or a reader of models.");
  }
  SceneDescription model;
  try {
    model = readers_.model(path);
  } catch (const Error& error) {
    throw errorOfFile(text_, value, "the model", error);
  }
  const auto firstTexture = static_cast<std::uint32_t>(scene_.textures.size());
  const auto firstMaterial = static_cast<std::uint32_t>(scene_.materials.size());
  std::ranges::move(model.textures, std::back_inserter(scene_.textures));
  std::ranges::move(model.remarks, std::back_inserter(scene_.remarks));
  for (Material& material : model.materials)
    scene_.materials.push_back(withTexturesFrom(std::move(material), firstTexture));
  for (PlacedShape& shape : model.shapes) {
    shape.material += firstMaterial;
    if (auto* mesh = std::get_if<MeshPointer>(&shape.shape))
      *mesh = withMaterialsFrom(*mesh, firstMaterial);
  }
  entry->second = std::move(model.shapes);
  return entry->second;
}

Box3 boundsOf(const std::vector<PlacedShape>& shapes) {
  Box3 box;
  for (const PlacedShape& shape : shapes) {
    for (const Vec3d& point : outline(shape.shape)) {
      const Vec3d placed = shape.placement.point(point);
      if (std::isfinite(placed.x) && std::isfinite(placed.y) && std::isfinite(placed.z))
        box.extend(placed);
    }
  }
  return box;
}

}  // namespace planetree::scene::json_format
