#include "scene/ray_format/mesh_reader.hpp"

#include "support/parse_number.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace planetree::scene::ray_format {

std::shared_ptr<const MeshShape> MeshReader::read(
    const Token& mesh, const std::function<bool(const Token&)>& readCommon) {
  tokens_.block(blockNamed(mesh.text), [&](const Token& keyword) {
    if (!readCommon(keyword))
      readEntry(keyword);
  });
  requireCorners(mesh);
  requireCount(mesh_.normals.size(), normals_, "normals");
  requireCount(mesh_.vertexMaterials.size(), materialList_, "materials");
  requireCount(mesh_.coordinates.size(), coordinates_, "texture coordinates");
  if (mesh_.faces.empty())
    tokens_.remark(mesh.place, "the mesh has no faces");
  if (generatesNormals_) {
    if (normals_)
      tokens_.remark(*generatesNormals_, "\"gennormals\" takes the place of the given normals");
    generateNormals();
  }
  return std::make_shared<const MeshShape>(std::move(mesh_));
}

void MeshReader::readEntry(const Token& keyword) {
  if (keyword.text == "gennormals") {
    generatesNormals_ = keyword.place;
    return;
  }
  tokens_.expectEquals(keyword);
  if (keyword.text == "points") {
    tokens_.list("points", [&] { mesh_.positions.push_back(tokens_.vector()); });
    pointCount_ = mesh_.positions.size();
  } else if (keyword.text == "faces") {
    beforeFaces_ = tokens_;
    readFaces(tokens_);
  } else if (keyword.text == "normals") {
    normals_ = keyword.place;
    tokens_.list("normals", [&] { mesh_.normals.push_back(tokens_.vector()); });
  } else if (keyword.text == "materials") {
    materialList_ = keyword.place;
    tokens_.list("materials",
                 [&] { mesh_.vertexMaterials.push_back(materials_.read(tokens_, material_)); });
  } else {
    coordinates_ = keyword.place;
    tokens_.list("texture coordinates", [&] { mesh_.coordinates.push_back(tokens_.twoNumbers()); });
  }
}

void MeshReader::readFaces(TokenReader& tokens) {
  tokens.list("faces", [&] { readFace(tokens); });
}

void MeshReader::readFace(TokenReader& tokens) {
  const Token begin = tokens.peek();
  FaceIndices fan = {};
  std::size_t cornerCount = 0;
  tokens.list("the corners of a face", [&] {
    const std::uint32_t corner = readCorner(tokens);
    largestCorner_ = std::max(largestCorner_, corner);
    if (cornerCount == 0)
      fan[0] = corner;
    fan[1] = std::exchange(fan[2], corner);
    ++cornerCount;
    if (cornerCount > 2)
      mesh_.faces.push_back(fan);
  });
  if (cornerCount < 3) {
    throw tokens.malformed(
        begin.place,
        "expected a face of three corners or more, found one of " + std::to_string(cornerCount),
        "Leave it out, or add the corners that are missing");
  }
}

std::uint32_t MeshReader::readCorner(TokenReader& tokens) const {
  constexpr const char* kAdvice = "Corners are counted from 0 in the order of the points";
  const Token& token = tokens.peek();
  if (token.kind != TokenKind::Number)
    throw tokens.unexpected(token, "the number of a point", kAdvice);
  const std::optional<std::int64_t> index = planetree::detail::parseInteger(token.text);
  if (!index)
    throw tokens.unexpected(token, "the number of a point, which is whole", kAdvice);
  if (*index < 0)
    throw tokens.unexpected(token, "the number of a point, which is not negative", kAdvice);
  if (pointCount_ && std::cmp_greater_equal(*index, *pointCount_)) {
    throw tokens.unexpected(
        token, "the number of one of the " + std::to_string(*pointCount_) + " points", kAdvice);
  }
  tokens.take();
  // What is cut off here is out of range whatever the number of points: see requireCorners.
  constexpr auto kLargest = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min<std::int64_t>(*index, kLargest));
}

/// For faces that stand before the points, or without.
void MeshReader::requireCorners(const Token& mesh) {
  if (mesh_.positions.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(
        ErrorCode::CapacityExceeded, "the mesh has more than 4294967295 points",
        "Divide it into several",
        Error::Place{
            .file = tokens_.fileName(), .line = mesh.place.line, .column = mesh.place.column});
  }
  pointCount_ = mesh_.positions.size();
  if (mesh_.faces.empty() || largestCorner_ < *pointCount_)
    return;
  TokenReader again = *beforeFaces_;
  readFaces(again);
}

void MeshReader::requireCount(std::size_t count, const std::optional<TextPlace>& place,
                              const std::string& what) const {
  if (!place || count == mesh_.positions.size())
    return;
  throw tokens_.malformed(*place,
                          "expected as many " + what + " as points, which are " +
                              std::to_string(mesh_.positions.size()) + ", found " +
                              std::to_string(count),
                          "Each point takes one, in the order of the points");
}

/// The sums of the unit normals of the triangles around each point, of unit length again.
void MeshReader::generateNormals() {
  mesh_.normals.assign(mesh_.positions.size(), {0, 0, 0});
  for (const FaceIndices& face : mesh_.faces) {
    const Vec3d& a = mesh_.positions[face[0]];
    const Vec3d normal =
        normalized(cross(mesh_.positions[face[1]] - a, mesh_.positions[face[2]] - a));
    if (!isFinite(normal))
      continue;
    for (const std::uint32_t corner : face)
      mesh_.normals[corner] = mesh_.normals[corner] + normal;
  }
  for (Vec3d& normal : mesh_.normals)
    normal = normalized(normal);
}

}  // namespace planetree::scene::ray_format
