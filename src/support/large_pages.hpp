#pragma once

#include <cstddef>

namespace planetree::detail {

/// Memory in large pages, where the system has them and as far as it fills them: rays jump about in
/// large arrays, and with small pages most jumps also miss the table of addresses.
class LargePages {
 public:
  static constexpr std::size_t kAlignment = 64;

  LargePages() = default;
  /// Throws `std::bad_alloc`.
  explicit LargePages(std::size_t size);
  LargePages(LargePages&& other) noexcept { swap(other); }
  LargePages& operator=(LargePages&& other) noexcept {
    swap(other);
    return *this;
  }
  ~LargePages();

  /// Aligned to `kAlignment`, or null if there is none. Its contents are undefined at first.
  [[nodiscard]] std::byte* data() const noexcept { return data_; }

 private:
  void swap(LargePages& other) noexcept;

  std::byte* data_ = nullptr;
  std::size_t mappedSize_ = 0;  ///< 0 if the memory is from `operator new`
};

}  // namespace planetree::detail
