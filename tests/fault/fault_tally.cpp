#include "fault_tally.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>

namespace planetree::test {
namespace {

class PrintsTally : public testing::Environment {
 public:
  void TearDown() override {
    const FaultTally& tally = faultTally();
    if (tally.injectedCount == 0)
      return;
    std::cout << "faults injected: " << tally.injectedCount << ", lost: " << tally.lostCount
              << ", leaked: " << tally.leakedCount << '\n';
  }
};

[[maybe_unused]] const auto* const environment =
    testing::AddGlobalTestEnvironment(new PrintsTally());

}  // namespace

FaultTally& faultTally() noexcept {
  static FaultTally tally;
  return tally;
}

bool triesEveryFault() noexcept {
  return std::getenv("PLANETREE_EVERY_FAULT") != nullptr;
}

std::vector<std::uint64_t> someOf(std::uint64_t count, std::uint64_t most) {
  constexpr std::uint64_t kEnds = 3;
#ifdef PLANETREE_HAS_SANITIZER
  // They are slow.
  most = std::min<std::uint64_t>(most, 20);
#endif
  const std::uint64_t step = triesEveryFault() || count <= most ? 1 : (count + most - 1) / most;
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t number = 1; number <= count; ++number) {
    if (number % step == 0 || number <= kEnds || number + kEnds > count)
      numbers.push_back(number);
  }
  return numbers;
}

std::size_t openFileCount() {
  const std::filesystem::directory_iterator files("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

void reportLost(const std::string& what) {
  ++faultTally().lostCount;
  ADD_FAILURE() << "lost: " << what;
}

void reportLeak(const std::string& what) {
  ++faultTally().leakedCount;
  ADD_FAILURE() << "leaked: " << what;
}

}  // namespace planetree::test
