#include "mesh/mesh_readers.hpp"
#include "mesh/ply_body.hpp"
#include "mesh/ply_header.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// Turk, "The PLY polygon file format", 1994, and the files that people have. Beyond the text: both
// spellings of the types and of the vertex list, and the triangle strips of early scanners.

namespace planetree::detail {
namespace {

constexpr const char* kExportAgain = "Export the file again as a mesh";

const PlyElement* findElement(const PlyHeader& header, const std::string& name,
                              const MeshInput& input) {
  const PlyElement* found = nullptr;
  for (const PlyElement& element : header.elements) {
    if (element.name != name)
      continue;
    if (found) {
      throw input.malformed("the header has a second element " + name, kExportAgain, element.line);
    }
    found = &element;
  }
  return found;
}

/// For each property of the vertices the axis it is the coordinate of, or none.
std::vector<std::optional<Axis>> coordinateAxes(const PlyElement& vertex, const MeshInput& input) {
  std::vector<std::optional<Axis>> axes(vertex.properties.size());
  for (const Axis axis : kAxes) {
    const std::optional<std::size_t> found = vertex.find(axisName(axis));
    if (!found || vertex.properties[*found].isList()) {
      throw input.malformed(std::string("the vertices have no coordinate ") + axisName(axis),
                            kExportAgain, vertex.line);
    }
    axes[*found] = axis;
  }
  return axes;
}

/// The position of the list of vertex indices among the properties.
std::size_t findCornerList(const PlyElement& element, const MeshInput& input) {
  std::optional<std::size_t> found = element.find("vertex_indices");
  if (!found)
    found = element.find("vertex_index");
  if (!found || !element.properties[*found].isList() ||
      !isInteger(element.properties[*found].type)) {
    throw input.malformed("the element " + element.name + " has no list of integers vertex_indices",
                          kExportAgain, element.line);
  }
  return *found;
}

template <std::floating_point T, class Body>
class PlyBodyReader {
 public:
  PlyBodyReader(const PlyHeader& header, Body body, MeshBuilder<T>& builder)
      : header_(header), body_(std::move(body)), builder_(builder) {}

  void read() {
    for (const PlyElement& element : header_.elements) {
      if (element.count == 0)
        continue;
      body_.beginElement(element);
      if (element.name == "vertex") {
        readVertices(element);
      } else if (element.name == "face") {
        readFaces(element);
      } else if (element.name == "tristrips") {
        readStrips(element);
      } else {
        skipElement(element);
      }
    }
    body_.endFile();
    builder_.countTooLarge(body_.tooLargeCount());
  }

 private:
  void readVertices(const PlyElement& vertex) {
    const std::vector<std::optional<Axis>> axes = coordinateAxes(vertex, body_.place().input());
    builder_.reserveVertices(mostRecords(vertex));
    for (std::uint64_t record = 0; record < vertex.count; ++record) {
      body_.beginRecord(record);
      Vec3<T> position;
      for (std::size_t i = 0; i < axes.size(); ++i) {
        const PlyProperty& property = vertex.properties[i];
        if (axes[i]) {
          position[*axes[i]] = body_.template take<T>(property.type);
        } else {
          skip(property);
        }
      }
      body_.endRecord();
      builder_.addVertex(position);
    }
  }

  void readFaces(const PlyElement& face) {
    builder_.reserveTriangles(mostRecords(face));
    readCornerLists(face, [&] { builder_.addPolygon(corners_, body_.line()); });
  }

  /// A strip is a run of triangles that share their sides; each is a polygon of its own.
  void readStrips(const PlyElement& strips) {
    readCornerLists(strips, [&] { addStrips(); });
  }

  void addStrips() {
    constexpr std::int64_t kStripEnd = -1;
    auto begin = corners_.begin();
    while (begin != corners_.end()) {
      const auto end = std::find(begin, corners_.end(), kStripEnd);
      addStrip({begin, end});
      begin = end == corners_.end() ? end : end + 1;
    }
  }

  void addStrip(std::span<const std::int64_t> strip) {
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
      // Every other triangle of a strip is turned over.
      const std::size_t turn = i % 2;
      builder_.addPolygon(
          std::array<std::int64_t, 3>{strip[i + turn], strip[i + 1 - turn], strip[i + 2]},
          body_.line());
    }
  }

  /// Reads each record of an element and calls `use` with its vertex indices in `corners_`.
  template <class Use>
  void readCornerLists(const PlyElement& element, const Use& use) {
    const std::size_t cornerList = findCornerList(element, body_.place().input());
    for (std::uint64_t record = 0; record < element.count; ++record) {
      body_.beginRecord(record);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i == cornerList) {
          takeCorners(element.properties[i]);
        } else {
          skip(element.properties[i]);
        }
      }
      body_.endRecord();
      use();
    }
  }

  void takeCorners(const PlyProperty& list) {
    const std::uint64_t count = takeItemCount(list);
    corners_.resize(count);
    for (std::int64_t& corner : corners_)
      corner = body_.template take<std::int64_t>(list.type);
  }

  std::uint64_t takeItemCount(const PlyProperty& list) {
    const auto count = body_.template take<std::int64_t>(*list.countType);
    if (count < 0) {
      throw body_.place().input().malformed(
          body_.place().record() + " has a list of " + std::to_string(count) + " values",
          "The file is damaged: copy or export it again", body_.line());
    }
    body_.requireItems(static_cast<std::uint64_t>(count), list.type);
    return static_cast<std::uint64_t>(count);
  }

  void skipElement(const PlyElement& element) {
    // Without properties there are no bytes to skip, however many records are promised.
    if (element.properties.empty())
      return;
    for (std::uint64_t record = 0; record < element.count; ++record) {
      body_.beginRecord(record);
      for (const PlyProperty& property : element.properties)
        skip(property);
      body_.endRecord();
    }
  }

  void skip(const PlyProperty& property) {
    const std::uint64_t count = property.isList() ? takeItemCount(property) : 1;
    for (std::uint64_t i = 0; i < count; ++i)
      body_.skip(property.type);
  }

  /// How many records to make room for: what is promised, but no more than the file can hold.
  std::size_t mostRecords(const PlyElement& element) const {
    return static_cast<std::size_t>(std::min(element.count, body_.mostRecords(element)));
  }

  const PlyHeader& header_;
  Body body_;
  MeshBuilder<T>& builder_;
  std::vector<std::int64_t> corners_;  ///< of the record at hand
};

template <std::floating_point T, class Body>
void readBody(const PlyHeader& header, Body body, MeshBuilder<T>& builder) {
  PlyBodyReader<T, Body>(header, std::move(body), builder).read();
}

}  // namespace

template <std::floating_point T>
void readPly(const MeshInput& input, MeshBuilder<T>& builder) {
  TextLines lines(input.bytes);
  const PlyHeader header = readPlyHeader(input, lines);
  const PlyElement* const vertex = findElement(header, "vertex", input);
  if (!vertex) {
    throw input.malformed("the header has no element vertex", kExportAgain, lines.number());
  }
  static_cast<void>(findElement(header, "face", input));
  builder.announceVertices(vertex->count);
  switch (header.encoding) {
    case PlyEncoding::Ascii:
      return readBody(header, AsciiPlyBody(input, lines), builder);
    case PlyEncoding::BinaryLittleEndian:
      return readBody(header, BinaryPlyBody(input, lines.nextOffset(), std::endian::little),
                      builder);
    case PlyEncoding::BinaryBigEndian:
      return readBody(header, BinaryPlyBody(input, lines.nextOffset(), std::endian::big), builder);
  }
}

template void readPly<float>(const MeshInput&, MeshBuilder<float>&);
template void readPly<double>(const MeshInput&, MeshBuilder<double>&);

}  // namespace planetree::detail
