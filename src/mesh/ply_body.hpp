#pragma once

#include "mesh/mesh_input.hpp"
#include "mesh/ply_header.hpp"
#include "support/byte_order.hpp"
#include "support/parse_number.hpp"
#include "support/text_lines.hpp"

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// The records behind a PLY header, value by value. The two bodies have the same functions:
///
///     beginElement(element)     refuses a count that the rest of the file cannot hold
///     mostRecords(element)      an upper bound of that count, to reserve memory by
///     beginRecord(index)        goes to the next record
///     take<Number>(type)        the next value of the record
///     skip(type)
///     requireItems(n, type)     refuses a list that the rest of the record cannot hold
///     tooLargeCount()           how many numbers taken were finite, but not as a Number
///     endRecord(), endFile()    refuse values that the header does not speak of
///
/// All throw `Error` with `MalformedFile`. Nothing is read beyond the file, whatever its header and
/// its lists claim.
namespace planetree::detail {

/// Which record is being read, for errors.
class PlyPlace {
 public:
  explicit PlyPlace(const MeshInput& input) noexcept : input_(&input) {}

  void beginElement(const PlyElement& element) noexcept {
    element_ = &element;
    record_ = 0;
  }
  void beginRecord(std::uint64_t record) noexcept { record_ = record; }

  [[nodiscard]] const MeshInput& input() const noexcept { return *input_; }

  /// "vertex 12"
  [[nodiscard]] std::string record() const;
  /// The file ends before the present record, or within it.
  [[nodiscard]] Error endsBeforeRecord(std::int64_t line) const;
  [[nodiscard]] Error endsWithinRecord(std::int64_t line) const;
  /// The file ends within a list of the present record.
  [[nodiscard]] Error endsWithinList(std::uint64_t count, std::int64_t line) const;

 private:
  [[nodiscard]] Error endsAt(const std::string& where, const std::string& advice,
                             std::int64_t line) const;

  const MeshInput* input_;
  const PlyElement* element_ = nullptr;
  std::uint64_t record_ = 0;
};

class BinaryPlyBody {
 public:
  BinaryPlyBody(const MeshInput& input, std::size_t offset, std::endian order) noexcept
      : place_(input), rest_(input.bytes.subspan(offset)), order_(order) {}

  void beginElement(const PlyElement& element);
  [[nodiscard]] std::uint64_t mostRecords(const PlyElement& element) const noexcept;
  void beginRecord(std::uint64_t record) noexcept { place_.beginRecord(record); }
  void endRecord() const noexcept {}
  void endFile() const;

  template <class Number>
  [[nodiscard]] Number take(PlyType type) {
    const std::byte* const value = takeBytes(byteSize(type));
    switch (type) {
      case PlyType::Int8:
        return static_cast<Number>(loadNumber<std::int8_t>(value, order_));
      case PlyType::UInt8:
        return static_cast<Number>(loadNumber<std::uint8_t>(value, order_));
      case PlyType::Int16:
        return static_cast<Number>(loadNumber<std::int16_t>(value, order_));
      case PlyType::UInt16:
        return static_cast<Number>(loadNumber<std::uint16_t>(value, order_));
      case PlyType::Int32:
        return static_cast<Number>(loadNumber<std::int32_t>(value, order_));
      case PlyType::UInt32:
        return static_cast<Number>(loadNumber<std::uint32_t>(value, order_));
      case PlyType::Float32:
        return static_cast<Number>(loadNumber<float>(value, order_));
      case PlyType::Float64:
        break;
    }
    const auto exact = loadNumber<double>(value, order_);
    const auto number = static_cast<Number>(exact);
    if constexpr (std::floating_point<Number>)
      tooLargeCount_ += std::isinf(number) && !std::isinf(exact) ? 1u : 0u;
    return number;
  }

  void skip(PlyType type) { static_cast<void>(takeBytes(byteSize(type))); }
  void requireItems(std::uint64_t count, PlyType type) const;

  [[nodiscard]] std::uint64_t tooLargeCount() const noexcept { return tooLargeCount_; }
  [[nodiscard]] const PlyPlace& place() const noexcept { return place_; }
  /// Binary files have no lines.
  [[nodiscard]] static constexpr std::int64_t line() noexcept { return Error::kNone; }

 private:
  const std::byte* takeBytes(std::size_t count) {
    if (count > rest_.size())
      throw place_.endsWithinRecord(line());
    const std::byte* const bytes = rest_.data();
    rest_ = rest_.subspan(count);
    return bytes;
  }

  PlyPlace place_;
  std::span<const std::byte> rest_;
  std::endian order_;
  std::uint64_t tooLargeCount_ = 0;
};

/// One record on each line; blank lines do not count.
class AsciiPlyBody {
 public:
  AsciiPlyBody(const MeshInput& input, const TextLines& lines) noexcept
      : place_(input), lines_(lines) {}

  void beginElement(const PlyElement& element) noexcept { place_.beginElement(element); }
  [[nodiscard]] std::uint64_t mostRecords(const PlyElement& element) const noexcept;
  void beginRecord(std::uint64_t record);
  void endRecord();
  void endFile();

  /// The declared type does not matter: all digits of the text are used.
  template <std::integral Number>
  [[nodiscard]] Number take(PlyType) {
    const std::string_view word = takeValue();
    const std::optional<Number> value = parseInteger(word);
    if (!value)
      throw place_.input().notAnInteger(word, line());
    return *value;
  }
  template <std::floating_point Number>
  [[nodiscard]] Number take(PlyType) {
    const std::string_view word = takeValue();
    const std::optional<Number> value = parseNumber<Number>(word);
    if (!value)
      throw place_.input().notANumber(word, line());
    tooLargeCount_ += isTooLarge(word, *value) ? 1u : 0u;
    return *value;
  }

  void skip(PlyType) { static_cast<void>(takeValue()); }
  void requireItems(std::uint64_t count, PlyType) const;

  [[nodiscard]] std::uint64_t tooLargeCount() const noexcept { return tooLargeCount_; }
  [[nodiscard]] const PlyPlace& place() const noexcept { return place_; }
  [[nodiscard]] std::int64_t line() const noexcept { return lines_.number(); }

 private:
  /// Goes to the next line that is not blank; false at the end of the file.
  [[nodiscard]] bool nextLine();
  [[nodiscard]] std::string_view takeValue();

  PlyPlace place_;
  TextLines lines_;
  std::uint64_t tooLargeCount_ = 0;
  std::string_view rest_;  ///< of the present line
};

}  // namespace planetree::detail
