#pragma once

#include <cstdint>

/// How much memory the program holds, whoever asked for it.
///
/// The program's `malloc` and its kin, with `mmap` and `munmap`, are replaced by ones that count
/// and then do what they always did. Shared libraries are bound to them too, so all engines are
/// counted by one hook, below their own allocators: a block counts with all its usable bytes, and
/// memory mapped by a library's own allocator with whole pages, touched or not. Not seen are the
/// stacks of threads, what glibc maps for its own use, a block that `realloc` copies from while it
/// copies, `sbrk`, and `mremap`; no engine uses the last two.
namespace planetree::bench {

/// Whether this program counts: not where sanitizers have hooks of their own.
[[nodiscard]] bool heapIsCounted() noexcept;

/// Counts from construction to destruction. Outside of that the hooks cost one load, so that they
/// do not slow the builds that are timed. One at a time.
class HeapCount {
 public:
  HeapCount() noexcept;
  ~HeapCount();
  HeapCount(const HeapCount&) = delete;
  HeapCount& operator=(const HeapCount&) = delete;

  /// Bytes taken and not given back since construction, by all threads; below zero if more was
  /// given back.
  [[nodiscard]] std::int64_t bytes() const noexcept;

  /// The most that `bytes` has been since construction, at least zero. Memory that is mapped to be
  /// cut down to an aligned part of it counts only with this part: the rest was never there to use.
  [[nodiscard]] std::int64_t peakBytes() const noexcept;
};

}  // namespace planetree::bench
