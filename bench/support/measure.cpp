#include "bench/support/measure.hpp"

#include "bench/support/batches.hpp"
#include "bench/support/build_info.hpp"
#include "bench/support/counted_heap.hpp"
#include "bench/support/interleaved.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace planetree::bench {

namespace {

using Structures = std::vector<std::unique_ptr<Structure>>;

constexpr std::size_t kFewestSampleRays = 16;
constexpr std::size_t kMostSampleRays = 1000;
constexpr unsigned kMemoryRounds = 2;

/// For measurements that trace no rays: enough to tell a wrong structure.
constexpr RayCounts kCheckedRayCounts = {.pictureSize = 256, .randomCount = 65'536};

std::size_t sampleSize(const BenchScene& scene, const MeasureSettings& settings) {
  return std::clamp(settings.bruteForceTests / std::max<std::size_t>(scene.objects().size(), 1),
                    kFewestSampleRays, kMostSampleRays);
}

Structures buildAll(const BenchScene& scene, const EngineList& engines, unsigned threadCount) {
  Structures structures;
  for (const auto& engine : engines)
    structures.push_back(engine->build(scene.objects(), threadCount));
  return structures;
}

std::string describe(const CheckedPair& pair) {
  const Disagreement& found = pair.disagreement;
  return fmt::format(
      "{} {} against {}, of {} rays: {} missed, {} invented, {} at another distance, "
      "{} of another object at the same distance{}",
      pair.engine, pair.mode, pair.reference, found.rayCount, found.missed, found.invented,
      found.otherDistance, found.otherId, pair.isAcceptable ? "" : ": WRONG");
}

bool isWorthTelling(const CheckedPair& pair) {
  return !pair.isAcceptable || pair.disagreement.wrong() > 0 || pair.disagreement.otherId > 0;
}

using BatchMaker = std::unique_ptr<Batch> (*)(const Structure&, const RaySet&);
using Batches = std::vector<std::unique_ptr<Batch>>;

Batches makeBatches(const Structures& structures, const RaySet& set, BatchMaker makeBatch) {
  Batches batches;
  for (const auto& structure : structures)
    batches.push_back(makeBatch(*structure, set));
  return batches;
}

CheckedAnswers answersOf(const Engine& engine, Batch& batch, const RaySet& set,
                         unsigned threadCount) {
  CheckedAnswers checked{engine.name(), engine.mode(), engine.isExact(), engine.precision(),
                         roomForAnswers(set)};
  batch.reset();
  batch.trace(threadCount);
  batch.readAnswers(checked.answers);
  return checked;
}

/// All engines answer all rays, which also warms them up.
std::vector<CheckedAnswers> allAnswers(const EngineList& engines, const Batches& batches,
                                       const RaySet& set, unsigned threadCount) {
  std::vector<CheckedAnswers> all;
  for (std::size_t i = 0; i < engines.size(); ++i)
    all.push_back(answersOf(*engines[i], *batches[i], set, threadCount));
  return all;
}

void check(const BenchScene& scene, const RaySet& set, const std::vector<CheckedAnswers>& all,
           const MeasureSettings& settings) {
  const auto pairs = checkAnswers(scene.objects(), set, all, scene.diagonal,
                                  sampleSize(scene, settings), hardwareThreads());
  bool areAcceptable = true;
  for (const CheckedPair& pair : pairs) {
    areAcceptable = areAcceptable && pair.isAcceptable;
    if (isWorthTelling(pair))
      settings.say(fmt::format("{} {}: {}", scene.name, rayKindName(set.kind), describe(pair)));
  }
  if (!areAcceptable) {
    throw WrongAnswers(fmt::format(
        "{}: an engine gives wrong answers to {} rays, see above. Mend it, or leave it out with "
        "--engines.",
        scene.name, rayKindName(set.kind)));
  }
}

void checkAll(const BenchScene& scene, const EngineList& engines, const MeasureSettings& settings) {
  if (settings.areAnswersChecked)
    return;
  // First the rays: making them takes a tree, which a large scene has no room for beside the
  // others.
  const auto sets = makeRaySets(scene.objects(), scene.camera, settings.kinds, kCheckedRayCounts);
  const Structures structures = buildAll(scene, engines, settings.threadCount);
  for (const RaySet& set : sets) {
    const Batches batches = makeBatches(structures, set, &oneByOne);
    check(scene, set, allAnswers(engines, batches, set, hardwareThreads()), settings);
  }
}

Result resultOf(const BenchScene& scene, const Engine& engine, std::string_view measure,
                std::string_view kind, unsigned threadCount, double value) {
  return {.scene = scene.name,
          .measure = std::string(measure),
          .kind = std::string(kind),
          .engine = engine.name(),
          .mode = engine.mode(),
          .threadCount = threadCount,
          .value = value,
          .isDefault = engine.isDefault(),
          .commit = commit(),
          .compiler = compiler(),
          .objectCount = scene.objects().size()};
}

/// A ray through the middle of the scene, to be traced as the end of a build.
Rayf firstRay(const BenchScene& scene) {
  const Vec3d eye(scene.camera.eye);
  return {.origin = scene.camera.eye, .direction = Vec3f(normalized(Vec3d(scene.camera.at) - eye))};
}

double buildSeconds(const BenchScene& scene, const Engine& engine, unsigned threadCount) {
  const Rayf ray = firstRay(scene);
  std::unique_ptr<Structure> structure;  // outlives the clock: giving it back is not building
  return secondsOf([&] {
    structure = engine.build(scene.objects(), threadCount);
    Hitf hit;
    structure->findIntersections(std::span(&ray, 1), std::span(&hit, 1));
  });
}

double secondsToTrace(Batch& batch, unsigned threadCount) {
  batch.reset();
  return secondsOf([&] { batch.trace(threadCount); });
}

/// The rays of a set in calls of one size.
struct SizedCalls {
  std::string measure;
  std::size_t callSize = 1;
  std::unique_ptr<Batch> batch;
};

/// One by one first.
std::vector<SizedCalls> smallBatches(const Structure& structure, const RaySet& set) {
  std::vector<SizedCalls> all;
  all.push_back({std::string(kNanosecondsOneByOne), 1, oneByOne(structure, set)});
  for (const std::size_t size : kSmallBatches) {
    all.push_back({smallBatchMeasure(size), size, structure.makeBatch(set, size)});
  }
  return all;
}

void addSmallBatches(const BenchScene& scene, const Engine& engine, const RaySet& set,
                     const Structure& structure, const MeasureSettings& settings,
                     std::vector<Result>& results) {
  const auto calls = smallBatches(structure, set);
  std::vector<CheckedAnswers> all;
  for (const SizedCalls& sized : calls)
    all.push_back(answersOf(engine, *sized.batch, set, 1));
  check(scene, set, all, settings);
  const auto seconds = bestOfRounds(calls.size(), settings.repetitions, [&](std::size_t i) {
    return secondsToTrace(*calls[i].batch, 1);
  });
  const auto rayCount = static_cast<double>(set.rays.size());
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const double nanoseconds = seconds[i] / rayCount * static_cast<double>(calls[i].callSize) * 1e9;
    results.push_back(
        resultOf(scene, engine, calls[i].measure, rayKindName(set.kind), 1, nanoseconds));
  }
}

void prepareAll(const EngineList& engines, unsigned threadCount) {
  for (const auto& engine : engines)
    engine->prepare(threadCount);
}

void refuseIfHeapIsNotCounted() {
  if (!heapIsCounted())
    throw std::logic_error("this build does not count memory. Build without sanitizers.");
}

/// Results of a number of bytes that each engine takes, for each object of the scene.
std::vector<Result> bytesPerObject(const BenchScene& scene, const EngineList& engines,
                                   const MeasureSettings& settings, std::string_view measure,
                                   double (*bytesOf)(const BenchScene&, const Engine&,
                                                     unsigned threadCount)) {
  refuseIfHeapIsNotCounted();
  checkAll(scene, engines, settings);
  prepareAll(engines, settings.threadCount);
  const auto bytes = bestOfRounds(engines.size(), kMemoryRounds, [&](std::size_t i) {
    return bytesOf(scene, *engines[i], settings.threadCount);
  });
  const auto objectCount = static_cast<double>(scene.objects().size());
  std::vector<Result> results;
  for (std::size_t i = 0; i < engines.size(); ++i)
    results.push_back(
        resultOf(scene, *engines[i], measure, "", settings.threadCount, bytes[i] / objectCount));
  return results;
}

/// Steps are the same however many threads make them: this one counts them.
void addSteps(const BenchScene& scene, const Engine& engine, const RaySet& set,
              const Structure& structure, unsigned threadCount, std::vector<Result>& results) {
  const Steps steps = structure.countSteps(set.rays, asksForAnyHit(set.kind));
  const auto rayCount = static_cast<double>(set.rays.size());
  const auto nodes = static_cast<double>(steps.nodes);
  const auto blocks = static_cast<double>(steps.blocks);
  results.push_back(resultOf(scene, engine, kNodeStepsPerRay, rayKindName(set.kind), threadCount,
                             nodes / rayCount));
  results.push_back(resultOf(scene, engine, kBlockStepsPerRay, rayKindName(set.kind), threadCount,
                             blocks / rayCount));
}

double peakBytes(const BenchScene& scene, const Engine& engine, unsigned threadCount) {
  const HeapCount count;
  const auto structure = engine.build(scene.objects(), threadCount);
  return static_cast<double>(count.peakBytes());
}

double heldBytes(const BenchScene& scene, const Engine& engine, unsigned threadCount) {
  const HeapCount count;
  const auto structure = engine.build(scene.objects(), threadCount);
  auto bytes = static_cast<double>(count.bytes());
  // All read the shapes: they are nobody's, like the rays.
  if (engine.queriesReadMesh() && scene.objects().mesh() != nullptr) {
    bytes += static_cast<double>(scene.mesh.positions.size() * sizeof(Vec3f) +
                                 scene.mesh.faces.size() * sizeof(FaceIndices));
  }
  return bytes;
}

/// The sets that have rays; it tells which kinds have none.
std::vector<RaySet> setsWithRays(const BenchScene& scene, const MeasureSettings& settings) {
  auto sets = makeRaySets(scene.objects(), scene.camera, settings.kinds, settings.counts);
  std::erase_if(sets, [&](const RaySet& set) {
    if (set.rays.empty()) {
      settings.say(fmt::format("{}: there are no {} rays, since no primary ray hits", scene.name,
                               rayKindName(set.kind)));
    }
    return set.rays.empty();
  });
  return sets;
}

/// Million rays per second of each kind, handed over in one of the ways.
std::vector<Result> raysPerSecond(const BenchScene& scene, const EngineList& engines,
                                  const MeasureSettings& settings, std::string_view measure,
                                  BatchMaker makeBatch) {
  const Structures structures = buildAll(scene, engines, settings.buildThreadCount);
  std::vector<Result> results;
  for (const RaySet& set : setsWithRays(scene, settings)) {
    const Batches batches = makeBatches(structures, set, makeBatch);
    check(scene, set, allAnswers(engines, batches, set, settings.threadCount), settings);
    const auto seconds = bestOfRounds(engines.size(), settings.repetitions, [&](std::size_t i) {
      return secondsToTrace(*batches[i], settings.threadCount);
    });
    for (std::size_t i = 0; i < engines.size(); ++i) {
      const double millionRays = static_cast<double>(set.rays.size()) / 1e6;
      results.push_back(resultOf(scene, *engines[i], measure, rayKindName(set.kind),
                                 settings.threadCount, millionRays / seconds[i]));
    }
  }
  return results;
}

}  // namespace

std::vector<Result> measureRays(const BenchScene& scene, const EngineList& engines,
                                const MeasureSettings& settings) {
  return raysPerSecond(scene, engines, settings, kMraysPerSecond, &oneByOne);
}

std::vector<Result> measureBatches(const BenchScene& scene, const EngineList& engines,
                                   const MeasureSettings& settings) {
  return raysPerSecond(scene, engines, settings, kBatchMraysPerSecond, &allAtOnce);
}

std::vector<Result> measureSmallBatches(const BenchScene& scene, const EngineList& engines,
                                        const MeasureSettings& settings) {
  const auto sets = setsWithRays(scene, settings);
  std::vector<Result> results;
  for (const auto& engine : engines) {
    if (!engine->takesBatches())
      continue;
    const auto structure = engine->build(scene.objects(), settings.buildThreadCount);
    for (const RaySet& set : sets)
      addSmallBatches(scene, *engine, set, *structure, settings, results);
  }
  return results;
}

std::vector<Result> measureBuild(const BenchScene& scene, const EngineList& engines,
                                 const MeasureSettings& settings) {
  checkAll(scene, engines, settings);
  prepareAll(engines, settings.threadCount);
  const auto seconds = bestOfRounds(engines.size(), settings.repetitions, [&](std::size_t i) {
    return buildSeconds(scene, *engines[i], settings.threadCount);
  });
  std::vector<Result> results;
  for (std::size_t i = 0; i < engines.size(); ++i)
    results.push_back(
        resultOf(scene, *engines[i], kBuildSeconds, "", settings.threadCount, seconds[i]));
  return results;
}

std::vector<Result> measureMemory(const BenchScene& scene, const EngineList& engines,
                                  const MeasureSettings& settings) {
  return bytesPerObject(scene, engines, settings, kBytesPerTriangle, &heldBytes);
}

std::vector<Result> measurePeak(const BenchScene& scene, const EngineList& engines,
                                const MeasureSettings& settings) {
  return bytesPerObject(scene, engines, settings, kPeakBytesPerTriangle, &peakBytes);
}

std::vector<Result> measureSteps(const BenchScene& scene, const EngineList& engines,
                                 const MeasureSettings& settings) {
  checkAll(scene, engines, settings);
  const auto sets = makeRaySets(scene.objects(), scene.camera, settings.kinds, settings.counts);
  std::vector<Result> results;
  for (const auto& engine : engines) {
    if (!engine->countsSteps())
      continue;
    const auto structure = engine->build(scene.objects(), settings.buildThreadCount);
    for (const RaySet& set : sets) {
      if (!set.rays.empty())
        addSteps(scene, *engine, set, *structure, settings.threadCount, results);
    }
  }
  return results;
}

}  // namespace planetree::bench
