#pragma once

#include <planetree/kd_tree.hpp>

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace planetree::render {

/// The questions that rendering asks of a tree, whatever objects it holds. Any thread may ask.
class Tracer {
 public:
  virtual ~Tracer() = default;

  [[nodiscard]] virtual std::optional<Hitf> findIntersection(const Rayf& ray) const noexcept = 0;
  /// The same, and adds the work done to `steps`.
  [[nodiscard]] virtual std::optional<Hitf> findIntersection(const Rayf& ray,
                                                             StepCounts& steps) const noexcept = 0;
  [[nodiscard]] virtual bool isOccluded(const Rayf& ray) const noexcept = 0;
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

  [[nodiscard]] std::optional<Hitf> findIntersection(const Rayf& ray) const noexcept override {
    return tree_.findIntersection(ray);
  }
  [[nodiscard]] std::optional<Hitf> findIntersection(const Rayf& ray,
                                                     StepCounts& steps) const noexcept override {
    return tree_.findIntersection(ray, steps);
  }
  [[nodiscard]] bool isOccluded(const Rayf& ray) const noexcept override {
    return tree_.isOccluded(ray);
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

  [[nodiscard]] std::optional<Hitf> findIntersection(const Rayf& ray) noexcept {
    ++rayCount_;
    return tracer_.findIntersection(ray);
  }
  [[nodiscard]] std::optional<Hitf> findIntersection(const Rayf& ray, StepCounts& steps) noexcept {
    ++rayCount_;
    return tracer_.findIntersection(ray, steps);
  }
  [[nodiscard]] bool isOccluded(const Rayf& ray) noexcept {
    ++rayCount_;
    return tracer_.isOccluded(ray);
  }

  [[nodiscard]] std::uint64_t rayCount() const noexcept { return rayCount_; }

 private:
  const Tracer& tracer_;
  std::uint64_t rayCount_ = 0;
};

}  // namespace planetree::render
