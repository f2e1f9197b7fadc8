#include "threads/library_work.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

/// The library inside of threads that a program has started itself.
namespace planetree::test {
namespace {

using Tree = KdTree<Face<float>>;

/// Runs `work(i)` on so many threads at once.
template <class Work>
void onThreads(int count, const Work& work) {
  std::atomic<int> waiting = count;
  std::vector<std::thread> threads;
  for (int i = 0; i < count; ++i) {
    threads.emplace_back([&, i] {
      --waiting;
      while (waiting > 0)
        std::this_thread::yield();
      work(i);
    });
  }
  for (std::thread& thread : threads)
    thread.join();
}

TEST(InsideThreads, AllIsAsOutside) {
  std::atomic<int> failures = 0;
  onThreads(6, [&](int i) { failures += libraryWork().doesTheSame(i) ? 0 : 1; });
  EXPECT_EQ(failures, 0);
}

TEST(InsideThreads, AllIsAsOutsideInFunctionsThatRunByThemselves) {
  std::vector<std::future<bool>> results;
  for (int i = 0; i < 6; ++i) {
    results.push_back(std::async(std::launch::async, [i] { return libraryWork().doesTheSame(i); }));
  }
  for (std::future<bool>& result : results)
    EXPECT_TRUE(result.get());
}

TEST(InsideThreads, TreesOfAllPresetsAreBuiltAtOnceAsAlone) {
  const TriangleMesh<float> mesh = detail::soup<float>(905, 12'000, 0.03);
  const auto buildWith = [&](BuildOptions options, std::uint32_t threadCount) {
    options.threadCount = threadCount;
    return buildTree(mesh.view(), options);
  };
  const std::vector<BuildOptions> presets = {BuildOptions::fast(), BuildOptions::balanced(),
                                             BuildOptions::high(), BuildOptions::textbook()};
  std::vector<Tree> alone;
  for (const BuildOptions& preset : presets)
    alone.push_back(buildWith(preset, 1));
  std::atomic<int> failures = 0;
  onThreads(8, [&](int i) {
    const std::size_t preset = static_cast<std::size_t>(i) % presets.size();
    const Tree tree = buildWith(presets[preset], i < 4 ? 0 : 2);
    failures += hasSameBytes(tree.nodes(), alone[preset].nodes()) &&
                        hasSameBytes(tree.view().references, alone[preset].view().references)
                    ? 0
                    : 1;
  });
  EXPECT_EQ(failures, 0);
}

TEST(InsideThreads, ManyOfThemAskOneTreeAtOnce) {
  std::atomic<int> failures = 0;
  onThreads(24, [&](int i) {
    const LibraryWork& work = libraryWork();
    failures += (i % 2 == 0 ? work.answersTheSame() : work.tracesTheSame(2)) ? 0 : 1;
  });
  EXPECT_EQ(failures, 0);
}

TEST(InsideThreads, ATreeIsBuiltAskedAndDestroyedByThreeDifferentOnes) {
  const LibraryWork& work = libraryWork();
  // The mesh goes with the tree, so that all memory is given back on the last thread.
  auto built = std::async(std::launch::async, [&] {
    return std::make_unique<Tree>(buildTree(TriangleMesh<float>(work.mesh())));
  });
  std::unique_ptr<Tree> tree = built.get();
  bool isSame = false;
  std::thread([&] {
    isSame = tree->findIntersection(work.rays()[7]) == work.tree().findIntersection(work.rays()[7]);
  }).join();
  std::thread([&] { tree.reset(); }).join();
  EXPECT_TRUE(isSame);
  EXPECT_EQ(tree, nullptr);
}

// Copies share what they are made of: whoever comes last gives it back.
TEST(InsideThreads, CopiesOfATreeOutliveItOnOtherOnes) {
  const LibraryWork& work = libraryWork();
  std::optional<Tree> tree = buildTree(TriangleMesh<float>(work.mesh()));
  std::atomic<int> failures = 0;
  std::atomic<int> copied = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 6; ++i) {
    threads.emplace_back([&] {
      const Tree copy = *tree;
      ++copied;
      for (std::size_t ray = 0; ray < work.rays().size(); ray += 8) {
        if (copy.findIntersection(work.rays()[ray]) !=
            work.tree().findIntersection(work.rays()[ray]))
          ++failures;
      }
    });
  }
  while (copied < 6)
    std::this_thread::yield();
  tree.reset();
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(failures, 0);
}

TEST(InsideThreads, TreesAreBuiltAndDestroyedAgainAndAgain) {
  onThreads(4, [](int i) {
    for (int turn = 0; turn < 40; ++turn) {
      static_cast<void>(buildTree(detail::soup<float>(904, 400, 0.1),
                                  {.threadCount = static_cast<std::uint32_t>((i + turn) % 3)}));
    }
  });
}

}  // namespace
}  // namespace planetree::test
