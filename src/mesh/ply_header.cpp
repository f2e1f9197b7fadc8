#include "mesh/ply_header.hpp"

#include "support/parse_number.hpp"

#include <algorithm>
#include <limits>

namespace planetree::detail {
namespace {

constexpr const char* kDamagedHeader = "The header is damaged: export the file again";

class PlyHeaderReader {
 public:
  PlyHeaderReader(const MeshInput& input, TextLines& lines) : input_(input), lines_(lines) {}

  PlyHeader read() {
    readMagic();
    while (nextLine()) {
      const std::string_view keyword = takeWord(rest_);
      if (keyword == "end_header")
        return finish();
      readStatement(keyword);
    }
    throw input_.malformed("the file ends within its header",
                           "The file is truncated: copy it again", lines_.number());
  }

 private:
  bool nextLine() {
    if (!lines_.next())
      return false;
    rest_ = lines_.line();
    return true;
  }

  void readMagic() {
    if (!nextLine() || takeWord(rest_) != "ply")
      throw damaged("the first line is not \"ply\"");
    expectLineEnd();
  }

  void readStatement(std::string_view keyword) {
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info")
      return;
    if (keyword == "format") {
      readFormat();
    } else if (keyword == "element") {
      readElement();
    } else if (keyword == "property") {
      readProperty();
    } else {
      throw damaged("the header has the unknown keyword " + quoted(keyword));
    }
    expectLineEnd();
  }

  void readFormat() {
    const std::string_view encoding = takeWord(rest_);
    const std::string_view version = takeWord(rest_);
    if (hasFormat_)
      throw damaged("the header has two format lines");
    hasFormat_ = true;
    if (encoding == "ascii") {
      header_.encoding = PlyEncoding::Ascii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::BinaryLittleEndian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::BinaryBigEndian;
    } else {
      throw damaged("the format " + quoted(encoding) + " is unknown");
    }
    if (version != "1.0")
      throw damaged("the version " + quoted(version) + " is unknown");
  }

  void readElement() {
    PlyElement element;
    element.name = takeName("element");
    element.line = lines_.number();
    const std::string_view word = takeWord(rest_);
    const std::optional<std::int64_t> count = parseInteger(word);
    if (!count || *count < 0 || *count == std::numeric_limits<std::int64_t>::max()) {
      throw damaged(quoted(word) + " is not a count");
    }
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(std::move(element));
  }

  void readProperty() {
    if (header_.elements.empty())
      throw damaged("the header has a property before any element");
    PlyProperty property;
    std::string_view type = takeWord(rest_);
    if (type == "list") {
      property.countType = takeCountType();
      type = takeWord(rest_);
    }
    property.type = typeOf(type);
    property.name = takeName("property");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType takeCountType() {
    const std::string_view word = takeWord(rest_);
    const PlyType type = typeOf(word);
    if (!isInteger(type))
      throw damaged("a list has a count of type " + quoted(word));
    return type;
  }

  std::string takeName(const std::string& what) {
    const std::string_view name = takeWord(rest_);
    if (name.empty())
      throw damaged("the " + what + " has no name");
    return std::string(name);
  }

  PlyType typeOf(std::string_view name) const {
    if (name == "char" || name == "int8")
      return PlyType::Int8;
    if (name == "uchar" || name == "uint8")
      return PlyType::UInt8;
    if (name == "short" || name == "int16")
      return PlyType::Int16;
    if (name == "ushort" || name == "uint16")
      return PlyType::UInt16;
    if (name == "int" || name == "int32")
      return PlyType::Int32;
    if (name == "uint" || name == "uint32")
      return PlyType::UInt32;
    if (name == "float" || name == "float32")
      return PlyType::Float32;
    if (name == "double" || name == "float64")
      return PlyType::Float64;
    throw damaged("the type " + quoted(name) + " is unknown");
  }

  void expectLineEnd() {
    const std::string_view word = takeWord(rest_);
    if (!word.empty())
      throw damaged(quoted(word) + " is one word too many");
  }

  PlyHeader finish() {
    expectLineEnd();
    if (!hasFormat_)
      throw damaged("the header has no format line");
    return std::move(header_);
  }

  Error damaged(const std::string& problem) const {
    return input_.malformed(problem, kDamagedHeader, lines_.number());
  }

  const MeshInput& input_;
  TextLines& lines_;
  std::string_view rest_;  ///< of the present line
  PlyHeader header_;
  bool hasFormat_ = false;
};

}  // namespace

std::size_t byteSize(PlyType type) noexcept {
  switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
      return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
      return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float32:
      return 4;
    case PlyType::Float64:
      break;
  }
  return 8;
}

bool isInteger(PlyType type) noexcept {
  return type != PlyType::Float32 && type != PlyType::Float64;
}

bool PlyElement::hasLists() const noexcept {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& property) { return property.isList(); });
}

std::size_t PlyElement::leastBinarySize() const noexcept {
  std::size_t size = 0;
  for (const PlyProperty& property : properties) {
    size += byteSize(property.countType.value_or(property.type));
  }
  return size;
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const noexcept {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property)
      return i;
  }
  return std::nullopt;
}

PlyHeader readPlyHeader(const MeshInput& input, TextLines& lines) {
  return PlyHeaderReader(input, lines).read();
}

}  // namespace planetree::detail
