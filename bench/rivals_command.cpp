#include "bench/rivals_command.hpp"

#include "bench/rivals/select_engines.hpp"
#include "bench/scene/shape_scenes.hpp"
#include "bench/scene/sized_scenes.hpp"
#include "bench/support/build_info.hpp"
#include "bench/support/comparisons.hpp"
#include "bench/support/counted_heap.hpp"
#include "bench/support/files.hpp"
#include "bench/support/measure.hpp"
#include "bench/support/small_batch_table.hpp"
#include "bench/support/summary.hpp"
#include "bench/support/talk.hpp"
#include "bench/usage_error.hpp"

#include <planetree/traversal/instruction_set.hpp>

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>

namespace planetree::bench {

namespace {

/// `--quick`: enough to see whether everything works, and roughly what is fast.
constexpr RayCounts kQuickRayCounts = {.pictureSize = 256, .randomCount = 65'536};
constexpr std::size_t kQuickBruteForceTests = 40'000'000;

bool isNamed(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The library would use another one without a word.
void checkInstructionSet() {
  const std::string_view requested = requestedInstructionSet();
  if (requested.empty() || requested == activeInstructionSet())
    return;
  throw UsageError(
      fmt::format("PLANETREE_ISA={}: this machine runs no such instruction set", requested),
      fmt::format("Unset it, or choose one of {}.", fmt::join(supportedInstructionSets(), ", ")));
}

std::vector<RayKind> selectKinds(const std::vector<std::string>& names) {
  std::vector<RayKind> kinds;
  for (const RayKind kind : kRayKinds) {
    if (isNamed(names, std::string(rayKindName(kind))))
      kinds.push_back(kind);
  }
  return kinds;
}

bool isShapeScene(const std::filesystem::path& scene) {
  return std::find(kShapeScenes.begin(), kShapeScenes.end(), scene.string()) != kShapeScenes.end();
}

bool isFile(const std::filesystem::path& scene) {
  return !isShapeScene(scene) && !sizedSceneName(scene.string());
}

BenchScene sceneFor(const std::filesystem::path& scene) {
  if (isShapeScene(scene))
    return makeShapeScene(scene.string());
  if (const auto size = sizedSceneName(scene.string()))
    return makeSizedScene(*size, scene.string());
  return loadScene(scene);
}

/// Scenes are told apart by their names alone, in the JSON and in the tables.
void checkNames(const std::vector<std::filesystem::path>& scenes) {
  std::set<std::string> names;
  for (const auto& scene : scenes) {
    if (!names.insert(sceneName(scene)).second) {
      throw UsageError(fmt::format("two scenes are called {}", sceneName(scene)),
                       "Name one of them, or rename a file.");
    }
  }
}

/// What can be measured, and how.
struct Measure {
  std::string name;
  std::vector<Result> (*run)(const BenchScene&, const EngineList&, const MeasureSettings&);
  /// A ray is answered by one thread, where nothing else is said; builds and batches use all.
  bool usesOneThread = false;
  bool isForOneThread = false;  ///< whatever is asked for
  bool countsMemory = false;
  bool takesPackets = false;  ///< modes that trace several rays at once take part unasked
  /// Those of whom nothing is measured are not asked; null where something is measured of all.
  bool (Engine::*isAbout)() const = nullptr;
  std::string_view whatItIsAbout = {};  ///< "counts steps"
};

const std::vector<Measure>& knownMeasures() {
  static const std::vector<Measure> all = {
      {.name = "build", .run = &measureBuild},
      {.name = "rays", .run = &measureRays, .usesOneThread = true},
      {.name = "batch", .run = &measureBatches, .takesPackets = true},
      {.name = "small-batch",
       .run = &measureSmallBatches,
       .isForOneThread = true,
       .isAbout = &Engine::takesBatches,
       .whatItIsAbout = "takes batches"},
      {.name = "memory", .run = &measureMemory, .countsMemory = true},
      {.name = "peak", .run = &measurePeak, .countsMemory = true},
      {.name = "steps",
       .run = &measureSteps,
       .usesOneThread = true,
       .isAbout = &Engine::countsSteps,
       .whatItIsAbout = "counts steps"},
  };
  return all;
}

std::vector<std::string> measureNames() {
  std::vector<std::string> names;
  for (const Measure& measure : knownMeasures())
    names.push_back(measure.name);
  return names;
}

/// Those asked for, in the order in which they are.
std::vector<Measure> selectMeasures(const std::vector<std::string>& names) {
  std::vector<Measure> selected;
  for (const std::string& name : names) {
    selected.push_back(*std::find_if(knownMeasures().begin(), knownMeasures().end(),
                                     [&](const Measure& known) { return known.name == name; }));
  }
  return selected;
}

/// How many threads to measure with, each number once.
std::vector<unsigned> threadCountsFor(const RivalsCommand& command, const Measure& measure) {
  if (measure.isForOneThread)
    return {1};
  std::vector<unsigned> counts;
  for (unsigned count : command.threadCounts) {
    if (count == 0)
      count = measure.usesOneThread ? 1 : hardwareThreads();
    if (std::find(counts.begin(), counts.end(), count) == counts.end())
      counts.push_back(count);
  }
  return counts;
}

MeasureSettings settingsFor(const RivalsCommand& command, unsigned threadCount) {
  MeasureSettings settings;
  settings.threadCount = threadCount;
  settings.buildThreadCount = hardwareThreads();
  settings.repetitions = command.repetitions;
  settings.kinds = selectKinds(command.kinds);
  if (command.isQuick) {
    settings.counts = kQuickRayCounts;
    settings.bruteForceTests = kQuickBruteForceTests;
  }
  settings.say = say;
  return settings;
}

/// A measure, and who takes part in it.
struct Plan {
  Measure measure;
  EngineList engines;
  EngineList enginesForShapes;  ///< those that can hold shapes
};

EngineList enginesFor(const RivalsCommand& command, const Measure& measure) {
  EngineList engines = selectEngines(command.engines, measure.takesPackets);
  if (measure.isAbout == nullptr)
    return engines;
  std::erase_if(engines, [&](const auto& engine) { return !((*engine).*measure.isAbout)(); });
  if (engines.empty()) {
    throw UsageError(
        fmt::format("--measure {}: none of the engines {}", measure.name, measure.whatItIsAbout),
        "Name planetree besides.");
  }
  return engines;
}

EngineList shapeEnginesFor(const RivalsCommand& command, const Measure& measure) {
  EngineList engines = enginesFor(command, measure);
  std::erase_if(engines, [](const auto& engine) { return !engine->takesShapes(); });
  if (engines.empty()) {
    throw UsageError("--engines: none of these takes shapes",
                     "Name planetree or embree3 besides, or leave out the scenes of shapes.");
  }
  return engines;
}

std::vector<Plan> makePlans(const RivalsCommand& command) {
  const bool hasShapes = std::any_of(command.scenes.begin(), command.scenes.end(), isShapeScene);
  std::vector<Plan> plans;
  for (const Measure& measure : selectMeasures(command.measures)) {
    plans.push_back({measure, enginesFor(command, measure),
                     hasShapes ? shapeEnginesFor(command, measure) : EngineList()});
  }
  return plans;
}

std::vector<Result> measureScene(const RivalsCommand& command, const BenchScene& scene,
                                 const std::vector<Plan>& plans) {
  std::vector<Result> results;
  std::set<std::string> checked;  // modes whose answers were
  const SceneObjects objects = scene.objects();
  const bool hasShapes = objects.mesh() == nullptr;
  for (const Plan& plan : plans) {
    const EngineList& engines = hasShapes ? plan.enginesForShapes : plan.engines;
    for (const unsigned threadCount : threadCountsFor(command, plan.measure)) {
      MeasureSettings settings = settingsFor(command, threadCount);
      settings.areAnswersChecked =
          std::all_of(engines.begin(), engines.end(),
                      [&](const auto& engine) { return checked.contains(fullName(*engine)); });
      say(fmt::format("{}: {} {}, measuring {} on {}", scene.name, objects.size(),
                      hasShapes ? "shapes" : "triangles", plan.measure.name,
                      threadText(threadCount)));
      const auto measured = plan.measure.run(scene, engines, settings);
      results.insert(results.end(), measured.begin(), measured.end());
      for (const auto& engine : engines) {
        // Where nothing came of it, there may have been no rays to check with.
        if (!measured.empty())
          checked.insert(fullName(*engine));
      }
    }
  }
  return results;
}

std::string tables(const std::vector<Result>& results) {
  std::string text = headLine();
  for (const Summary& summary : summarise(withoutSmallBatches(results)))
    text += "\n" + toText(summary);
  for (const Table& table : comparisons(results))
    text += "\n" + toText(table);
  return text + "\n* without options. Nx: planetree's default is N times better than this one.\n";
}

}  // namespace

CLI::App* addRivalsCommand(CLI::App& app, RivalsCommand& command) {
  CLI::App* const rivals =
      app.add_subcommand("rivals", "Measure planetree and other libraries side by side in one run");
  rivals
      ->add_option(
          "scenes", command.scenes,
          "Models to measure with. Scenes made in code: spheres, a million of them; shapes, "
          "virtual ones of five kinds; terrain-10k, a surface of ten thousand triangles; "
          "scatter-20m, twenty million in small meshes; any number with k or m")
      ->required()
      ->type_name("SCENE");
  rivals
      ->add_option("--measure", command.measures,
                   "What to measure: build, rays, batch (rays, all in one call), "
                   "small-batch (what 1, 8 and 64 rays in a call take more than one by one), "
                   "memory, peak (of memory while building), steps (of planetree's rays)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(measureNames()))
      ->capture_default_str();
  rivals->add_option("--json", command.json, "File to write the results to; - is standard output")
      ->type_name("FILE");
  rivals->add_option("--kinds", command.kinds, "Kinds of rays")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"primary", "ao", "diffuse", "random"}))
      ->capture_default_str();
  rivals
      ->add_option(
          "--engines", command.engines,
          "Libraries, or single modes of them: planetree, embree3, cgal, "
          "embree3:high-robust, ... [all but cgal]. With batches, embree3 takes part with "
          "packets of eight rays, too: embree3:high-packets, ... Only by their full names: "
          "planetree:fast-watertight, planetree:high-watertight and "
          "planetree:textbook-watertight, the other presets, and "
          "planetree:balanced-watertight-float64, which traces in double")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME");
  rivals
      ->add_option(
          "--threads", command.threadCounts,
          "Threads; 0 is 1 for rays and steps, and all of the machine's for builds and "
          "batches. Small batches take 1. Of several numbers, like 1,2, each is measured with")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(0u, 1024u))
      ->capture_default_str();
  rivals
      ->add_option("--repetitions", command.repetitions,
                   "Rounds in which everything is measured once; the best counts")
      ->check(CLI::Range(1u, 1000u))
      ->capture_default_str();
  rivals->add_flag("--quick", command.isQuick, "Fewer rays: a look, not a measurement");
  return rivals;
}

int runRivalsCommand(const RivalsCommand& command) {
  checkInstructionSet();
  checkNames(command.scenes);
  const auto measures = selectMeasures(command.measures);
  const bool countsMemory = std::any_of(measures.begin(), measures.end(),
                                        [](const Measure& m) { return m.countsMemory; });
  if (countsMemory && !heapIsCounted())
    throw UsageError("--measure: this build does not count memory", "Build without sanitizers.");
  for (const std::string& line : whoIsMissing(command.engines))
    say(line);
  const std::vector<Plan> plans = makePlans(command);
  const bool printsJson = command.json == kStandardOutput;
  const bool writesJson = !command.json.empty();
  if (writesJson)
    checkIsWritable(command.json);
  // Before the first is measured, which may take an hour.
  for (const auto& file : command.scenes) {
    if (isFile(file))
      checkIsReadable(file);
  }
  warnOfUnfitMachine();

  std::vector<Result> results;
  for (const auto& file : command.scenes) {
    const auto measured = measureScene(command, sceneFor(file), plans);
    results.insert(results.end(), measured.begin(), measured.end());
    // After each scene: what was measured stays if a later one fails.
    if (writesJson && isReplacedWhenWritten(command.json))
      writeWholeFile(command.json, toJson(results));
  }
  if (writesJson && !isReplacedWhenWritten(command.json))
    writeWholeFile(command.json, toJson(results));
  fmt::print(printsJson ? stderr : stdout, "{}", tables(results));
  return kDone;
}

}  // namespace planetree::bench
