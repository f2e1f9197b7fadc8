#include <planetree/error.hpp>

namespace planetree {
namespace {

std::string describe(const std::string& problem, const std::string& advice,
                     const Error::Place& place) {
  std::string text = place.file;
  if (place.line != Error::kNone) {
    text += text.empty() ? "line " : ":";
    text += std::to_string(place.line);
    if (place.column != Error::kNone) {
      text += ':';
      text += std::to_string(place.column);
    }
  }
  if (!text.empty())
    text += ": ";
  if (place.face != Error::kNone) {
    text += "face ";
    text += std::to_string(place.face);
    text += ": ";
  }
  text += problem;
  if (!advice.empty()) {
    text += ". ";
    text += advice;
  }
  return text;
}

}  // namespace

std::string_view errorCodeName(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::FileNotReadable:
      return "file-not-readable";
    case ErrorCode::FileNotWritable:
      return "file-not-writable";
    case ErrorCode::UnknownFormat:
      return "unknown-format";
    case ErrorCode::MalformedFile:
      return "malformed-file";
    case ErrorCode::InvalidGeometry:
      return "invalid-geometry";
    case ErrorCode::InvalidOption:
      return "invalid-option";
    case ErrorCode::CapacityExceeded:
      return "capacity-exceeded";
    case ErrorCode::MemoryLimitExceeded:
      return "memory-limit-exceeded";
    case ErrorCode::Cancelled:
      return "cancelled";
  }
  return "unknown";
}

Error::Error(ErrorCode code, const std::string& problem, std::string advice, Place place)
    : std::runtime_error(describe(problem, advice, place)),
      code_(code),
      place_(std::move(place)),
      advice_(std::move(advice)) {}

}  // namespace planetree
