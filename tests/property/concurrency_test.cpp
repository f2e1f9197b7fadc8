#include <planetree/planetree.hpp>

#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

namespace planetree::test {
namespace {

TEST(Concurrency, ManyThreadsAskOneTreeWhileOthersAreBuilt) {
  const TriangleMesh<float> mesh = detail::soup<float>(81, 3000, 0.1);
  const auto tree = buildTree(mesh.view());
  const auto rays = hardRays(mesh, tree.bounds(), 3000, 82);
  std::vector<std::optional<Hitf>> expected;
  for (const Rayf& ray : rays)
    expected.push_back(tree.findIntersection(ray));

  std::atomic<std::size_t> differences = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      const KdTree<Face<float>> own =
          i % 2 == 0 ? tree : buildTree(mesh.view(), {.threadCount = 2});
      for (std::size_t r = 0; r < rays.size(); ++r) {
        if (own.findIntersection(rays[r]) != expected[r])
          ++differences;
        if (own.isOccluded(rays[r]) != expected[r].has_value())
          ++differences;
        std::array<Hitf, 3> hits;
        const FoundHits found = own.findIntersections(rays[r], hits);
        if (found.count > 0 ? hits.front() != expected[r] : expected[r].has_value())
          ++differences;
      }
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(differences, 0u);
}

TEST(Concurrency, TreesAreBuiltInsideTheCallersOwnParallelLoop) {
  const TriangleMesh<float> mesh = detail::soup<float>(83, 6000, 0.1);
  const auto expected = buildTree(mesh.view(), {.threadCount = 1});
  std::atomic<std::size_t> differences = 0;
  tbb::parallel_for(0, 8, [&](int i) {
    const auto tree = buildTree(mesh.view(), {.threadCount = static_cast<std::uint32_t>(i % 4)});
    if (tree.nodes().size() != expected.nodes().size())
      ++differences;
  });
  EXPECT_EQ(differences, 0u);
}

}  // namespace
}  // namespace planetree::test
