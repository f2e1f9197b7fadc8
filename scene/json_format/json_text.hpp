#pragma once

#include <planetree/error.hpp>

#include <cstddef>
#include <span>
#include <string>

namespace planetree::scene::json_format {

/// The bytes of a scene file, and its name. Both must outlive it.
class JsonText {
 public:
  JsonText(std::span<const std::byte> bytes, const std::string& name) noexcept
      : bytes_(bytes), name_(name) {}

  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// The line and column of a byte. Linear in the offset: for errors.
  [[nodiscard]] Error::Place placeOf(std::size_t offset) const;

  /// An error at that place, to be thrown.
  [[nodiscard]] Error malformed(std::size_t offset, const std::string& problem,
                                std::string advice) const {
    return {ErrorCode::MalformedFile, problem, std::move(advice), placeOf(offset)};
  }

 private:
  std::span<const std::byte> bytes_;
  const std::string& name_;
};

}  // namespace planetree::scene::json_format
