#pragma once

#include "mesh/mesh_input.hpp"
#include "support/text_lines.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::detail {

enum class PlyEncoding : std::uint8_t { Ascii, BinaryLittleEndian, BinaryBigEndian };

enum class PlyType : std::uint8_t {
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64,
};

[[nodiscard]] std::size_t byteSize(PlyType type) noexcept;
[[nodiscard]] bool isInteger(PlyType type) noexcept;

/// One value of each record of an element, or a list of values with a count before it.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;                  ///< of the value, or of the items of the list
  std::optional<PlyType> countType = std::nullopt;  ///< lists have one

  [[nodiscard]] bool isList() const noexcept { return countType.has_value(); }
};

/// A kind of record, such as vertex or face, and how many of them the file holds.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< as the header claims; nothing is checked yet
  std::int64_t line = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] bool hasLists() const noexcept;
  /// The fewest bytes a record takes: all of it without lists, the counts of the lists with them.
  [[nodiscard]] std::size_t leastBinarySize() const noexcept;
  /// Position of a property; nothing if there is none of that name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const noexcept;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
};

/// Reads the header up to and with "end_header", which is then the present line of `lines`. What
/// the elements mean is not looked at. Throws `Error`.
[[nodiscard]] PlyHeader readPlyHeader(const MeshInput& input, TextLines& lines);

}  // namespace planetree::detail
