#pragma once

#include <cstdint>
#include <stop_token>

/// Memory that runs out when a test says so.
///
/// The program has `new` and `delete` of its own, and the linker leads the calls of `malloc`,
/// `realloc`, `free`, `mmap` and `munmap` in planetree's libraries here. What oneTBB and the C
/// library ask for on their own account is neither counted nor refused: tasks, threads, buffers of
/// streams. They take it from pools that stay when a build is over, so that its requests differ
/// from run to run, and what becomes of a task that oneTBB cannot make is not for us to mend.
namespace planetree::test {

/// What is held at a time.
struct HeldMemory {
  std::int64_t blockCount = 0;
  std::int64_t mappedBytes = 0;

  friend bool operator==(const HeldMemory&, const HeldMemory&) = default;
};

[[nodiscard]] HeldMemory heldMemory() noexcept;

enum class FaultKind : std::uint8_t {
  None,        ///< requests are only counted
  One,         ///< one request fails
  FromThenOn,  ///< it fails, and all behind it
};

/// While it lives, requests for memory are counted from 1, in all threads, and those from `first`
/// on fail as `kind` says. There may be one at a time.
class MemoryFaults {
 public:
  MemoryFaults(FaultKind kind, std::uint64_t first) noexcept;
  /// Nothing fails, but the request with that number asks for a stop.
  MemoryFaults(std::stop_source& source, std::uint64_t number) noexcept;
  MemoryFaults(const MemoryFaults&) = delete;
  MemoryFaults& operator=(const MemoryFaults&) = delete;
  ~MemoryFaults() { end(); }

  /// No request is counted from here on.
  static void end() noexcept;
  [[nodiscard]] static std::uint64_t requestCount() noexcept;
  [[nodiscard]] static std::uint64_t failedCount() noexcept;
};

}  // namespace planetree::test
