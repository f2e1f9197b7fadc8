#include "compare/compare_presets.hpp"

#include <planetree/split/cost_model.hpp>

#include <algorithm>
#include <chrono>
#include <limits>
#include <span>
#include <utility>

namespace planetree::tool {

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// If all builds together take longer, once is enough: the longer they take, the less they vary.
constexpr double kLongBuildSeconds = 1.0;

template <class Work>
double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double millionsPerSecond(std::size_t count, double seconds) {
  return count == 0 ? 0.0 : static_cast<double>(count) / std::max(seconds, 1e-9) / 1e6;
}

double comparableSahCost(const render::Tracer& tracer, double objectCost) {
  return treeStatistics(
             tracer.nodes(), tracer.bounds(),
             {.traversalCost = CostModel{}.traversalCost, .intersectionCost = objectCost})
      .sahCost;
}

/// The least seconds of the rounds, of each kind of rays.
struct BestSeconds {
  double primary = kForever;
  double ao = kForever;
  double random = kForever;
};

}  // namespace

void PresetComparison::build(const std::vector<std::string>& names,
                             const std::function<Subject(std::size_t)>& build) {
  figures_.clear();
  double seconds = 0.0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Subject subject = build(i);
    const double buildSeconds = subject.report.totalSeconds;
    seconds += buildSeconds;
    const double sahCost = comparableSahCost(*subject.tracer, settings_.objectCost);
    figures_.push_back({.name = names[i],
                        .subject = std::move(subject),
                        .buildSeconds = buildSeconds,
                        .sahCost = sahCost,
                        .steps = {},
                        .speeds = {}});
  }
  for (std::uint32_t round = 1; round < settings_.roundCount && seconds < kLongBuildSeconds;
       ++round) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      double& best = figures_[i].buildSeconds;
      best = std::min(best, build(i).report.totalSeconds);
    }
  }
}

void PresetComparison::trace(const ComparisonRays& rays,
                             const std::function<void(double done)>& onProgress) {
  std::vector<Hitf> hits(std::max(rays.primary.size(), rays.random.size()));
  std::vector<std::uint8_t> flags(rays.ao.size());
  const auto seconds = [&](const render::Tracer& tracer, const std::vector<Rayf>& asked) {
    return secondsOf([&] {
      tracer.findIntersections(asked, std::span(hits).first(asked.size()), settings_.threadCount);
    });
  };
  std::vector<BestSeconds> best(figures_.size());
  const double turnCount = static_cast<double>(settings_.roundCount * figures_.size());
  for (std::uint32_t round = 0; round < settings_.roundCount; ++round) {
    for (std::size_t turn = 0; turn < figures_.size(); ++turn) {
      const std::size_t i = (turn + round) % figures_.size();
      const render::Tracer& tracer = *figures_[i].subject.tracer;
      best[i].primary = std::min(best[i].primary, seconds(tracer, rays.primary));
      best[i].ao = std::min(best[i].ao, secondsOf([&] {
                              tracer.areOccluded(rays.ao, std::span(flags), settings_.threadCount);
                            }));
      best[i].random = std::min(best[i].random, seconds(tracer, rays.random));
      onProgress(static_cast<double>(round * figures_.size() + turn + 1) / turnCount);
    }
  }
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    figures_[i].speeds = {.primary = millionsPerSecond(rays.primary.size(), best[i].primary),
                          .ao = millionsPerSecond(rays.ao.size(), best[i].ao),
                          .random = millionsPerSecond(rays.random.size(), best[i].random)};
    for (const Rayf& ray : rays.primary)
      static_cast<void>(figures_[i].subject.tracer->findIntersection(ray, figures_[i].steps));
  }
}

}  // namespace planetree::tool
