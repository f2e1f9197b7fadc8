#pragma once

#include "compare/comparison_rays.hpp"
#include "subject.hpp"

#include <planetree/traversal/step_counts.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace planetree::tool {

/// How many rays of each kind a second answers, in millions; 0 where there are none.
struct RaySpeeds {
  double primary = 0.0;
  double ao = 0.0;
  double random = 0.0;
};

/// One preset and what it makes of a subject.
struct PresetFigures {
  std::string name;
  Subject subject;
  double buildSeconds = 0.0;
  /// By the costs of `BuildOptions`'s defaults, whatever the preset itself believes: so that trees
  /// can be compared.
  double sahCost = 0.0;
  StepCounts steps;  ///< of all primary rays together
  RaySpeeds speeds;

  [[nodiscard]] std::uint64_t nodeCount() const noexcept {
    return subject.statistics.splitNodeCount + subject.statistics.leafNodeCount;
  }
};

/// Measures one thing after the other, in rounds that take each preset in turn, so that what else
/// happens on the machine strikes all alike. The best of the rounds counts.
class PresetComparison {
 public:
  struct Settings {
    std::uint32_t threadCount = 0;  ///< of batches; 0 is as many as there are
    std::uint32_t roundCount = 5;
    double objectCost = 0.0;  ///< of one object in a leaf, for the costs that can be compared
  };

  explicit PresetComparison(const Settings& settings) noexcept : settings_(settings) {}

  /// Builds the tree of each preset; `build` makes the one with that number. Quick builds are done
  /// again in the later rounds.
  void build(const std::vector<std::string>& names,
             const std::function<Subject(std::size_t)>& build);

  /// Traces the rays through all trees, and tells what part of that is done.
  void trace(
      const ComparisonRays& rays,
      const std::function<void(double done)>& onProgress = [](double) {});

  [[nodiscard]] const std::vector<PresetFigures>& figures() const noexcept { return figures_; }

 private:
  Settings settings_;
  std::vector<PresetFigures> figures_;
};

}  // namespace planetree::tool
