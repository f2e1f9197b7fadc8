#pragma once

#include <planetree/kd_tree.hpp>

#include <concepts>
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

  /// The nearest hit of each ray, default-made where it misses. Works in the caller's thread alone,
  /// as tiles are shared among threads already.
  [[nodiscard]] virtual std::vector<Hitf> findIntersections(std::span<const Rayf> rays) const = 0;
  /// For each ray 1 if it hits anything, else 0; in the same thread, too.
  [[nodiscard]] virtual std::vector<std::uint8_t> areOccluded(std::span<const Rayf> rays) const = 0;
  /// The nearest hit of one ray; adds the work done to `steps`.
  [[nodiscard]] virtual std::optional<Hitf> findIntersection(const Rayf& ray,
                                                             StepCounts& steps) const noexcept = 0;
  [[nodiscard]] virtual Box3 bounds() const noexcept = 0;
  /// All nodes of the tree, depth first, the root in front.
  [[nodiscard]] virtual std::span<const Node> nodes() const noexcept = 0;
};

/// A tree behind the interface. It keeps a copy of the tree, which is cheap: copies share the
/// nodes.
template <Object O>
requires std::same_as < ScalarOf<O>,
float > class TreeTracer final : public Tracer {
 public:
  explicit TreeTracer(KdTree<O> tree) : tree_(std::move(tree)) {}

  [[nodiscard]] std::vector<Hitf> findIntersections(std::span<const Rayf> rays) const override {
    std::vector<Hitf> hits(rays.size());
    tree_.findIntersections(rays, hits, {.threadCount = 1});
    return hits;
  }
  [[nodiscard]] std::vector<std::uint8_t> areOccluded(std::span<const Rayf> rays) const override {
    std::vector<std::uint8_t> flags(rays.size());
    tree_.areOccluded(rays, flags, {.threadCount = 1});
    return flags;
  }
  [[nodiscard]] std::optional<Hitf> findIntersection(const Rayf& ray,
                                                     StepCounts& steps) const noexcept override {
    return tree_.findIntersection(ray, steps);
  }
  [[nodiscard]] Box3 bounds() const noexcept override { return tree_.bounds(); }
  [[nodiscard]] std::span<const Node> nodes() const noexcept override { return tree_.nodes(); }

 private:
  KdTree<O> tree_;
};

/// A tracer as one task uses it: it counts the rays.
class RayCounter {
 public:
  explicit RayCounter(const Tracer& tracer) noexcept : tracer_(tracer) {}

  [[nodiscard]] std::vector<Hitf> findIntersections(std::span<const Rayf> rays) {
    rayCount_ += rays.size();
    return tracer_.findIntersections(rays);
  }
  [[nodiscard]] std::vector<std::uint8_t> areOccluded(std::span<const Rayf> rays) {
    rayCount_ += rays.size();
    return tracer_.areOccluded(rays);
  }
  [[nodiscard]] std::optional<Hitf> findIntersection(const Rayf& ray, StepCounts& steps) noexcept {
    ++rayCount_;
    return tracer_.findIntersection(ray, steps);
  }

  [[nodiscard]] std::uint64_t rayCount() const noexcept { return rayCount_; }

 private:
  const Tracer& tracer_;
  std::uint64_t rayCount_ = 0;
};

}  // namespace planetree::render
