#include "mesh/ply_body.hpp"

#include <algorithm>

namespace planetree::detail {
namespace {

constexpr const char* kCopyAgain = "The file is truncated: copy it again";
constexpr const char* kExportAgain = "The file is damaged or not written well: export it again";

/// "35947 vertices"
std::string countOf(const PlyElement& element) {
  const std::string count = std::to_string(element.count) + " ";
  if (element.name == "vertex")
    return count + (element.count == 1 ? "vertex" : "vertices");
  if (element.name == "face")
    return count + (element.count == 1 ? "face" : "faces");
  return count + "records of " + quoted(element.name);
}

}  // namespace

std::string PlyPlace::record() const {
  const bool isUsual = element_->name == "vertex" || element_->name == "face";
  const std::string name = isUsual ? element_->name : "record";
  return name + " " + std::to_string(record_);
}

Error PlyPlace::endsBeforeRecord(std::int64_t line) const {
  return endsAt("before " + record(), kCopyAgain, line);
}

Error PlyPlace::endsWithinRecord(std::int64_t line) const {
  return endsAt("within " + record(), kCopyAgain, line);
}

Error PlyPlace::endsWithinList(std::uint64_t count, std::int64_t line) const {
  return endsAt("within " + record() + ", in a list of " + std::to_string(count) + " values",
                "The file is truncated or damaged: copy or export it again", line);
}

Error PlyPlace::endsAt(const std::string& where, const std::string& advice,
                       std::int64_t line) const {
  return input_->malformed(
      "the header promises " + countOf(*element_) + ", but the file ends " + where, advice, line);
}

void BinaryPlyBody::beginElement(const PlyElement& element) {
  place_.beginElement(element);
  if (element.hasLists() || element.properties.empty())
    return;
  const std::uint64_t most = mostRecords(element);
  if (element.count <= most)
    return;
  place_.beginRecord(most);
  const bool endsWithin = rest_.size() % element.leastBinarySize() != 0;
  throw endsWithin ? place_.endsWithinRecord(line()) : place_.endsBeforeRecord(line());
}

std::uint64_t BinaryPlyBody::mostRecords(const PlyElement& element) const noexcept {
  return rest_.size() / std::max<std::size_t>(element.leastBinarySize(), 1);
}

void BinaryPlyBody::requireItems(std::uint64_t count, PlyType type) const {
  if (count > rest_.size() / byteSize(type))
    throw place_.endsWithinList(count, line());
}

void BinaryPlyBody::endFile() const {
  // A line end behind the last record does no harm, and some programs write one.
  const bool hasMore = std::any_of(rest_.begin(), rest_.end(), [](std::byte byte) {
    return byte != std::byte{'\n'} && byte != std::byte{'\r'};
  });
  if (!hasMore)
    return;
  throw place_.input().malformed("there are " + std::to_string(rest_.size()) +
                                     " bytes behind the last record that the header promises",
                                 kExportAgain);
}

std::uint64_t AsciiPlyBody::mostRecords(const PlyElement& element) const noexcept {
  // Each value takes a digit and a blank or line end, but for the very last one.
  return (lines_.remaining() + 1) / (2 * std::max<std::size_t>(element.properties.size(), 1));
}

void AsciiPlyBody::beginRecord(std::uint64_t record) {
  place_.beginRecord(record);
  if (!nextLine())
    throw place_.endsBeforeRecord(line());
}

void AsciiPlyBody::endRecord() {
  const std::string_view word = takeWord(rest_);
  if (word.empty())
    return;
  throw place_.input().malformed(quoted(word) + " is one value too many for " + place_.record(),
                                 kExportAgain, line());
}

void AsciiPlyBody::endFile() {
  if (!nextLine())
    return;
  throw place_.input().malformed("the file goes on behind the last record that the header promises",
                                 kExportAgain, line());
}

void AsciiPlyBody::requireItems(std::uint64_t count, PlyType) const {
  // A blank and a digit for each.
  if (count <= rest_.size() / 2)
    return;
  throw place_.input().malformed(
      place_.record() + " has a list of " + std::to_string(count) + " values, more than its line",
      kExportAgain, line());
}

bool AsciiPlyBody::nextLine() {
  while (lines_.next()) {
    rest_ = lines_.line();
    if (!std::all_of(rest_.begin(), rest_.end(), isBlank))
      return true;
  }
  return false;
}

std::string_view AsciiPlyBody::takeValue() {
  const std::string_view word = takeWord(rest_);
  if (!word.empty())
    return word;
  if (lines_.remaining() == 0)
    throw place_.endsWithinRecord(line());
  throw place_.input().malformed("the line has too few values for " + place_.record(), kExportAgain,
                                 line());
}

}  // namespace planetree::detail
