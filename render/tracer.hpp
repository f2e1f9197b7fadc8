#pragma once

#include <planetree/kd_tree.hpp>

#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace planetree::render {

/// The questions that rendering asks of a tree, whatever objects it holds. Any thread may ask.
class Tracer {
 public:
  virtual ~Tracer() = default;

  /// The nearest hit of each ray, default-made where it misses, into as many `hits`; returns how
  /// many there are. 0 threads are all of them; see trace_batch.hpp.
  virtual std::size_t findIntersections(std::span<const Rayf> rays, std::span<Hitf> hits,
                                        std::uint32_t threadCount) const = 0;
  /// For each ray 1 if it hits anything, else 0.
  virtual std::size_t areOccluded(std::span<const Rayf> rays, std::span<std::uint8_t> flags,
                                  std::uint32_t threadCount) const = 0;
  /// The same in the caller's thread alone: tiles are shared among threads already.
  [[nodiscard]] std::vector<Hitf> findIntersections(std::span<const Rayf> rays) const {
    std::vector<Hitf> hits(rays.size());
    findIntersections(rays, hits, 1);
    return hits;
  }
  [[nodiscard]] std::vector<std::uint8_t> areOccluded(std::span<const Rayf> rays) const {
    std::vector<std::uint8_t> flags(rays.size());
    areOccluded(rays, flags, 1);
    return flags;
  }
  /// The nearest hit of one ray; adds the work done to `steps`.
  [[nodiscard]] virtual std::optional<Hitf> findIntersection(const Rayf& ray,
                                                             StepCounts& steps) const noexcept = 0;
  /// All hits of one ray in their order; see find_intersections.hpp.
  [[nodiscard]] virtual FoundHits findIntersections(const Rayf& ray,
                                                    std::span<Hitf> hits) const noexcept = 0;
  [[nodiscard]] virtual FoundHits findNextIntersections(const Rayf& ray, const Hitf& after,
                                                        std::span<Hitf> hits) const noexcept = 0;
  [[nodiscard]] virtual Box3 bounds() const noexcept = 0;
  /// All nodes of the tree, depth first, the root in front.
  [[nodiscard]] virtual std::span<const Node> nodes() const noexcept = 0;
};

/// A tree behind the interface, with the choices that all questions have in common. It keeps a copy
/// of the tree, which is cheap: copies share the nodes.
template <Object O>
requires std::same_as < ScalarOf<O>,
float > class TreeTracer final : public Tracer {
 public:
  explicit TreeTracer(KdTree<O> tree, const QueryOptions& query = {})
      : tree_(std::move(tree)), query_(query) {}

  using Tracer::areOccluded;
  using Tracer::findIntersections;
  std::size_t findIntersections(std::span<const Rayf> rays, std::span<Hitf> hits,
                                std::uint32_t threadCount) const override {
    return tree_.findIntersections(rays, hits, {.query = query_, .threadCount = threadCount});
  }
  std::size_t areOccluded(std::span<const Rayf> rays, std::span<std::uint8_t> flags,
                          std::uint32_t threadCount) const override {
    return tree_.areOccluded(rays, flags, {.query = query_, .threadCount = threadCount});
  }
  [[nodiscard]] std::optional<Hitf> findIntersection(const Rayf& ray,
                                                     StepCounts& steps) const noexcept override {
    return tree_.findIntersection(ray, steps, query_);
  }
  [[nodiscard]] FoundHits findIntersections(const Rayf& ray,
                                            std::span<Hitf> hits) const noexcept override {
    return tree_.findIntersections(ray, hits, query_);
  }
  [[nodiscard]] FoundHits findNextIntersections(const Rayf& ray, const Hitf& after,
                                                std::span<Hitf> hits) const noexcept override {
    return tree_.findNextIntersections(ray, after, hits, query_);
  }
  [[nodiscard]] Box3 bounds() const noexcept override { return tree_.bounds(); }
  [[nodiscard]] std::span<const Node> nodes() const noexcept override { return tree_.nodes(); }

 private:
  KdTree<O> tree_;
  QueryOptions query_;
};

/// A tracer as one task uses it: it counts the rays, and the time that their batches take.
class RayCounter {
 public:
  explicit RayCounter(const Tracer& tracer) noexcept : tracer_(tracer) {}

  [[nodiscard]] std::vector<Hitf> findIntersections(std::span<const Rayf> rays) {
    rayCount_ += rays.size();
    const Stopwatch watch(tracingSeconds_);
    return tracer_.findIntersections(rays);
  }
  [[nodiscard]] std::vector<std::uint8_t> areOccluded(std::span<const Rayf> rays) {
    rayCount_ += rays.size();
    const Stopwatch watch(tracingSeconds_);
    return tracer_.areOccluded(rays);
  }
  /// What finding the nearest hit of each ray takes, ray by ray, and whether there is one.
  struct CountedSearch {
    StepCounts steps;
    bool isHit = false;
  };
  [[nodiscard]] std::vector<CountedSearch> countSteps(std::span<const Rayf> rays) {
    rayCount_ += rays.size();
    const Stopwatch watch(tracingSeconds_);
    std::vector<CountedSearch> searches(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
      searches[i].isHit = tracer_.findIntersection(rays[i], searches[i].steps).has_value();
    return searches;
  }

  [[nodiscard]] FoundHits findIntersections(const Rayf& ray, std::span<Hitf> hits) noexcept {
    ++rayCount_;
    const Stopwatch watch(tracingSeconds_);
    return tracer_.findIntersections(ray, hits);
  }
  /// Goes on with a ray that has been counted.
  [[nodiscard]] FoundHits findNextIntersections(const Rayf& ray, const Hitf& after,
                                                std::span<Hitf> hits) noexcept {
    const Stopwatch watch(tracingSeconds_);
    return tracer_.findNextIntersections(ray, after, hits);
  }

  [[nodiscard]] std::uint64_t rayCount() const noexcept { return rayCount_; }
  /// Spent with all of these.
  [[nodiscard]] double tracingSeconds() const noexcept { return tracingSeconds_; }

 private:
  /// Adds the time that it lives.
  class Stopwatch {
   public:
    explicit Stopwatch(double& seconds) noexcept : seconds_(seconds), start_(Clock::now()) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

   private:
    using Clock = std::chrono::steady_clock;
    double& seconds_;
    Clock::time_point start_;
  };

  const Tracer& tracer_;
  std::uint64_t rayCount_ = 0;
  double tracingSeconds_ = 0.0;
};

}  // namespace planetree::render
