#include "mesh/mesh_readers.hpp"
#include "support/parse_number.hpp"
#include "support/text_lines.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Wavefront Technologies, "Advanced Visualizer manual, appendix B1: object files (.obj)",
// version 3.
//
// Why not tinyobjloader, which reads this format in many programs? Of its version 2.0.0rc10 we
// found that, without a word, it takes what is no number for 0, cuts vertex indices to 32 bits, so
// that 4294967297 becomes vertex 1, and does not round decimals to nearest ("0.3" becomes
// 0.30000000000000004); that it fails at a comment behind a face; and that it takes more than twice
// as long. Vertices and polygons are all we want.

namespace planetree::detail {
namespace {

constexpr const char* kExportAgain = "The file is damaged or not written well: export it again";

template <std::size_t N>
constexpr bool isOneOf(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr bool isPolygon(std::string_view keyword) noexcept {
  return keyword == "f" || keyword == "fo";
}

/// Things to be seen that are no polygons.
constexpr bool isOtherPrimitive(std::string_view keyword) noexcept {
  constexpr std::array<std::string_view, 8> kWords = {"p",   "l",   "curv", "surf",
                                                      "bsp", "bzp", "cdc",  "cdp"};
  return isOneOf(kWords, keyword);
}

/// Texts that run to the end of the line and may have any character.
constexpr bool isTextual(std::string_view keyword) noexcept {
  constexpr std::array<std::string_view, 9> kWords = {
      "g", "o", "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj", "call"};
  return isOneOf(kWords, keyword) || keyword.starts_with('#');
}

/// Records that do not change the shape of polygons.
constexpr bool isAttribute(std::string_view keyword) noexcept {
  constexpr std::array<std::string_view, 23> kWords = {
      "vn",   "vt",    "vp",       "s",        "mg",   "cstype", "deg",  "bmat",
      "step", "curv2", "parm",     "trim",     "hole", "scrv",   "sp",   "end",
      "con",  "bevel", "c_interp", "d_interp", "lod",  "ctech",  "stech"};
  return isOneOf(kWords, keyword);
}

constexpr bool includesOtherFiles(std::string_view keyword) noexcept {
  return keyword == "call" || keyword == "csh";
}

constexpr bool isKeyword(std::string_view word) noexcept {
  return word == "v" || isPolygon(word) || isOtherPrimitive(word) || isAttribute(word) ||
         isTextual(word) || includesOtherFiles(word);
}

/// The records of a file. One that ends with a backslash goes on in the next line, unless it is a
/// text: a comment may well end with the name of a folder.
class ObjRecords {
 public:
  explicit ObjRecords(std::span<const std::byte> text) noexcept : lines_(text) {}

  /// Goes to the next record that is not blank; false at the end.
  bool next() {
    while (lines_.next()) {
      number_ = lines_.number();
      rest_ = lines_.line();
      keyword_ = takeWord(rest_);
      if (keyword_.empty())
        continue;
      if (endsWithBackslash(lines_.line()) && !isTextual(keyword_))
        joinLines();
      return true;
    }
    return false;
  }

  [[nodiscard]] std::string_view keyword() const noexcept { return keyword_; }
  /// Of the first line of the record.
  [[nodiscard]] std::int64_t line() const noexcept { return number_; }

  /// The next word behind the keyword; empty at the end, which may be a comment.
  [[nodiscard]] std::string_view take() noexcept {
    const std::string_view word = takeWord(rest_);
    if (word.starts_with('#'))
      rest_ = {};
    return word.starts_with('#') ? std::string_view() : word;
  }

 private:
  static bool endsWithBackslash(std::string_view line) noexcept {
    while (!line.empty() && isBlank(line.back()))
      line.remove_suffix(1);
    return line.ends_with('\\');
  }

  void joinLines() {
    joined_.clear();
    bool goesOn = true;
    while (goesOn) {
      const std::string_view line = lines_.line();
      goesOn = endsWithBackslash(line);
      joined_ += goesOn ? line.substr(0, line.rfind('\\')) : line;
      joined_ += ' ';
      goesOn = goesOn && lines_.next();
    }
    rest_ = joined_;
    keyword_ = takeWord(rest_);
  }

  TextLines lines_;
  std::int64_t number_ = 0;
  std::string_view keyword_;
  std::string_view rest_;
  std::string joined_;
};

/// Reads in two passes, vertices before polygons, since a polygon may refer to later vertices.
template <std::floating_point T>
class ObjReader {
 public:
  ObjReader(const MeshInput& input, MeshBuilder<T>& builder) : input_(input), builder_(builder) {}

  void read() {
    for (ObjRecords records(input_.bytes); records.next();) {
      if (records.keyword() == "v")
        readVertex(records);
    }
    for (ObjRecords records(input_.bytes); records.next();)
      readOther(records);
  }

 private:
  void readVertex(ObjRecords& record) {
    Vec3<T> position;
    for (const Axis axis : kAxes)
      position[axis] = takeNumber(record);
    // A weight, or a colour: of no use here, but they show whether the line is sound.
    for (std::string_view word = record.take(); !word.empty(); word = record.take()) {
      if (!parseNumber<T>(word))
        throw input_.notANumber(word, record.line());
    }
    builder_.addVertex(position);
  }

  T takeNumber(ObjRecords& record) const {
    const std::string_view word = record.take();
    if (word.empty()) {
      throw input_.malformed("the vertex has fewer than three coordinates", kExportAgain,
                             record.line());
    }
    const std::optional<T> number = parseNumber<T>(word);
    if (!number)
      throw input_.notANumber(word, record.line());
    if (isTooLarge(word, *number))
      builder_.countTooLarge(1);
    return *number;
  }

  void readOther(ObjRecords& record) {
    const std::string_view keyword = record.keyword();
    if (keyword == "v") {
      ++vertexCount_;
    } else if (isPolygon(keyword)) {
      readPolygon(record);
    } else if (isOtherPrimitive(keyword)) {
      builder_.countUnread(1);
    } else if (includesOtherFiles(keyword)) {
      throw input_.malformed("it includes another file with " + quoted(keyword),
                             "Put both files into one", record.line());
    } else if (!isKeyword(keyword)) {
      throw input_.malformed("the keyword " + quoted(keyword) + " is unknown",
                             "Take the line out, or export the file again", record.line());
    }
  }

  void readPolygon(ObjRecords& record) {
    corners_.clear();
    for (std::string_view word = record.take(); !word.empty(); word = record.take()) {
      const std::int64_t written = vertexIndex(word, record.line());
      // Counted from 1, or backwards from the last vertex so far, which is -1.
      const std::int64_t index = written > 0 ? written - 1 : vertexCount_ + written;
      const bool exists = written != 0 && index >= 0 &&
                          static_cast<std::uint64_t>(index) < builder_.positions().size();
      if (!exists)
        return builder_.skipPolygon(missingVertexReason(written), record.line());
      corners_.push_back(index);
    }
    builder_.addPolygon(corners_, record.line());
  }

  /// The first number of "7", "7/8", "7//9" or "7/8/9"; the others are texture and normal.
  std::int64_t vertexIndex(std::string_view corner, std::int64_t line) const {
    const std::size_t slash = std::min(corner.find('/'), corner.size());
    const std::optional<std::int64_t> index = parseInteger(corner.substr(0, slash));
    const bool isSound = corner.find_first_not_of("0123456789-+/", slash) == std::string_view::npos;
    if (!index || !isSound) {
      throw input_.malformed(quoted(corner) + " is not a corner of a face", kExportAgain, line);
    }
    return *index;
  }

  const MeshInput& input_;
  MeshBuilder<T>& builder_;
  std::int64_t vertexCount_ = 0;       ///< before the record at hand
  std::vector<std::int64_t> corners_;  ///< of the polygon at hand
};

}  // namespace

bool isObj(std::span<const std::byte> bytes) noexcept {
  TextLines lines(bytes);
  bool hasComments = false;
  while (lines.next()) {
    std::string_view line = lines.line();
    const std::string_view keyword = takeWord(line);
    if (keyword.starts_with('#')) {
      hasComments = true;
    } else if (!keyword.empty()) {
      // Many keywords are one letter, so a letter alone is no proof; a group may be without name.
      const bool isWhole = keyword == "g" || !takeWord(line).empty();
      return isWhole && isKeyword(keyword);
    }
  }
  return hasComments;
}

template <std::floating_point T>
void readObj(const MeshInput& input, MeshBuilder<T>& builder) {
  ObjReader<T>(input, builder).read();
}

template void readObj<float>(const MeshInput&, MeshBuilder<float>&);
template void readObj<double>(const MeshInput&, MeshBuilder<double>&);

}  // namespace planetree::detail
