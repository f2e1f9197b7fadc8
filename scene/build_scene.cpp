#include "scene/build_scene.hpp"

#include "scene/shape_groups.hpp"

#include <planetree/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace planetree::scene {

namespace {

Vec3d product(const Vec3d& a, const Vec3d& b) noexcept {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// A place on an image.
struct TexturePlace {
  double u = 0.0;
  double v = 0.0;
  TextureEdges edges = TextureEdges::Clamped;
};

/// The place, the materials and the weights of a hit: what the surface there is made of.
struct SurfaceMaterial {
  TexturePlace place;
  std::array<std::uint32_t, 3> materials{};  ///< the first alone, unless the weights say more
  std::array<double, 3> weights{1.0, 0.0, 0.0};
};

Vec3d colourAt(const ColourSource& source, const std::vector<Texture>& textures,
               const TexturePlace& place) noexcept {
  if (!source.texture)
    return source.value;
  return product(source.value, textures[*source.texture].at(place.u, place.v, place.edges));
}

double numberAt(const NumberSource& source, const std::vector<Texture>& textures,
                const TexturePlace& place) noexcept {
  if (!source.texture)
    return source.value;
  // The weights of the `.ray` format: those of NTSC, as in ITU-R BT.601.
  const Vec3d colour(textures[*source.texture].at(place.u, place.v, place.edges));
  return source.value * dot(colour, {0.299, 0.587, 0.114});
}

MaterialSample sampled(const Material& material, const std::vector<Texture>& textures,
                       const TexturePlace& place) noexcept {
  const auto colour = [&](const ColourSource& source) { return colourAt(source, textures, place); };
  return {.emissive = colour(material.emissive),
          .ambient = colour(material.ambient),
          .diffuse = colour(material.diffuse),
          .specular = colour(material.specular),
          .reflective = colour(material.reflective),
          .transmissive = colour(material.transmissive),
          .index = numberAt(material.index, textures, place),
          .shininess = numberAt(material.shininess, textures, place)};
}

void addWeighted(MaterialSample& sum, const MaterialSample& sample, double weight) noexcept {
  sum.emissive = sum.emissive + sample.emissive * weight;
  sum.ambient = sum.ambient + sample.ambient * weight;
  sum.diffuse = sum.diffuse + sample.diffuse * weight;
  sum.specular = sum.specular + sample.specular * weight;
  sum.reflective = sum.reflective + sample.reflective * weight;
  sum.transmissive = sum.transmissive + sample.transmissive * weight;
  sum.index += sample.index * weight;
  sum.shininess += sample.shininess * weight;
}

bool isZero(const Vec3d& v) noexcept {
  return v == Vec3d{0, 0, 0};
}

/// The images that a material takes values from.
std::array<std::optional<std::uint32_t>, 8> texturesOf(const Material& material) noexcept {
  return {material.emissive.texture, material.ambient.texture,    material.diffuse.texture,
          material.specular.texture, material.reflective.texture, material.transmissive.texture,
          material.index.texture,    material.shininess.texture};
}

bool hasTexture(const Material& material) noexcept {
  return std::ranges::any_of(texturesOf(material),
                             [](const auto& texture) { return texture.has_value(); });
}

/// Readers keep this; a description made by hand may not.
void checkReferences(const SceneDescription& scene) {
  const auto check = [](bool isRight, const std::string& problem) {
    if (!isRight)
      throw Error(ErrorCode::InvalidGeometry, problem, "Give indices within the lists.");
  };
  const auto checkTexture = [&](const std::optional<std::uint32_t>& texture) {
    check(!texture || *texture < scene.textures.size(), "a material names a missing texture");
  };
  for (const Material& material : scene.materials)
    std::ranges::for_each(texturesOf(material), checkTexture);
  if (scene.background) {
    for (const std::uint32_t texture : scene.background->textures)
      checkTexture(texture);
  }
  const auto checkMaterial = [&](std::uint32_t material) {
    check(material < scene.materials.size(), "a shape names a missing material");
  };
  for (const PlacedShape& shape : scene.shapes) {
    checkMaterial(shape.material);
    const auto* pointer = std::get_if<std::shared_ptr<const MeshShape>>(&shape.shape);
    if (pointer == nullptr)
      continue;
    check(*pointer != nullptr, "a mesh is missing");
    const MeshShape& mesh = **pointer;
    const auto hasOneEach = [](std::size_t count, std::size_t of) {
      return count == 0 || count == of;
    };
    check(hasOneEach(mesh.normals.size(), mesh.positions.size()) &&
              hasOneEach(mesh.coordinates.size(), mesh.positions.size()) &&
              hasOneEach(mesh.vertexMaterials.size(), mesh.positions.size()) &&
              hasOneEach(mesh.faceMaterials.size(), mesh.faces.size()),
          "a mesh has lists of different lengths");
    std::ranges::for_each(mesh.vertexMaterials, checkMaterial);
    std::ranges::for_each(mesh.faceMaterials, checkMaterial);
  }
}

}  // namespace

struct BuiltScene::Parts {
  std::shared_ptr<const SceneDescription> description;
  std::vector<ShapeGroup> groups;
  KdTree<AnyObject<float>> tree;
  std::vector<bool> isTextured;  ///< for each material
  bool hasTransparency = false;

  [[nodiscard]] const PlacedShape& shapeAt(const Hitf& hit) const noexcept {
    return description->shapes[groups[hit.geometry].shapeOf(hit.primitive)];
  }
  [[nodiscard]] SurfaceMaterial surfaceMaterial(const PlacedShape& shape, const Rayf& ray,
                                                const Hitf& hit) const;
  [[nodiscard]] Vec3d normal(const PlacedShape& shape, const Rayf& ray, const Hitf& hit,
                             bool isSmooth) const;
};

namespace {

Vec3d positionOf(const Rayf& ray, const Hitf& hit) noexcept {
  return Vec3d(ray.origin) + Vec3d(ray.direction) * static_cast<double>(hit.t);
}

const MeshShape* meshOf(const PlacedShape& shape) noexcept {
  const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&shape.shape);
  return mesh == nullptr ? nullptr : mesh->get();
}

/// The weights of the corners of a face as its mesh has them: mirrored, two have changed places.
std::array<double, 3> cornerWeights(const PlacedShape& shape, const Hitf& hit) noexcept {
  double second = static_cast<double>(hit.u);
  double third = static_cast<double>(hit.v);
  if (shape.placement.determinant() < 0.0)
    std::swap(second, third);
  return {1.0 - second - third, second, third};
}

bool isTwoSided(const PlacedShape& shape) noexcept {
  if (const MeshShape* mesh = meshOf(shape))
    return mesh->isTwoSided;
  if (const auto* cone = std::get_if<ConeShape>(&shape.shape))
    return !cone->isCapped;
  if (const auto* cylinder = std::get_if<UnitCylinder>(&shape.shape))
    return !cylinder->isCapped;
  return std::holds_alternative<UnitSquare>(shape.shape);
}

TexturePlace placeOnMesh(const PlacedShape& shape, const MeshShape& mesh,
                         const Hitf& hit) noexcept {
  TexturePlace place{.edges = TextureEdges::Repeated};
  if (mesh.coordinates.empty())
    return place;
  const std::array<double, 3> weights = cornerWeights(shape, hit);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<double, 2>& corner = mesh.coordinates[mesh.faces[hit.primitive][i]];
    place.u += weights[i] * corner[0];
    place.v += weights[i] * corner[1];
  }
  return place;
}

TexturePlace placeOn(const PlacedShape& shape, const Rayf& ray, const Hitf& hit) noexcept {
  if (const MeshShape* mesh = meshOf(shape))
    return placeOnMesh(shape, *mesh, hit);
  TexturePlace place{.u = static_cast<double>(hit.u), .v = static_cast<double>(hit.v)};
  if (std::holds_alternative<UnitSquare>(shape.shape))
    return place;
  // The other parameters of a hit are those of the placed shape, which may have been turned.
  const Vec3d local = shape.placement.inverse().value_or(Affine()).point(positionOf(ray, hit));
  if (std::holds_alternative<UnitBox>(shape.shape)) {
    const BoxPlace onBox = placeOnUnitBox(local, hit.primitive);
    return {.u = onBox.u, .v = onBox.v};
  }
  constexpr double kTurn = 6.283185307179586;
  place.edges = TextureEdges::Wrapped;
  const double longitude = std::atan2(local.y, local.x) / kTurn;
  place.u = longitude < 0.0 ? longitude + 1.0 : longitude;
  if (std::holds_alternative<UnitSphere>(shape.shape))
    place.v = std::atan2(std::hypot(local.x, local.y), -local.z) / (kTurn / 2);
  return place;
}

}  // namespace

SurfaceMaterial BuiltScene::Parts::surfaceMaterial(const PlacedShape& shape, const Rayf& ray,
                                                   const Hitf& hit) const {
  SurfaceMaterial surface;
  surface.materials.fill(shape.material);
  if (const MeshShape* mesh = meshOf(shape)) {
    if (!mesh->faceMaterials.empty())
      surface.materials.fill(mesh->faceMaterials[hit.primitive]);
    if (!mesh->vertexMaterials.empty()) {
      for (std::size_t i = 0; i < 3; ++i)
        surface.materials[i] = mesh->vertexMaterials[mesh->faces[hit.primitive][i]];
      surface.weights = cornerWeights(shape, hit);
    }
  }
  // Only images ask where on a surface they are, and on a sphere the answer takes a while.
  if (std::ranges::any_of(surface.materials,
                          [&](std::uint32_t material) { return isTextured[material]; }))
    surface.place = placeOn(shape, ray, hit);
  return surface;
}

Vec3d BuiltScene::Parts::normal(const PlacedShape& shape, const Rayf& ray, const Hitf& hit,
                                bool isSmooth) const {
  Vec3d normal(hit.normal);
  const MeshShape* mesh = meshOf(shape);
  if (isSmooth && mesh != nullptr && !mesh->normals.empty()) {
    const FaceIndices& face = mesh->faces[hit.primitive];
    const std::array<double, 3> weights = cornerWeights(shape, hit);
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i)
      sum = sum + mesh->normals[face[i]] * weights[i];
    const Vec3d carried = normalized(shape.placement.normal(sum));
    if (std::isfinite(carried.x) && std::isfinite(carried.y) && std::isfinite(carried.z) &&
        !isZero(carried))
      normal = carried;
  }
  if (!isTwoSided(shape))
    return normal;
  // The side is that of the face: an interpolated normal may look away near an outline.
  const bool comesFromBehind = dot(Vec3d(hit.normal), Vec3d(ray.direction)) > 0.0;
  const bool looksBehind = dot(normal, Vec3d(hit.normal)) < 0.0;
  return comesFromBehind != looksBehind ? -normal : normal;
}

BuiltScene::BuiltScene(SceneDescription description, const BuildOptions& options,
                       const BuildControl& control)
    : BuiltScene(std::make_shared<const SceneDescription>(std::move(description)), options,
                 control) {}

BuiltScene::BuiltScene(std::shared_ptr<const SceneDescription> description,
                       const BuildOptions& options, const BuildControl& control) {
  checkReferences(*description);
  GroupedShapes shapes = groupShapes(*description);
  auto parts = std::make_unique<Parts>();
  parts->tree = buildTree(shapes.scene, options, control);
  parts->groups = std::move(shapes.groups);
  for (const Material& material : description->materials)
    parts->isTextured.push_back(hasTexture(material));
  parts->hasTransparency =
      std::ranges::any_of(description->materials, [](const Material& material) {
        return material.transmissive.texture || !isZero(material.transmissive.value);
      });
  parts->description = std::move(description);
  parts_ = std::move(parts);
}

BuiltScene::BuiltScene(BuiltScene&&) noexcept = default;
BuiltScene& BuiltScene::operator=(BuiltScene&&) noexcept = default;
BuiltScene::~BuiltScene() = default;

const KdTree<AnyObject<float>>& BuiltScene::tree() const noexcept {
  return parts_->tree;
}

const SceneDescription& BuiltScene::description() const noexcept {
  return *parts_->description;
}

SurfacePoint BuiltScene::surface(const Rayf& ray, const Hitf& hit, bool isSmooth) const {
  const PlacedShape& shape = parts_->shapeAt(hit);
  SurfacePoint point{.position = positionOf(ray, hit),
                     .normal = parts_->normal(shape, ray, hit, isSmooth),
                     .material = {}};
  const SurfaceMaterial surface = parts_->surfaceMaterial(shape, ray, hit);
  const std::vector<Texture>& textures = parts_->description->textures;
  const auto sample = [&](std::size_t corner) {
    const Material& material = parts_->description->materials[surface.materials[corner]];
    return sampled(material, textures, surface.place);
  };
  if (surface.weights[0] == 1.0) {
    point.material = sample(0);
  } else {
    point.material.index = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      addWeighted(point.material, sample(i), surface.weights[i]);
  }
  return point;
}

Vec3d BuiltScene::transmission(const Rayf& ray, const Hitf& hit) const {
  const PlacedShape& shape = parts_->shapeAt(hit);
  const SurfaceMaterial surface = parts_->surfaceMaterial(shape, ray, hit);
  Vec3d sum{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    if (surface.weights[i] == 0.0)
      continue;
    const Material& material = parts_->description->materials[surface.materials[i]];
    sum = sum + colourAt(material.transmissive, parts_->description->textures, surface.place) *
                    surface.weights[i];
  }
  return sum;
}

bool BuiltScene::hasTransparency() const noexcept {
  return parts_->hasTransparency;
}

Vec3d BuiltScene::background(const Vec3d& direction) const noexcept {
  const auto& cube = parts_->description->background;
  if (!cube || isZero(direction))
    return {0, 0, 0};
  // Cube maps are left-handed: what one sees along -z is `posz`.
  const Vec3d d{direction.x, direction.y, -direction.z};
  const Vec3d size{std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)};
  const auto look = [&](std::size_t side, double right, double up, double depth) {
    const Texture& texture = parts_->description->textures[cube->textures[side]];
    return texture.at(0.5 + 0.5 * right / depth, 0.5 + 0.5 * up / depth, TextureEdges::Clamped);
  };
  if (size.x >= size.y && size.x >= size.z)
    return d.x > 0.0 ? look(0, -d.z, d.y, size.x) : look(1, d.z, d.y, size.x);
  if (size.y >= size.z)
    return d.y > 0.0 ? look(2, d.x, -d.z, size.y) : look(3, d.x, d.z, size.y);
  return d.z > 0.0 ? look(4, d.x, d.y, size.z) : look(5, -d.x, d.y, size.z);
}

}  // namespace planetree::scene
