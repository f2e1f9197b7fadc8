#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace planetree::detail {

/// An array of plain values that grows without writing to them: large arrays are filled by all
/// threads, and whoever clears them first pays for every page. What was not written is undefined.
template <class T>
class PlainArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  static_assert(alignof(T) <= alignof(std::max_align_t));

 public:
  PlainArray() = default;
  /// Throws `std::bad_alloc`.
  explicit PlainArray(std::size_t size) { resize(size); }
  PlainArray(PlainArray&& other) noexcept { swap(other); }
  PlainArray& operator=(PlainArray&& other) noexcept {
    PlainArray(std::move(other)).swap(*this);
    return *this;
  }
  ~PlainArray() { std::free(data_); }

  [[nodiscard]] T* data() noexcept { return data_; }
  [[nodiscard]] const T* data() const noexcept { return data_; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// How large it can get without moving.
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  [[nodiscard]] std::span<T> values() noexcept { return {data_, size_}; }
  [[nodiscard]] std::span<const T> values() const noexcept { return {data_, size_}; }
  [[nodiscard]] std::span<T> from(std::size_t begin) noexcept { return values().subspan(begin); }

  /// Keeps what is there. Memory grows by more than was asked for, and never shrinks. Throws
  /// `std::bad_alloc`, and nothing is changed then.
  void resize(std::size_t size) {
    if (size > capacity_)
      reserve(std::max(size, capacity_ + capacity_ / 2));
    size_ = size;
  }

 private:
  void reserve(std::size_t capacity) {
    if (capacity > std::numeric_limits<std::ptrdiff_t>::max() / sizeof(T))
      throw std::bad_alloc();
    void* const moved = std::realloc(data_, capacity * sizeof(T));
    if (moved == nullptr)
      throw std::bad_alloc();
    data_ = static_cast<T*>(moved);
    capacity_ = capacity;
  }
  void swap(PlainArray& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace planetree::detail
