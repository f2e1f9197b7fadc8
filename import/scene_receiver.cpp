#include "import/scene_receiver.hpp"

#include "import/weld_corners.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace planetree::importing {
namespace {

Vec3d takeVector(Message& message) {
  const auto x = message.take<double>();
  const auto y = message.take<double>();
  const auto z = message.take<double>();
  return {x, y, z};
}

/// Takes a list of entries of `kSize` bytes.
template <std::size_t kSize, class Use>
void takeAll(Message& message, const char* fault, const Use& use) {
  if (message.payload.size() % kSize != 0)
    throw BrokenMessages(fault);
  while (!message.payload.empty())
    use();
}

MaterialProperty takeProperty(Message& message) {
  const auto property = message.take<std::uint32_t>();
  if (property >= kMaterialProperties)
    throw BrokenMessages("a material's property of unknown kind");
  return static_cast<MaterialProperty>(property);
}

}  // namespace

SceneReceiver::SceneReceiver(const std::string& fileName) : input_{{}, fileName} {
  report_.format = MeshFormat::Other;
}

void SceneReceiver::receiveAll(MessageReader& messages) {
  while (true) {
    Message message = messages.next();
    if (message.kind == MessageKind::Failure)
      throw failureOf(message, input_.name);
    if (message.kind == MessageKind::End)
      break;
    receive(message);
  }
  endTexture();
  endMesh();
}

void SceneReceiver::receive(Message& message) {
  switch (message.kind) {
    case MessageKind::Format:
      report_.formatName = presentable(message.text());
      break;
    case MessageKind::Remark:
      remarks_.add(message.text());
      break;
    case MessageKind::Texture:
      beginTexture(message);
      break;
    case MessageKind::Texels:
      receiveTexels(message);
      break;
    case MessageKind::Material:
      materials_.emplace_back().name = presentable(message.text());
      break;
    case MessageKind::MaterialValue:
      receiveMaterialValue(message);
      break;
    case MessageKind::MaterialTexture:
      receiveMaterialTexture(message);
      break;
    case MessageKind::Mesh:
      beginMesh();
      break;
    case MessageKind::MeshMaterial:
      receiveMeshMaterial(message);
      break;
    case MessageKind::Vertices:
      receiveVertices(message);
      break;
    case MessageKind::Polygons:
      receivePolygons(message);
      break;
    case MessageKind::Normals:
      receiveNormals(message);
      break;
    case MessageKind::Coordinates:
      receiveCoordinates(message);
      break;
    case MessageKind::Placement:
      receivePlacement(message);
      break;
    case MessageKind::Light:
      receiveLight(message);
      break;
    case MessageKind::Camera:
      receiveCamera(message);
      break;
    case MessageKind::Unread:
      report_.unreadPrimitiveCount += message.take<std::uint64_t>();
      break;
    case MessageKind::Failure:
    case MessageKind::End:
      break;  // not for here: see receiveAll
  }
}

void SceneReceiver::beginTexture(Message& message) {
  endTexture();
  const auto width = message.take<std::uint32_t>();
  const auto height = message.take<std::uint32_t>();
  const std::uint64_t count = std::uint64_t{width} * height;
  if (count == 0 || count > kMaxTexels - promisedTexels_)
    throw BrokenMessages("a texture of impossible size");
  promisedTexels_ += count;
  // Memory is taken as texels come, not as they are promised.
  texture_ = {width, height, {}};
}

void SceneReceiver::receiveTexels(Message& message) {
  if (!texture_)
    throw BrokenMessages("texels without a texture");
  const std::uint64_t count = std::uint64_t{texture_->width} * texture_->height;
  takeAll<3 * sizeof(float)>(message, "a texel has no three colours", [&] {
    if (texture_->texels.size() == count)
      throw BrokenMessages("a texture has too many texels");
    Vec3f texel;
    for (const Axis axis : kAxes) {
      const auto part = message.take<float>();
      texel[axis] = part >= 0.0f ? std::min(part, 1.0f) : 0.0f;
    }
    texture_->texels.push_back(texel);
  });
}

void SceneReceiver::endTexture() {
  if (!texture_)
    return;
  if (texture_->texels.size() != std::uint64_t{texture_->width} * texture_->height)
    throw BrokenMessages("a texture lacks texels");
  textures_.emplace_back(texture_->width, texture_->height, std::move(texture_->texels));
  texture_.reset();
}

ModelMaterial& SceneReceiver::presentMaterial() {
  if (materials_.empty())
    throw BrokenMessages("a property without a material");
  return materials_.back();
}

void SceneReceiver::receiveMaterialValue(Message& message) {
  const MaterialProperty property = takeProperty(message);
  presentMaterial().values[static_cast<std::size_t>(property)] = takeVector(message);
}

void SceneReceiver::receiveMaterialTexture(Message& message) {
  endTexture();
  const MaterialProperty property = takeProperty(message);
  const auto texture = message.take<std::uint32_t>();
  if (texture >= textures_.size())
    throw BrokenMessages("a texture that was not told of");
  presentMaterial().textures[static_cast<std::size_t>(property)] = texture;
}

void SceneReceiver::beginMesh() {
  endMesh();
  mesh_.emplace();
  builder_.emplace(input_, MeshFormat::Other);
  meshMaterial_.reset();
}

scene::MeshShape& SceneReceiver::presentMesh() {
  if (!mesh_)
    throw BrokenMessages("a part of a mesh without a mesh");
  return *mesh_;
}

void SceneReceiver::receiveMeshMaterial(Message& message) {
  static_cast<void>(presentMesh());
  const auto material = message.take<std::uint32_t>();
  if (material >= materials_.size())
    throw BrokenMessages("a material that was not told of");
  meshMaterial_ = material;
}

void SceneReceiver::receiveVertices(Message& message) {
  static_cast<void>(presentMesh());
  takeAll<3 * sizeof(double)>(message, "a vertex has no three coordinates",
                              [&] { builder_->addVertex(takeVector(message)); });
}

void SceneReceiver::receivePolygons(Message& message) {
  static_cast<void>(presentMesh());
  std::vector<std::int64_t> indices;
  polygon_.take(message, [&](const std::vector<std::uint32_t>& corners) {
    indices.assign(corners.begin(), corners.end());
    builder_->addPolygon(indices);
  });
}

void SceneReceiver::receiveNormals(Message& message) {
  scene::MeshShape& mesh = presentMesh();
  takeAll<3 * sizeof(double)>(message, "a normal has no three coordinates",
                              [&] { mesh.normals.push_back(takeVector(message)); });
}

void SceneReceiver::receiveCoordinates(Message& message) {
  scene::MeshShape& mesh = presentMesh();
  takeAll<2 * sizeof(double)>(message, "a texture coordinate is not complete", [&] {
    const auto u = message.take<double>();
    const auto v = message.take<double>();
    mesh.coordinates.push_back({u, v});
  });
}

void SceneReceiver::endMesh() {
  polygon_.requireEnd();
  if (!mesh_)
    return;
  addToReport(builder_->takeReport());
  TriangleMesh<double> triangles = builder_->takeMesh();
  mesh_->positions = std::move(triangles.positions);
  mesh_->faces = std::move(triangles.faces);
  const std::size_t count = mesh_->positions.size();
  if ((!mesh_->normals.empty() && mesh_->normals.size() != count) ||
      (!mesh_->coordinates.empty() && mesh_->coordinates.size() != count))
    throw BrokenMessages("a mesh has more or fewer normals or coordinates than vertices");
  // A mesh whose faces share their vertices has fewer vertices than faces.
  if (count > mesh_->faces.size())
    weldCorners(*mesh_);
  meshes_.push_back({std::make_shared<const scene::MeshShape>(std::move(*mesh_)), meshMaterial_});
  mesh_.reset();
  builder_.reset();
}

void SceneReceiver::addToReport(const MeshReadReport& part) {
  constexpr std::size_t kNamedSkips = 16;
  for (SkippedPolygon skipped : part.skipped) {
    if (report_.skipped.size() == kNamedSkips)
      break;
    skipped.polygon += report_.polygonCount;
    report_.skipped.push_back(std::move(skipped));
  }
  report_.polygonCount += part.polygonCount;
  report_.skippedPolygonCount += part.skippedPolygonCount;
}

void SceneReceiver::receivePlacement(Message& message) {
  endMesh();
  const auto mesh = message.take<std::uint32_t>();
  std::array<Vec3d, 4> columns;
  static_assert(3 * columns.size() == kPlacementNumbers);
  for (Vec3d& column : columns)
    column = takeVector(message);
  if (mesh >= meshes_.size())
    throw BrokenMessages("a placement of a mesh that was not told of");
  const scene::Affine placement(columns[0], columns[1], columns[2], columns[3]);
  std::string name = presentable(message.text());
  if (!placement.isFinite() || !placement.inverse()) {
    ownRemarks_.add("left out, for its placement makes it flat or infinite: the part " + name);
    return;
  }
  placements_.push_back({mesh, placement, std::move(name)});
}

void SceneReceiver::receiveLight(Message& message) {
  const auto kind = message.take<std::uint32_t>();
  if (kind > static_cast<std::uint32_t>(LightKind::PhotometricSpot))
    throw BrokenMessages("a light of unknown kind");
  ModelLight light;
  light.kind = static_cast<LightKind>(kind);
  light.position = takeVector(message);
  light.direction = takeVector(message);
  light.colour = takeVector(message);
  light.attenuation = takeVector(message);
  lights_.push_back(light);
}

void SceneReceiver::receiveCamera(Message& message) {
  ModelCamera camera;
  camera.position = takeVector(message);
  camera.direction = takeVector(message);
  camera.up = takeVector(message);
  camera.angleAcross = message.take<double>();
  camera.aspect = message.take<double>();
  const std::optional<scene::View> view = viewOf(camera);
  if (!view)
    ownRemarks_.add("a camera with impossible numbers is left out");
  // The first one is the file's own view.
  if (!view_)
    view_ = view;
}

std::uint32_t SceneReceiver::clayIndex(scene::SceneDescription& scene) {
  if (!clay_) {
    clay_ = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(clay());
  }
  return *clay_;
}

scene::SceneDescription SceneReceiver::takeScene() {
  scene::SceneDescription scene;
  for (const ModelMaterial& material : materials_)
    scene.materials.push_back(translateMaterial(material, textures_));
  scene.textures = std::move(textures_);
  for (PlacedMesh& placed : placements_) {
    const Mesh& mesh = meshes_[placed.mesh];
    if (mesh.shape->faces.empty())
      continue;
    scene.shapes.push_back({.shape = mesh.shape,
                            .placement = placed.placement,
                            .material = mesh.material ? *mesh.material : clayIndex(scene),
                            .name = std::move(placed.name)});
  }
  scene.view = view_;
  scene.remarks = remarks_.remarks();
  for (const std::string& remark : ownRemarks_.remarks())
    scene.remarks.push_back(remark);
  addLights(lights_, scene);
  return scene;
}

ImportReport SceneReceiver::takeReport() {
  report_.remarks = remarks_.remarks();
  report_.remarkCount = remarks_.count();
  return std::move(report_);
}

}  // namespace planetree::importing
