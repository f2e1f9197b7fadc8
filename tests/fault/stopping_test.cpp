#include "fault_scenes.hpp"
#include "stepping_clock.hpp"
#include "try_faults.hpp"

#include "render/render_image.hpp"

#include <planetree/planetree.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

/// More than passes between two tellings of progress.
constexpr std::chrono::milliseconds kStep(50);

/// What a caller's own function throws; no exception of the library or of the language.
struct OwnFault {
  std::uint64_t call;
};

/// Stops something at one of its progress calls, in one way or the other.
class Stopper {
 public:
  enum class Way : std::uint8_t { Request, Throw };

  Stopper(Way way, std::uint64_t call) : way_(way), call_(call) {}

  /// To be called by `onProgress`.
  void tell(double done) {
    const std::uint64_t number = ++callCount_;
    isOver_ = isOver_ || done >= 1.0;
    if (number != call_)
      return;
    if (way_ == Way::Throw)
      throw OwnFault{number};
    source_.request_stop();
  }
  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
  [[nodiscard]] std::uint64_t callCount() const noexcept { return callCount_; }
  /// Whether the call was the last one: a request comes too late then.
  [[nodiscard]] bool isTooLate() const noexcept { return way_ == Way::Request && isOver_; }

 private:
  Way way_;
  std::uint64_t call_;
  std::stop_source source_;
  std::atomic<std::uint64_t> callCount_ = 0;
  std::atomic<bool> isOver_ = false;
};

/// Does `work(stopper)`, stopped at that call, and looks what comes out and what stays.
template <class Work>
void tryStop(const std::string& what, const Work& work, const std::string& expected,
             Stopper::Way way, std::uint64_t call) {
  const std::string name = what + (way == Stopper::Way::Throw ? ", thrown at" : ", stopped at") +
                           " call " + std::to_string(call);
  Stopper stopper(way, call);
  const HeldMemory before = heldMemory();
  bool isTold = false;
  bool isQuiet = true;
  try {
    const auto result = work(stopper);
    isTold = (stopper.isTooLate() || stopper.callCount() < call) && bitsOf(result) == expected;
  } catch (const Cancelled&) {
    isTold = way == Stopper::Way::Request;
  } catch (const OwnFault& fault) {
    isTold = way == Stopper::Way::Throw && fault.call == call;
    isQuiet = stopper.callCount() == call;
  } catch (...) {
  }
  const bool isHeld = heldMemory() != before;
  faultTally().injectedCount += stopper.callCount() >= call ? 1u : 0u;
  if (!isTold)
    reportLost(name);
  if (!isQuiet)
    reportLost(name + ": called once more after it had thrown");
  if (isHeld)
    reportLeak(name);
}

/// Tries about `most` of the progress calls that `work` makes.
template <class Work>
void tryStops(const std::string& what, const Work& work, std::uint64_t most) {
  const SteppingClock clock(kStep);
  Stopper never(Stopper::Way::Request, 0);
  const std::string expected = bitsOf(work(never));
  const std::uint64_t callCount = never.callCount();
  EXPECT_GT(callCount, 3u) << what << ": nothing can be stopped where nothing is told";
  for (const Stopper::Way way : {Stopper::Way::Request, Stopper::Way::Throw}) {
    for (const std::uint64_t call : someOf(callCount, most)) {
      tryStop(what, work, expected, way, call);
      if (testing::Test::HasFailure())
        return;
    }
    Stopper none(Stopper::Way::Request, 0);
    if (bitsOf(work(none)) != expected)
      reportLost(what + ": another result after a stop");
  }
}

template <class T>
class Stopping : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Stopping, Scalars);

TYPED_TEST(Stopping, EndsBuildsAtAnyProgressCall) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = MeshGenerator(6).soupOfAnyCoordinates<T>(12'000, T(0.03));
  for (const Preset& preset : kPresets) {
    for (const std::uint32_t threadCount : {1u, 2u}) {
      BuildOptions options = preset.options;
      options.threadCount = threadCount;
      const auto build = [&](Stopper& stopper) {
        const BuildControl control = {
            .onProgress = [&](const BuildProgress& progress) { stopper.tell(progress.done); },
            .stopToken = stopper.token()};
        return buildTree(mesh.view(), options, control);
      };
      tryStops(std::string(preset.name) + ", " + std::to_string(threadCount) + " threads", build,
               8);
    }
  }
}

TYPED_TEST(Stopping, EndsBuildsAtAnyRequestForMemory) {
  using T = TypeParam;
  const TriangleMesh<T> mesh = smallMesh<T>();
  for (const Preset& preset : kPresets) {
    BuildOptions options = preset.options;
    options.cost.faceCost = 1.0;
    const auto build = [&](const std::stop_token& token) {
      return buildTree(mesh.view(), options, {.stopToken = token});
    };
    const std::string expected = bitsOf(build({}));
    const std::uint64_t count = requestCountOf([&] { return build({}); });
    for (const std::uint64_t number : someOf(count, 200)) {
      const std::string name = std::string(preset.name) + ", request " + std::to_string(number);
      std::stop_source source;
      const HeldMemory before = heldMemory();
      const MemoryFaults stops(source, number);
      try {
        const auto tree = build(source.get_token());
        stops.end();
        if (bitsOf(tree) != expected)
          reportLost(name);
      } catch (const Cancelled&) {
      }
      stops.end();
      ++faultTally().injectedCount;
      if (heldMemory() != before)
        reportLeak(name);
    }
    EXPECT_EQ(bitsOf(build({})), expected);
  }
}

/// Rays of which each has its answer, or what stood there before.
template <class T>
void expectAnsweredOrUntouched(std::span<const Hit<T>> hits, std::span<const Hit<T>> expected,
                               const Hit<T>& untouched) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!(hits[i] == expected[i]) && !(hits[i] == untouched))
      return reportLost("ray " + std::to_string(i) + " has half an answer");
  }
}

TYPED_TEST(Stopping, EndsBatchesAtAnyProgressCall) {
  using T = TypeParam;
  const auto tree = buildTree(smallMesh<T>());
  const auto rays = someRays<T>(20'000);
  std::vector<Hit<T>> expected(rays.size());
  tree.findIntersections(std::span<const Ray<T>>(rays), expected);
  Hit<T> untouched;
  untouched.t = T(-1);
  for (const std::uint32_t threadCount : {1u, 2u}) {
    const auto controlOf = [](Stopper& stopper) {
      return BatchControl{.onProgress = [&](double done) { stopper.tell(done); },
                          .stopToken = stopper.token()};
    };
    const std::string threads = std::to_string(threadCount) + " threads";
    tryStops(
        "nearest, " + threads,
        [&](Stopper& stopper) {
          std::vector<Hit<T>> hits(rays.size(), untouched);
          try {
            tree.findIntersections(std::span<const Ray<T>>(rays), hits,
                                   {.threadCount = threadCount}, controlOf(stopper));
          } catch (...) {
            expectAnsweredOrUntouched<T>(hits, expected, untouched);
            throw;
          }
          return hits;
        },
        1000);
    tryStops(
        "any, " + threads,
        [&](Stopper& stopper) {
          std::vector<std::uint8_t> flags(rays.size());
          tree.areOccluded(std::span<const Ray<T>>(rays), flags, {.threadCount = threadCount},
                           controlOf(stopper));
          return flags;
        },
        1000);
  }
}

/// With many threads, one that throws while others are about to tell: none of them may.
TYPED_TEST(Stopping, CallsNobodyAgainWhoHasThrown) {
  using T = TypeParam;
  const auto tree = buildTree(smallMesh<T>());
  const auto rays = someRays<T>(20'000);
  std::vector<Hit<T>> hits(rays.size());
  const SteppingClock clock(kStep);
  for (int repetition = 0; repetition < 300; ++repetition) {
    Stopper stopper(Stopper::Way::Throw, 1 + static_cast<std::uint64_t>(repetition % 7));
    EXPECT_THROW(tree.findIntersections(std::span<const Ray<T>>(rays), hits, {.threadCount = 2},
                                        {.onProgress = [&](double done) { stopper.tell(done); }}),
                 OwnFault);
    EXPECT_EQ(stopper.callCount(), 1 + static_cast<std::uint64_t>(repetition % 7));
    ++faultTally().injectedCount;
  }
}

std::vector<float> numbersOf(const render::Rendering& rendering) {
  std::vector<float> numbers;
  for (const render::FilmSample& sample : rendering.film.samples())
    numbers.push_back(sample.value.x);
  return numbers;
}

TEST(StoppingPictures, IsToldAndLeavesNothingElseAtAnyProgressCall) {
  const render::TreeTracer<Face<float>> tracer(buildTree(smallMesh<float>()));
  for (const std::uint32_t threadCount : {1u, 2u}) {
    for (const render::RenderMode mode :
         {render::RenderMode::AmbientOcclusion, render::RenderMode::Normals,
          render::RenderMode::Depth, render::RenderMode::Heat}) {
      render::RenderSettings settings = {
          .size = {64, 48},
          .camera = {.eye = {0.5f, 0.5f, 3.0f}, .at = {0.5f, 0.5f, 0.5f}},
          .mode = mode,
          .samplesPerPixel = 2,
          .threadCount = threadCount,
          .cellDepth = 2};
      std::atomic<std::uint64_t> callCount = 0;
      settings.keepsGoing = [&](double /*done*/) { return ++callCount > 0; };
      const std::vector<float> expected = numbersOf(renderImage(tracer, settings));
      const std::vector<std::uint64_t> calls = someOf(callCount, 30);
      for (const bool throws : {false, true}) {
        for (const std::uint64_t call : calls) {
          callCount = 0;
          settings.keepsGoing = [&](double /*done*/) {
            if (++callCount != call)
              return true;
            if (throws)
              throw OwnFault{call};
            return false;
          };
          const HeldMemory before = heldMemory();
          bool isTold = false;
          try {
            isTold = !renderImage(tracer, settings).isComplete;
          } catch (const OwnFault& fault) {
            isTold = throws && fault.call == call;
          }
          ++faultTally().injectedCount;
          if (!isTold)
            reportLost("a picture stopped at call " + std::to_string(call));
          if (heldMemory() != before)
            reportLeak("a picture stopped at call " + std::to_string(call));
        }
        settings.keepsGoing = {};
        EXPECT_EQ(numbersOf(renderImage(tracer, settings)), expected);
      }
    }
  }
}

}  // namespace
}  // namespace planetree::test
