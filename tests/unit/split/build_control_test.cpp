#include <planetree/build_tree.hpp>
#include <planetree/error.hpp>
#include <planetree/scene.hpp>
#include <planetree/shape/geometry.hpp>
#include <planetree/shape/sphere.hpp>

#include "unit/split/random_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace planetree {
namespace {

using namespace std::chrono_literals;
using test::MeshGenerator;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kSeed = 577'215;

/// Small triangles of no order, enough to keep several threads busy for a while.
const TriangleMesh<float>& largeSoup() {
  static const auto mesh = MeshGenerator(kSeed).soupOfAnyCoordinates<float>(100'000, 0.02f);
  return mesh;
}

/// Enough for several threads.
const TriangleMesh<float>& mediumSoup() {
  static const auto mesh = MeshGenerator(kSeed).soupOfAnyCoordinates<float>(30'000, 0.03f);
  return mesh;
}

TriangleMesh<float> smallSoup() {
  return MeshGenerator(kSeed).soupOfAnyCoordinates<float>(3000, 0.1f);
}

using VirtualShapes = std::vector<std::shared_ptr<const Geometry<float>>>;

VirtualShapes virtualShapes() {
  MeshGenerator generator(kSeed);
  VirtualShapes shapes;
  for (int i = 0; i < 20'000; ++i) {
    const auto coordinate = [&] { return static_cast<float>(generator.between(0, 1000)); };
    const Vec3f center = {coordinate(), coordinate(), coordinate()};
    shapes.push_back(std::make_shared<GeometryOf<Sphere<float>>>(Sphere<float>{center, 10.0f}));
  }
  return shapes;
}

/// Triangles that cross each other all over the place, to be built without end: by this the
/// references multiply on every level.
TriangleMesh<float> crossingTriangles(int count) {
  return MeshGenerator(kSeed).soupOfAnyCoordinates<float>(count, 1.0f);
}
BuildOptions endlessly() {
  BuildOptions options;
  options.leafSize = 0;
  options.depthLimit = kMaxTreeDepth;
  options.stopsByCost = false;
  options.referencesPerObject = 0;
  return options;
}

BuildOptions onOneThread(BuildOptions options) {
  options.threadCount = 1;
  return options;
}

/// What there is to build, and how; the same for every control.
struct Case {
  std::string name;
  std::function<BuildReport(const BuildControl&)> build;
};

template <class Objects>
Case caseOf(std::string name, Objects objects, const BuildOptions& options) {
  return {std::move(name), [objects = std::make_shared<const Objects>(std::move(objects)),
                            options](const BuildControl& control) {
            return buildTree(*objects, options, control).report();
          }};
}

std::vector<Case> cases(std::uint32_t threadCount) {
  const auto with = [threadCount](BuildOptions options) {
    options.threadCount = threadCount;
    return options;
  };
  Scene<float> scene;
  scene.add(smallSoup());
  scene.add(mediumSoup().view());
  scene.add(virtualShapes());
  return {
      caseOf("no triangles", TriangleMesh<float>{}, with(BuildOptions{})),
      caseOf("one triangle", MeshGenerator(kSeed).soupOfAnyCoordinates<float>(1, 1.0f),
             with(BuildOptions{})),
      caseOf("small", smallSoup(), with(BuildOptions{})),
      caseOf("fast", mediumSoup().view(), with(BuildOptions::fast())),
      caseOf("balanced", mediumSoup().view(), with(BuildOptions::balanced())),
      caseOf("high", mediumSoup().view(), with(BuildOptions::high())),
      caseOf("textbook", mediumSoup().view(), with(BuildOptions::textbook())),
      caseOf("doubles", MeshGenerator(kSeed).soupOfAnyCoordinates<double>(20'000, 0.05),
             with(BuildOptions{})),
      caseOf("virtual shapes", virtualShapes(), with(BuildOptions{})),
      caseOf("scene", std::move(scene), with(BuildOptions{})),
  };
}

/// What `onProgress` was told, and whether two threads ever did so at a time.
class Listener {
 public:
  [[nodiscard]] BuildControl control() {
    BuildControl control;
    control.onProgress = [this](const BuildProgress& progress) {
      overlaps_ += ++callers_ > 1 ? 1 : 0;
      // Long enough for another thread to come by.
      std::this_thread::sleep_for(1ms);
      told_.push_back(progress);
      --callers_;
    };
    return control;
  }
  [[nodiscard]] const std::vector<BuildProgress>& told() const { return told_; }
  [[nodiscard]] int overlaps() const { return overlaps_; }

 private:
  std::vector<BuildProgress> told_;
  std::atomic<int> callers_ = 0;
  std::atomic<int> overlaps_ = 0;
};

TEST(BuildProgress, RisesToOneAndIsToldByOneThreadAtATime) {
  for (const std::uint32_t threadCount : {1u, 4u}) {
    for (const Case& each : cases(threadCount)) {
      SCOPED_TRACE(each.name + ", threads: " + std::to_string(threadCount));
      Listener listener;
      const BuildReport report = each.build(listener.control());
      EXPECT_EQ(listener.overlaps(), 0);
      double before = 0.0;
      for (const BuildProgress& progress : listener.told()) {
        EXPECT_GE(progress.done, before);
        before = progress.done;
        EXPECT_TRUE(std::ranges::any_of(report.phases, [&](const BuildPhase& phase) {
          return phase.name == progress.phase;
        })) << progress.phase;
      }
      ASSERT_FALSE(listener.told().empty());
      EXPECT_EQ(listener.told().back().done, 1.0);
      EXPECT_EQ(std::ranges::count(listener.told(), 1.0, &BuildProgress::done), 1);
    }
  }
}

TEST(BuildProgress, IsToldOnTheWay) {
  Listener listener;
  static_cast<void>(
      buildTree(largeSoup().view(), onOneThread(BuildOptions::high()), listener.control()));
  EXPECT_GT(listener.told().size(), 3u);
  EXPECT_LT(listener.told().front().done, 0.9);
}

TEST(BuildProgress, LeavesTheTreeAsItIs) {
  Listener listener;
  const auto watched = buildTree(smallSoup(), {}, listener.control());
  const auto unwatched = buildTree(smallSoup());
  EXPECT_EQ(watched.nodes().size(), unwatched.nodes().size());
  EXPECT_EQ(watched.statistics().sahCost, unwatched.statistics().sahCost);
}

TEST(BuildProgress, EndsTheBuildWithWhatItThrows) {
  for (const std::uint32_t threadCount : {1u, 4u}) {
    for (const Case& each : cases(threadCount)) {
      SCOPED_TRACE(each.name + ", threads: " + std::to_string(threadCount));
      BuildControl control;
      control.onProgress = [](const BuildProgress&) { throw std::domain_error("no more"); };
      try {
        static_cast<void>(each.build(control));
        FAIL() << "was built";
      } catch (const std::domain_error& error) {
        EXPECT_STREQ(error.what(), "no more");
      }
    }
  }
}

TEST(StopOfABuild, ThatIsRequestedBeforeIsAnsweredAtOnce) {
  std::stop_source source;
  source.request_stop();
  for (const Case& each : cases(2)) {
    SCOPED_TRACE(each.name);
    BuildControl control;
    control.stopToken = source.get_token();
    control.onProgress = [](const BuildProgress&) { FAIL() << "nothing was done"; };
    EXPECT_THROW(static_cast<void>(each.build(control)), Cancelled);
  }
}

TEST(StopOfABuild, IsAnErrorWithACodeOfItsOwn) {
  std::stop_source source;
  source.request_stop();
  BuildControl control;
  control.stopToken = source.get_token();
  try {
    static_cast<void>(buildTree(smallSoup(), {}, control));
    FAIL() << "was built";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    EXPECT_EQ(errorCodeName(error.code()), "cancelled");
    EXPECT_STREQ(error.what(), "cancelled");
  }
}

TEST(StopOfABuild, MayComeFromTheProgress) {
  for (const std::uint32_t threadCount : {1u, 4u}) {
    for (const double from : {0.0, 0.3, 0.7}) {
      SCOPED_TRACE(std::to_string(from) + ", threads: " + std::to_string(threadCount));
      std::stop_source source;
      BuildControl control;
      control.stopToken = source.get_token();
      double last = 0.0;
      control.onProgress = [&](const BuildProgress& progress) {
        last = progress.done;
        if (progress.done >= from)
          source.request_stop();
      };
      BuildOptions options = BuildOptions::high();
      options.threadCount = threadCount;
      EXPECT_THROW(static_cast<void>(buildTree(largeSoup().view(), options, control)), Cancelled);
      EXPECT_LT(last, 1.0);
    }
  }
}

TEST(StopOfABuild, ThatComesTooLateChangesNothing) {
  std::stop_source source;
  BuildControl control;
  control.stopToken = source.get_token();
  control.onProgress = [&](const BuildProgress& progress) {
    if (progress.done == 1.0)
      source.request_stop();
  };
  EXPECT_EQ(buildTree(smallSoup(), {}, control).objectCount(), 3000u);
}

/// How long a build that would not end goes on when another thread stops it.
Clock::duration timeToStop(const TriangleMesh<float>& mesh, std::uint32_t threadCount) {
  std::stop_source source;
  BuildControl control;
  control.stopToken = source.get_token();
  BuildOptions options = endlessly();
  options.threadCount = threadCount;
  Clock::time_point stopped;
  std::thread stopper([&] {
    std::this_thread::sleep_for(200ms);
    stopped = Clock::now();
    source.request_stop();
  });
  EXPECT_THROW(static_cast<void>(buildTree(mesh.view(), options, control)), Cancelled);
  const Clock::time_point ended = Clock::now();
  stopper.join();
  return ended - stopped;
}

// Stopping takes some milliseconds; the machine may be busy, and sanitizers are slow.
constexpr Clock::duration kSoon = 1s;

TEST(StopOfABuild, FromAnotherThreadIsAnsweredSoon) {
  for (const std::uint32_t threadCount : {1u, 4u})
    EXPECT_LT(timeToStop(crossingTriangles(20'000), threadCount), kSoon) << threadCount;
}

TEST(StopOfABuild, IsAnsweredSoonWhereFewTrianglesMakeManyCells) {
  EXPECT_LT(timeToStop(crossingTriangles(2000), 1), kSoon);
}

BuildControl limitedTo(std::uint64_t bytes) {
  BuildControl control;
  control.memoryLimit = bytes;
  return control;
}

TEST(MemoryLimitOfABuild, ThatIsTooSmallIsAnErrorThatSaysSo) {
  for (const std::uint32_t threadCount : {1u, 4u}) {
    for (const Case& each : cases(threadCount)) {
      SCOPED_TRACE(each.name + ", threads: " + std::to_string(threadCount));
      const std::uint64_t peak = each.build({}).peakBytes;
      for (const std::uint64_t limit : {std::uint64_t{1}, peak / 4, peak / 2}) {
        if (limit == 0 || limit >= peak)
          continue;
        try {
          static_cast<void>(each.build(limitedTo(limit)));
          FAIL() << "was built with " << limit << " of " << peak << " bytes";
        } catch (const Error& error) {
          EXPECT_EQ(error.code(), ErrorCode::MemoryLimitExceeded);
          EXPECT_EQ(errorCodeName(error.code()), "memory-limit-exceeded");
          EXPECT_NE(std::string(error.what()).find(" MB of memory. Raise the memory limit"),
                    std::string::npos)
              << error.what();
        }
      }
    }
  }
}

TEST(MemoryLimitOfABuild, MayBeExactlyWhatTheBuildTakes) {
  for (const Case& each : cases(1)) {
    SCOPED_TRACE(each.name);
    const std::uint64_t peak = each.build({}).peakBytes;
    EXPECT_EQ(each.build({}).peakBytes, peak) << "the same on every run, on one thread";
    if (peak == 0)
      continue;
    EXPECT_EQ(each.build(limitedTo(peak)).peakBytes, peak);
    if (peak > 1) {
      EXPECT_THROW(static_cast<void>(each.build(limitedTo(peak - 1))), Error);
    }
  }
}

TEST(MemoryLimitOfABuild, EndsABuildWhereFewTrianglesMakeManyCells) {
  try {
    static_cast<void>(
        buildTree(crossingTriangles(2000), onOneThread(endlessly()), limitedTo(20'000'000)));
    FAIL() << "was built";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::MemoryLimitExceeded);
  }
}

TEST(PeakBytes, CoverTheTreeAndAreNotTooMany) {
  for (const BuildOptions& options :
       {BuildOptions::fast(), BuildOptions::balanced(), BuildOptions::high()}) {
    for (const std::uint32_t threadCount : {1u, 4u}) {
      BuildOptions withThreads = options;
      withThreads.threadCount = threadCount;
      const auto tree = buildTree(largeSoup().view(), withThreads);
      const std::uint64_t treeBytes = tree.nodes().size() * sizeof(Node) +
                                      tree.view().references.size() * sizeof(std::uint32_t);
      EXPECT_GE(tree.report().peakBytes, treeBytes);
      EXPECT_LT(tree.report().peakBytes, 400 * largeSoup().faces.size());
    }
  }
}

TEST(PeakBytes, CoverTheTreesOfAllCases) {
  const auto tree = buildTree(virtualShapes(), onOneThread(BuildOptions{}));
  EXPECT_GE(tree.report().peakBytes, tree.statistics().bytes);
  const auto textbook = buildTree(largeSoup().view(), onOneThread(BuildOptions::textbook()));
  EXPECT_GE(textbook.report().peakBytes, textbook.statistics().bytes);
}

TEST(ReferenceCount, IsThatOfTheTree) {
  const auto mesh = buildTree(largeSoup().view());
  EXPECT_EQ(mesh.report().referenceCount, mesh.statistics().referenceCount);
  const auto shapes = buildTree(virtualShapes());
  EXPECT_EQ(shapes.report().referenceCount, shapes.statistics().referenceCount);
  const auto textbook = buildTree(smallSoup(), BuildOptions::textbook());
  EXPECT_EQ(textbook.report().referenceCount, textbook.statistics().referenceCount);
  EXPECT_EQ(buildTree(TriangleMesh<float>{}).report().referenceCount, 0u);
}

}  // namespace
}  // namespace planetree
