#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace planetree {

/// What kind of thing went wrong; the text of the error says the rest.
enum class ErrorCode : std::uint8_t {
  FileNotReadable,      ///< missing, a folder, no permission; failed or changed meanwhile
  FileNotWritable,      ///< no such folder, no permission, disk full
  UnknownFormat,        ///< the file is none of the formats that are read
  MalformedFile,        ///< the file breaks its own format: truncated, or lying about its counts
  InvalidGeometry,      ///< a mesh or shape list that cannot be used as it was handed over
  InvalidOption,        ///< an option out of its range
  CapacityExceeded,     ///< more objects, references or nodes than the indices can count
  MemoryLimitExceeded,  ///< a build that needs more memory than it may have
  Cancelled,            ///< ended by the caller
};

/// The stable name of a code, for logs and for other languages: "file-not-readable", ...
[[nodiscard]] std::string_view errorCodeName(ErrorCode code) noexcept;

/// Thrown by reading, by building, and by batches; queries of single rays never throw. `what()` is
/// one line made of all the parts: "bunny.ply:12: face 7 has an index beyond the last vertex. Try
/// ...".
class Error : public std::runtime_error {
 public:
  /// The line, face or column of an error that has none.
  static constexpr std::int64_t kNone = -1;

  struct Place {
    std::string file = {};
    std::int64_t line = kNone;    ///< counted from 1; for binary files there is none
    std::int64_t face = kNone;    ///< counted from 0, in the order of the input
    std::int64_t column = kNone;  ///< in bytes, counted from 1; where a line may be long
  };

  /// `problem` says what is wrong, without a full stop; `advice` what to try, as a sentence.
  Error(ErrorCode code, const std::string& problem, std::string advice, Place place);
  Error(ErrorCode code, const std::string& problem, std::string advice)
      : Error(code, problem, std::move(advice), Place{}) {}

  [[nodiscard]] ErrorCode code() const noexcept { return code_; }
  [[nodiscard]] const std::string& file() const noexcept { return place_.file; }
  [[nodiscard]] std::int64_t line() const noexcept { return place_.line; }
  [[nodiscard]] std::int64_t face() const noexcept { return place_.face; }
  [[nodiscard]] std::int64_t column() const noexcept { return place_.column; }
  [[nodiscard]] const std::string& advice() const noexcept { return advice_; }

 private:
  ErrorCode code_;
  Place place_;
  std::string advice_;
};

/// Thrown by a build or a batch that was stopped by the `stopToken` of its control.
class Cancelled : public Error {
 public:
  Cancelled() : Error(ErrorCode::Cancelled, "cancelled", "") {}
};

}  // namespace planetree
