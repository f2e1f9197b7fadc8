#include "import/answer_text.hpp"

#include <algorithm>
#include <utility>

namespace planetree::importing {

std::string presentable(const std::string& text) {
  constexpr std::size_t kLongest = 300;
  constexpr unsigned char kDelete = 0x7F;
  std::string line;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool isShown = code > ' ' && code < kDelete;
    if (isShown)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  if (line.size() > kLongest)
    line = line.substr(0, kLongest) + " ...";
  while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
    line.pop_back();
  return line;
}

void RemarkList::add(const std::string& text) {
  ++count_;
  if (remarks_.size() == kKept)
    return;
  std::string remark = presentable(text);
  if (std::find(remarks_.begin(), remarks_.end(), remark) == remarks_.end())
    remarks_.push_back(std::move(remark));
}

Error failureOf(Message& message, const std::string& fileName) {
  const auto kind = static_cast<FailureKind>(message.take<std::uint32_t>());
  const Error::Place place{fileName};
  switch (kind) {
    case FailureKind::UnknownFormat:
      return {ErrorCode::UnknownFormat, "the file is in none of the formats that can be read",
              "Convert it to PLY, STL, OBJ or glTF", place};
    case FailureKind::Malformed:
      return {ErrorCode::MalformedFile, "it cannot be read: " + presentable(message.text()),
              "If the file is whole, convert it to PLY, STL, OBJ or glTF with another program",
              place};
    case FailureKind::OutOfMemory:
      return {ErrorCode::MalformedFile, "reading it takes more memory than so small a file should",
              "If the file is whole, convert it to PLY or STL with another program", place};
    case FailureKind::TooLarge:
      return {ErrorCode::CapacityExceeded, "it has more vertices than 32 bits can count",
              "Divide the model into several files", place};
  }
  throw BrokenMessages("a failure of unknown kind");
}

}  // namespace planetree::importing
