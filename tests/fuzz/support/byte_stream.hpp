#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

namespace planetree::fuzz {

/// Makes values out of the bytes of an input. There are always enough: behind the last one come
/// zeros, so that every input means something.
class ByteStream {
 public:
  ByteStream(const std::uint8_t* data, std::size_t size) noexcept
      : rest_(std::as_bytes(std::span(data, size))) {}

  [[nodiscard]] bool isEmpty() const noexcept { return rest_.empty(); }
  [[nodiscard]] std::span<const std::byte> rest() const noexcept { return rest_; }
  [[nodiscard]] std::string_view text() const noexcept {
    return {reinterpret_cast<const char*>(rest_.data()), rest_.size()};
  }

  /// The next number, bit by bit.
  template <class Number>
  [[nodiscard]] Number take() noexcept {
    static_assert(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>);
    Number number{};
    const std::size_t count = std::min(sizeof(Number), rest_.size());
    if (count > 0)
      std::memcpy(&number, rest_.data(), count);
    rest_ = rest_.subspan(count);
    return number;
  }

  [[nodiscard]] std::uint8_t takeByte() noexcept { return take<std::uint8_t>(); }
  /// A number below `end`, which is no more than 256.
  [[nodiscard]] unsigned takeBelow(unsigned end) noexcept { return takeByte() % end; }

 private:
  std::span<const std::byte> rest_;
};

}  // namespace planetree::fuzz
