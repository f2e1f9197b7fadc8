#include "mesh/mesh_readers.hpp"
#include "support/parse_number.hpp"
#include "support/text_lines.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Rost, "OFF - a 3D object file format", 1986, and Geomview's additions to it, of which colours,
// normals and texture coordinates are passed over.
//
// Why not assimp, which reads this format too? Of its version 5.2.5 we found that, with no more
// than a line in its log, it takes an index beyond the last vertex for the last vertex, leaves out
// polygons with ten corners and more, and puts missing vertices at the origin.

namespace planetree::detail {
namespace {

constexpr const char* kCopyAgain = "The file is truncated or damaged: copy or export it again";
constexpr const char* kExportAgain = "The file is damaged or not written well: export it again";

bool takePrefix(std::string_view& word, std::string_view prefix) noexcept {
  const bool hasPrefix = word.starts_with(prefix);
  if (hasPrefix)
    word.remove_prefix(prefix.size());
  return hasPrefix;
}

/// "OFF", with letters before it for what the vertices have beside a position, in this order.
bool isHeader(std::string_view word) noexcept {
  for (const std::string_view part : {"ST", "C", "N", "4", "n"})
    takePrefix(word, part);
  return word == "OFF";
}

/// The records of a file: its lines, without comments and blank ones.
class OffRecords {
 public:
  explicit OffRecords(std::span<const std::byte> text) noexcept : lines_(text) {}

  /// Goes to the next record; false at the end.
  [[nodiscard]] bool next() noexcept {
    while (lines_.next()) {
      rest_ = lines_.line().substr(0, lines_.line().find('#'));
      if (hasMore())
        return true;
    }
    return false;
  }

  /// The next word of the record; empty at its end.
  [[nodiscard]] std::string_view take() noexcept { return takeWord(rest_); }
  [[nodiscard]] bool hasMore() const noexcept {
    return !std::all_of(rest_.begin(), rest_.end(), isBlank);
  }
  [[nodiscard]] std::int64_t line() const noexcept { return lines_.number(); }
  /// Bytes behind the present record.
  [[nodiscard]] std::size_t remaining() const noexcept { return lines_.remaining(); }

 private:
  TextLines lines_;
  std::string_view rest_;
};

template <std::floating_point T>
class OffReader {
 public:
  OffReader(const MeshInput& input, MeshBuilder<T>& builder)
      : input_(input), records_(input.bytes), builder_(builder) {}

  void read() {
    readHeader();
    readCounts();
    builder_.reserveVertices(mostRecords(vertexCount_));
    for (std::uint64_t vertex = 0; vertex < vertexCount_; ++vertex)
      readVertex(vertex);
    builder_.reserveTriangles(mostRecords(faceCount_));
    for (std::uint64_t face = 0; face < faceCount_; ++face)
      readFace(face);
    if (records_.next()) {
      throw input_.malformed("the file goes on behind the last face that its header promises",
                             kExportAgain, records_.line());
    }
  }

 private:
  void readHeader() {
    static_cast<void>(records_.next());
    const std::string_view word = records_.take();
    if (word.find_first_of("4n") != std::string_view::npos)
      throw unread("its vertices have another number of coordinates than three");
  }

  /// The counts stand behind the header or in the next line; that of the edges means nothing.
  void readCounts() {
    if (!records_.hasMore())
      static_cast<void>(records_.next());
    std::string_view word = records_.take();
    if (word == "BINARY")
      throw unread("it is a binary OFF file");
    vertexCount_ = count(word, "vertices");
    faceCount_ = count(records_.take(), "faces");
  }

  std::uint64_t count(std::string_view word, const std::string& what) const {
    if (word.empty())
      throw input_.malformed("the number of " + what + " is missing", kCopyAgain, records_.line());
    const std::int64_t number = integer(word);
    if (number < 0) {
      throw input_.malformed("the number of " + what + " is " + std::string(word), kExportAgain,
                             records_.line());
    }
    return static_cast<std::uint64_t>(number);
  }

  void readVertex(std::uint64_t index) {
    beginRecord("vertex", "vertices", index, vertexCount_);
    Vec3<T> position;
    for (const Axis axis : kAxes) {
      const std::string_view word = require(records_.take(), "vertex", index);
      const std::optional<T> number = parseNumber<T>(word);
      if (!number)
        throw input_.notANumber(word, records_.line());
      if (isTooLarge(word, *number))
        builder_.countTooLarge(1);
      position[axis] = *number;
    }
    builder_.addVertex(position);
  }

  /// The number of corners, the corners, and perhaps a colour.
  void readFace(std::uint64_t index) {
    beginRecord("face", "faces", index, faceCount_);
    const std::uint64_t cornerCount = count(records_.take(), "corners");
    corners_.clear();
    for (std::uint64_t corner = 0; corner < cornerCount; ++corner)
      corners_.push_back(integer(require(records_.take(), "face", index)));
    builder_.addPolygon(corners_, records_.line());
  }

  void beginRecord(const std::string& name, const std::string& plural, std::uint64_t index,
                   std::uint64_t promised) {
    if (records_.next())
      return;
    throw input_.malformed("the header promises " + std::to_string(promised) + " " +
                               (promised == 1 ? name : plural) + ", but the file ends before " +
                               name + " " + std::to_string(index),
                           kCopyAgain, records_.line());
  }

  std::string_view require(std::string_view word, const std::string& name,
                           std::uint64_t index) const {
    if (!word.empty())
      return word;
    throw input_.malformed("the line has too few values for " + name + " " + std::to_string(index),
                           kCopyAgain, records_.line());
  }

  std::int64_t integer(std::string_view word) const {
    const std::optional<std::int64_t> number = parseInteger(word);
    if (!number)
      throw input_.notAnInteger(word, records_.line());
    return *number;
  }

  Error unread(const std::string& what) const {
    return input_.malformed(what, "Convert it to PLY, STL or OBJ", records_.line());
  }

  /// What is promised, but no more than the file can hold: a record has three digits, each with a
  /// blank or line end.
  std::size_t mostRecords(std::uint64_t promised) const noexcept {
    constexpr std::size_t kLeastRecord = 6;
    const std::uint64_t most = records_.remaining() / kLeastRecord + 1;
    return static_cast<std::size_t>(std::min(promised, most));
  }

  const MeshInput& input_;
  OffRecords records_;
  MeshBuilder<T>& builder_;
  std::uint64_t vertexCount_ = 0;
  std::uint64_t faceCount_ = 0;
  std::vector<std::int64_t> corners_;  ///< of the face at hand
};

}  // namespace

bool isOff(std::span<const std::byte> bytes) noexcept {
  OffRecords records(bytes);
  return records.next() && isHeader(records.take());
}

template <std::floating_point T>
void readOff(const MeshInput& input, MeshBuilder<T>& builder) {
  OffReader<T>(input, builder).read();
}

template void readOff<float>(const MeshInput&, MeshBuilder<float>&);
template void readOff<double>(const MeshInput&, MeshBuilder<double>&);

}  // namespace planetree::detail
