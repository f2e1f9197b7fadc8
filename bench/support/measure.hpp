#pragma once

#include "bench/rivals/engines.hpp"
#include "bench/scene/load_scene.hpp"
#include "bench/support/answer_check.hpp"
#include "bench/support/ray_kinds.hpp"
#include "bench/support/result.hpp"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

/// Measuring all engines on one scene, side by side.
namespace planetree::bench {

struct MeasureSettings {
  unsigned threadCount = 1;       ///< of what is measured
  unsigned buildThreadCount = 1;  ///< of builds that are not measured
  unsigned repetitions = 5;       ///< rounds, of which the best counts for each engine
  std::vector<RayKind> kinds{kRayKinds.begin(), kRayKinds.end()};
  RayCounts counts;
  /// The same engines were checked on the same scene before: what traces no rays is measured
  /// without another check.
  bool areAnswersChecked = false;
  /// Tests of single objects that the brute force of one kind of rays may take: it decides how many
  /// rays are in the sample.
  std::size_t bruteForceTests = 400'000'000;
  /// What the measurements have to say beside their results, a line at a time.
  std::function<void(const std::string&)> say = [](const std::string&) {};
};

/// An engine has given wrong answers; nothing more is timed.
class WrongAnswers : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Each checks the answers of all engines first, tells every disagreement, and throws `WrongAnswers`
// if one is not acceptable. The results are in the order of the engines.

/// `mrays_per_second` of each kind of rays.
[[nodiscard]] std::vector<Result> measureRays(const BenchScene& scene, const EngineList& engines,
                                              const MeasureSettings& settings);

/// `batch_mrays_per_second` of each kind of rays, all of them handed over in one call; ray by ray
/// to libraries that have no call for many. What a library does to lay the rays out beforehand is
/// not measured.
[[nodiscard]] std::vector<Result> measureBatches(const BenchScene& scene, const EngineList& engines,
                                                 const MeasureSettings& settings);

/// `nanoseconds_one_by_one`, of a ray, and for each of `kSmallBatches` `nanoseconds_of_a_batch_of_`
/// so many, both for each kind of rays, whose rays are handed over in their order, from one thread.
/// Engines that take no batches have no results.
[[nodiscard]] std::vector<Result> measureSmallBatches(const BenchScene& scene,
                                                      const EngineList& engines,
                                                      const MeasureSettings& settings);

/// `build_seconds`: from the arrays to the first ray traced. The threads, and what else a library
/// sets up once for a program, are there before.
[[nodiscard]] std::vector<Result> measureBuild(const BenchScene& scene, const EngineList& engines,
                                               const MeasureSettings& settings);

/// `peak_bytes_per_triangle`, or for each shape: the most memory held at a time while building, the
/// finished structure included, but not the arrays that it is made from, which all read. The least
/// of two builds. Throws `std::logic_error` where `heapIsCounted()` says no.
[[nodiscard]] std::vector<Result> measurePeak(const BenchScene& scene, const EngineList& engines,
                                              const MeasureSettings& settings);

/// `node_steps_per_ray` and `block_steps_per_ray`, both of the wide form, of each kind
/// of rays, averages of all rays. Engines that do not count steps have no results.
[[nodiscard]] std::vector<Result> measureSteps(const BenchScene& scene, const EngineList& engines,
                                               const MeasureSettings& settings);

/// `bytes_per_triangle`, or for each shape: the memory held by the finished structure, and the
/// arrays of the mesh where queries read them. The least of two builds: the first also pays for
/// what is set up once. Throws `std::logic_error` where `heapIsCounted()` says no.
[[nodiscard]] std::vector<Result> measureMemory(const BenchScene& scene, const EngineList& engines,
                                                const MeasureSettings& settings);

}  // namespace planetree::bench
