#include "ray_files/csv_ray_reader.hpp"

#include <planetree/error.hpp>

#include "support/parse_number.hpp"
#include "support/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace planetree::tool {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string_view withoutBlanks(std::string_view text) noexcept {
  while (!text.empty() && detail::isBlank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && detail::isBlank(text.back()))
    text.remove_suffix(1);
  return text;
}

/// What a line says: nothing if it is blank or a comment.
std::string_view contentOf(std::string_view line) noexcept {
  const std::string_view content = withoutBlanks(line);
  return content.starts_with('#') ? std::string_view() : content;
}

/// What a field says, be it in quotation marks or not: numbers hold nothing that marks would hide.
std::string_view withoutQuotes(std::string_view field) noexcept {
  const bool isQuoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
  return isQuoted ? withoutBlanks(field.substr(1, field.size() - 2)) : field;
}

/// Cuts the first field off a line, with the comma behind it.
std::string_view takeField(std::string_view& line) noexcept {
  const std::size_t comma = line.find(',');
  const std::string_view field = line.substr(0, comma);
  line.remove_prefix(std::min(line.size(), field.size() + 1));
  return withoutQuotes(withoutBlanks(field));
}

std::size_t countFields(std::string_view line) noexcept {
  return 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
}

/// Looks between other separators too: a line of numbers that are not separated by commas is a
/// mistake to be told, not a header.
bool hasNumber(std::string_view line) noexcept {
  constexpr std::string_view kSeparators = ",; \t\"";
  while (!line.empty()) {
    const std::string_view word = line.substr(0, line.find_first_of(kSeparators));
    if (detail::parseNumber<double>(word))
      return true;
    line.remove_prefix(std::min(line.size(), word.size() + 1));
  }
  return false;
}

/// Where a line stands, for errors.
struct Line {
  const std::string& file;
  std::uint64_t number;
  bool isUnended;  ///< the file ends before the line does

  [[noreturn]] void refuse(const std::string& problem, const std::string& advice) const {
    throw Error(ErrorCode::MalformedFile, problem,
                isUnended ? "The file ends there, it may be incomplete. " + advice : advice,
                {.file = file, .line = static_cast<std::int64_t>(number)});
  }
};

std::string columnsText(std::size_t count) {
  return fmt::format("{} column{}", count, count == 1 ? "" : "s");
}

[[noreturn]] void refuseColumns(const Line& line, std::string_view content,
                                const std::string& expected) {
  const std::size_t count = countFields(content);
  const bool hasOtherSeparators = count == 1 && content.find_first_of("; \t") != content.npos;
  line.refuse(fmt::format("has {} instead of {}", columnsText(count), expected),
              hasOtherSeparators
                  ? "Separate the numbers by commas, as numpy.savetxt does with delimiter=','."
                  : "Give ox,oy,oz,dx,dy,dz on each line, or on each with tMin,tMax besides.");
}

[[noreturn]] void refuseField(const Line& line, std::size_t column, std::string_view field) {
  line.refuse(field.empty()
                  ? fmt::format("column {} is empty", column)
                  : fmt::format("column {}: {} is not a number", column, detail::quoted(field)),
              "Write numbers like -1.5, 2e-3, inf or nan.");
}

template <class T>
Ray<T> parseRay(std::string_view content, std::size_t columnCount, const Line& line) {
  if (countFields(content) != columnCount)
    refuseColumns(line, content, fmt::format("{}", columnCount));
  std::array<T, 8> columns{};
  std::string_view rest = content;
  for (std::size_t i = 0; i < columnCount; ++i) {
    const std::string_view field = takeField(rest);
    const auto number = detail::parseNumber<T>(field);
    if (!number)
      refuseField(line, i + 1, field);
    columns[i] = *number;
  }
  return rayOfColumns(columns.data(), columnCount);
}

detail::TextLines linesOf(const RayBlock& block) noexcept {
  return detail::TextLines(std::as_bytes(std::span(block.bytes)));
}

/// The line that `lines` stands at.
Line placeOf(const detail::TextLines& lines, const RayBlock& block, const std::string& file) {
  return {.file = file,
          .number = block.firstLine + static_cast<std::uint64_t>(lines.number()) - 1,
          .isUnended = lines.remaining() == 0 && block.bytes.back() != '\n'};
}

}  // namespace

CsvRayReader::CsvRayReader(ByteSource source) : source_(std::move(source)) {}

std::optional<double> CsvRayReader::progress() const noexcept {
  if (!source_.size())
    return std::nullopt;
  return static_cast<double>(source_.position()) /
         static_cast<double>(std::max<std::uint64_t>(*source_.size(), 1));
}

bool CsvRayReader::next(RayBlock& block, const KeepsGoing& keepsGoing) {
  while (nextLines(block, keepsGoing)) {
    if (columnCount_ == 0)
      findFirstRay(block);
    block.columnCount = columnCount_;
    if (columnCount_ != 0)
      return true;
  }
  return false;
}

/// Reads whole lines: those that have arrived, up to the size of a block.
bool CsvRayReader::nextLines(RayBlock& block, const KeepsGoing& keepsGoing) {
  bool hasEnded = false;
  std::size_t lineEnd = std::string::npos;
  while (pending_.size() < kBlockBytes) {
    const std::size_t before = pending_.size();
    const bool hasLine = lineEnd != std::string::npos;
    if (hasLine && !source_.isReady())
      break;
    hasEnded = !source_.read(pending_, kBlockBytes - before, keepsGoing);
    if (hasEnded)
      break;
    const std::size_t newline = std::string_view(pending_).substr(before).rfind('\n');
    if (newline != std::string_view::npos)
      lineEnd = before + newline;
  }
  if (hasEnded && !keepsGoing())
    return false;
  if (lineEnd == std::string::npos && !hasEnded) {
    Line{.file = source_.name(), .number = nextLine_, .isUnended = false}.refuse(
        fmt::format("is longer than {} bytes", kBlockBytes),
        "Give rays as lines of numbers, or as a .npy file.");
  }
  const std::size_t size = hasEnded ? pending_.size() : lineEnd + 1;
  block.bytes = pending_.substr(0, size);
  block.firstLine = nextLine_;
  pending_.erase(0, size);
  nextLine_ += static_cast<std::uint64_t>(std::count(block.bytes.begin(), block.bytes.end(), '\n'));
  return size > 0;
}

/// Makes the block begin at the first ray, and tells its number of columns; leaves it be if there
/// is none yet.
void CsvRayReader::findFirstRay(RayBlock& block) {
  if (block.firstLine == 1 && block.bytes.starts_with(kByteOrderMark))
    block.bytes.erase(0, kByteOrderMark.size());
  detail::TextLines lines = linesOf(block);
  for (std::size_t start = 0; lines.next(); start = lines.nextOffset()) {
    const std::string_view content = contentOf(lines.line());
    if (content.empty())
      continue;
    const bool isHeader = !isPastHeader_ && !hasNumber(content);
    isPastHeader_ = true;
    if (isHeader)
      continue;
    const Line line = placeOf(lines, block, source_.name());
    columnCount_ = countFields(content);
    if (columnCount_ != 6 && columnCount_ != 8)
      refuseColumns(line, content, "6 or 8");
    block.firstLine = line.number;
    block.bytes.erase(0, start);
    return;
  }
}

template <class T>
std::vector<Ray<T>> CsvRayReader::decode(const RayBlock& block) const {
  std::vector<Ray<T>> rays;
  detail::TextLines lines = linesOf(block);
  while (lines.next()) {
    const std::string_view content = contentOf(lines.line());
    if (!content.empty())
      rays.push_back(
          parseRay<T>(content, block.columnCount, placeOf(lines, block, source_.name())));
  }
  return rays;
}

std::vector<Rayf> CsvRayReader::decodeFloat(const RayBlock& block) const {
  return decode<float>(block);
}

std::vector<Rayd> CsvRayReader::decodeDouble(const RayBlock& block) const {
  return decode<double>(block);
}

}  // namespace planetree::tool
