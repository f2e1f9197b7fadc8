#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace planetree::bench {

/// Calls `work(begin, end)` for pieces of [0, count) on this many threads, the caller's among them.
/// Plain threads, not oneTBB: no engine is to find its own scheduler warmed up by the benchmark.
template <class Work>
void parallelFor(std::size_t count, std::size_t pieceSize, unsigned threadCount, const Work& work) {
  if (threadCount <= 1) {
    work(std::size_t{0}, count);
    return;
  }
  std::atomic<std::size_t> next = 0;
  const auto takePieces = [&] {
    for (std::size_t begin = next.fetch_add(pieceSize); begin < count;
         begin = next.fetch_add(pieceSize))
      work(begin, std::min(begin + pieceSize, count));
  };
  std::vector<std::jthread> helpers;
  for (unsigned i = 1; i < threadCount; ++i)
    helpers.emplace_back(takePieces);
  takePieces();
}

}  // namespace planetree::bench
