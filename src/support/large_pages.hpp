#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace planetree::detail {

/// Asks the system to back memory that was not used yet with large pages, where it can: rays jump
/// about in large arrays, and with small pages most jumps also miss the table of addresses.
void adviseLargePages(void* memory, std::size_t size) noexcept;

/// Moves the elements to memory of exactly their size, in large pages if that is worth it.
template <class T>
void settle(std::vector<T>& elements) {
  std::vector<T> settled;
  settled.reserve(elements.size());
  adviseLargePages(settled.data(), settled.capacity() * sizeof(T));
  settled.insert(settled.end(), elements.begin(), elements.end());
  elements = std::move(settled);
}

}  // namespace planetree::detail
