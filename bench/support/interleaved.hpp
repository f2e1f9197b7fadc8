#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace planetree::bench {

/// The seconds on the wall that `work` takes.
template <class Work>
[[nodiscard]] double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The least that `measure(i)` gives for each i below `count`, out of this many rounds. Each round
/// measures all of them, and begins with another one: what else happens on the machine, and what
/// one leaves in the caches for the next, then strikes all alike.
[[nodiscard]] inline std::vector<double> bestOfRounds(
    std::size_t count, unsigned rounds, const std::function<double(std::size_t)>& measure) {
  std::vector<double> best(count, std::numeric_limits<double>::infinity());
  for (unsigned round = 0; round < rounds; ++round) {
    for (std::size_t turn = 0; turn < count; ++turn) {
      const std::size_t i = (turn + round) % count;
      best[i] = std::min(best[i], measure(i));
    }
  }
  return best;
}

}  // namespace planetree::bench
