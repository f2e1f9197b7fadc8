#include <planetree/planetree.hpp>

#include "soak/closed_solids.hpp"
#include "soak/embree_leaks.hpp"
#include "soak/leak_counts.hpp"
#include "soak/solid_rays.hpp"
#include "support/program_options.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

/// Streams rays at closed meshes, and counts those that leak. The memory does not depend on the
/// number of rays.
namespace planetree::test {
namespace {

/// Short runs have small blocks, so that all kinds of blocks have their turn.
constexpr std::size_t kRaysPerBlock = 1024;
constexpr std::size_t kRaysPerSmallBlock = 256;
constexpr std::uint64_t kRaysOfShortRun = 10'000'000;
/// Of as many blocks one is asked from outside.
constexpr std::uint64_t kBlocksPerOuterBlock = 8;
/// Rays in double have no packets, but a path of their own, which is as slow as single rays.
constexpr double kPartOfDoubles = 0.25;

/// How the rays of a mesh are cut into blocks.
struct Blocks {
  std::size_t rays;
  std::uint64_t count;
};

struct Row {
  std::string mesh;
  std::string placement;
  std::string scalar;
  std::size_t faceCount = 0;
  bool isNearUnitScale = false;
  LeakCounts counts;
  bool hasEmbree = false;
  std::uint64_t robustLeaks = 0;
  std::uint64_t fastLeaks = 0;
};

/// What Embree is asked; only rays from inside in float, which it must not let out either.
class EmbreeRivals {
 public:
  explicit EmbreeRivals(const TriangleMesh<float>& mesh)
      : robust_(mesh, EmbreeMode::Robust), fast_(mesh, EmbreeMode::Fast) {}

  void ask(std::span<const Rayf> rays, Row& row) const {
    row.hasEmbree = true;
    row.robustLeaks += robust_.countLeaks(rays);
    row.fastLeaks += fast_.countLeaks(rays);
  }

 private:
  EmbreeScene robust_;
  EmbreeScene fast_;
};

/// One thread's share of the blocks of a mesh.
template <class T>
void askBlocks(const PlacedSolid<T>& solid, const KdTree<Face<T>>& tree, const EmbreeRivals* embree,
               std::uint64_t seed, const Blocks& blocks, std::atomic<std::uint64_t>& nextBlock,
               Row& row) {
  LeakCounter<T> counter(tree);
  std::vector<Ray<T>> rays(blocks.rays);
  while (true) {
    const std::uint64_t block = nextBlock.fetch_add(1);
    if (block >= blocks.count)
      return;
    const std::uint64_t outerBlocks = (block + kBlocksPerOuterBlock - 2) / kBlocksPerOuterBlock;
    if (block % kBlocksPerOuterBlock == 1) {
      fillWithOuterRays<T>(solid, seed, outerBlocks, rays);
      counter.askOutside(rays, row.counts);
      continue;
    }
    fillWithInnerRays<T>(solid, seed, block - outerBlocks, rays);
    counter.askInside(rays, row.counts);
    if constexpr (std::is_same_v<T, float>) {
      if (embree)
        embree->ask(rays, row);
    }
  }
}

template <class T>
Row soakMesh(const PlacedSolid<T>& solid, const ProgramOptions& options, const Blocks& blocks) {
  const KdTree<Face<T>> tree = buildTree(solid.mesh.view());
  std::unique_ptr<const EmbreeRivals> embree;
  if constexpr (std::is_same_v<T, float>) {
    if (EmbreeScene::isAvailable())
      embree = std::make_unique<const EmbreeRivals>(solid.mesh);
  }

  Row row;
  row.mesh = solid.name;
  row.placement = solid.placement;
  row.scalar = std::is_same_v<T, float> ? "float" : "double";
  row.faceCount = solid.mesh.faces.size();
  row.isNearUnitScale = solid.isNearUnitScale;
  std::atomic<std::uint64_t> nextBlock = 0;
  std::mutex mutex;
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < options.threads; ++i) {
    threads.emplace_back([&] {
      Row share;
      askBlocks(solid, tree, embree.get(), options.seed, blocks, nextBlock, share);
      const std::lock_guard lock(mutex);
      row.counts += share.counts;
      row.hasEmbree = row.hasEmbree || share.hasEmbree;
      row.robustLeaks += share.robustLeaks;
      row.fastLeaks += share.fastLeaks;
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  return row;
}

using Number = unsigned long long;

void printHeading(bool hasEmbree) {
  std::printf("%-20s %-11s %-6s %6s %11s %7s", "mesh", "placement", "scalar", "faces", "rays",
              "leaks");
  if (hasEmbree)
    std::printf("   Embree: rays  robust      fast");
  std::printf("\n");
}

void printRow(const Row& row) {
  const LeakCounts& counts = row.counts;
  std::printf("%-20s %-11s %-6s %6zu %11llu %7llu", row.mesh.c_str(), row.placement.c_str(),
              row.scalar.c_str(), row.faceCount, Number{counts.innerRays + counts.outerRays},
              Number{counts.leaks()});
  if (row.hasEmbree) {
    std::printf(" %14llu %7llu %9llu", Number{counts.innerRays}, Number{row.robustLeaks},
                Number{row.fastLeaks});
  }
  std::printf("\n");
  std::fflush(stdout);
}

void printKinds(const LeakCounts& counts) {
  const auto print = [](const char* kind, std::uint64_t leaks, std::uint64_t rays) {
    std::printf("  %-38s %9llu of %llu rays\n", kind, Number{leaks}, Number{rays});
  };
  std::printf("by the kind of query:\n");
  print("from inside, nearest hit", counts.nearest, counts.innerRays);
  print("from inside, any hit", counts.any, counts.innerRays);
  print("from inside, all hits", counts.all, counts.innerRays);
  print("from inside, nearest hits of a batch", counts.nearestOfBatch, counts.innerRays);
  print("from inside, any hits of a batch", counts.anyOfBatch, counts.innerRays);
  print("from inside, crossings other than 1", counts.innerCrossings, counts.innerRays);
  print("from outside, crossings other than 0", counts.outerCrossings, counts.outerRays);
  print("answers that contradict each other", counts.contradictions,
        counts.innerRays + counts.outerRays);
}

/// Soaks each of the meshes with its part of the rays.
template <class T>
void soakMeshes(std::uint64_t rays, const ProgramOptions& options, std::vector<Row>& rows) {
  const std::vector<PlacedSolid<T>> solids = placedSolids<T>();
  Blocks blocks{options.rays < kRaysOfShortRun ? kRaysPerSmallBlock : kRaysPerBlock, 1};
  const std::uint64_t blockOfEach = solids.size() * blocks.rays;
  blocks.count = (rays + blockOfEach - 1) / blockOfEach;
  for (const PlacedSolid<T>& solid : solids) {
    rows.push_back(soakMesh(solid, options, blocks));
    printRow(rows.back());
  }
}

void printEmbree(const char* name, const std::vector<Row>& rows, bool unitScaleOnly) {
  std::uint64_t rays = 0;
  std::uint64_t robust = 0;
  std::uint64_t fast = 0;
  for (const Row& row : rows) {
    if (!row.hasEmbree || (unitScaleOnly && !row.isNearUnitScale))
      continue;
    rays += row.counts.innerRays;
    robust += row.robustLeaks;
    fast += row.fastLeaks;
  }
  std::printf("Embree %s, %s: leaks robust %llu, fast %llu, of %llu rays from inside\n",
              EmbreeScene::version(), name, Number{robust}, Number{fast}, Number{rays});
}

int soak(const ProgramOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  std::printf("planetree-soak: instruction set %s, %u threads, seed %llu\n",
              options.instructionSet.c_str(), options.threads, Number{options.seed});
  printHeading(EmbreeScene::isAvailable());
  const auto doubles =
      static_cast<std::uint64_t>(static_cast<double>(options.rays) * kPartOfDoubles);
  std::vector<Row> rows;
  soakMeshes<float>(options.rays - doubles, options, rows);
  soakMeshes<double>(doubles, options, rows);

  LeakCounts total;
  for (const Row& row : rows)
    total += row.counts;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  printKinds(total);
  if (EmbreeScene::isAvailable()) {
    printEmbree("meshes near unit scale and the origin", rows, true);
    printEmbree("all meshes", rows, false);
  }
  std::printf("%zu meshes, %.0f seconds\n", rows.size(), seconds.count());
  std::printf("leaks: %llu of %llu rays\n", Number{total.leaks()},
              Number{total.innerRays + total.outerRays});
  return total.leaks() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace planetree::test

int main(int count, char** words) {
  bool isSkipped = false;
  const auto options = planetree::test::readProgramOptions(count, words, isSkipped);
  if (!options)
    return isSkipped ? 77 : 2;
  try {
    return planetree::test::soak(*options);
  } catch (const std::exception& error) {
    std::cerr << "planetree-soak: " << error.what() << '\n';
    return 2;
  }
}
