#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace planetree::test {

/// Faults that this program has made, over all of its tests. Printed when they have run.
struct FaultTally {
  std::uint64_t injectedCount = 0;
  std::uint64_t lostCount = 0;    ///< nobody was told, or something else, or it was not over then
  std::uint64_t leakedCount = 0;  ///< something was still held afterwards
};

[[nodiscard]] FaultTally& faultTally() noexcept;

/// The numbers from 1 to `count`: about `most` of them, the first and the last ones included, or
/// all, if the variable PLANETREE_EVERY_FAULT of the environment says so.
[[nodiscard]] std::vector<std::uint64_t> someOf(std::uint64_t count, std::uint64_t most);

[[nodiscard]] bool triesEveryFault() noexcept;

/// How many files this process has open.
[[nodiscard]] std::size_t openFileCount();

/// A fault that was not told as it should be.
void reportLost(const std::string& what);
/// Something that is still held after a fault.
void reportLeak(const std::string& what);

}  // namespace planetree::test
