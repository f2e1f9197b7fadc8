#pragma once

#include <planetree/detail/object_range.hpp>
#include <planetree/object.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace planetree {

/// One object of a scene, whatever its type: a handle that names a primitive of a geometry. It is
/// itself a `Shape`, and what a `KdTree` over a `Scene` holds. It must not outlive the tree. A
/// handle to an object that was skipped must not be asked for anything but its ids.
template <std::floating_point T>
class AnyObject {
 public:
  using Scalar = T;

  AnyObject(const detail::GeometryEntry<T>& entry, std::uint32_t geometry,
            std::uint32_t primitive) noexcept
      : entry_(&entry), geometry_(geometry), primitive_(primitive) {}

  [[nodiscard]] std::uint32_t geometry() const noexcept { return geometry_; }
  [[nodiscard]] std::uint32_t primitive() const noexcept { return primitive_; }

  [[nodiscard]] Box3 bounds() const { return bounded().reference.bounds; }

  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const {
    Reference reference = bounded().reference;
    reference.object = primitive_;
    entry_->bounding->clip(entry_->range, 0, cell, std::span(&reference, 1));
    return reference.bounds;
  }

  [[nodiscard]] int planarSide(Axis axis) const {
    return bounded().reference.belongsLeft(axis) ? -1 : 1;
  }

  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
    const detail::LeafRun run{std::span(&primitive_, 1), 0, geometry_};
    Hit<T> hit;
    const bool found =
        entry_->intersecting->findNearest(entry_->range, run, ShearedRay<T>(ray), tMin, tMax, hit)
            .found;
    return found ? std::optional(hit) : std::nullopt;
  }
  [[nodiscard]] std::optional<Hit<T>> intersectCrossing(const Ray<T>& ray, T tMin,
                                                        T tMax) const noexcept {
    const detail::LeafRun run{std::span(&primitive_, 1), 0, geometry_};
    detail::FirstHitSink<T> sink(tMax, true);
    const bool found =
        entry_->intersecting->offerHits(entry_->range, run, ShearedRay<T>(ray), tMin, sink).found;
    return found ? std::optional(sink.hit) : std::nullopt;
  }

 private:
  [[nodiscard]] detail::BoundedObject bounded() const {
    detail::BoundedObject object;
    entry_->bounding->bound(entry_->range, primitive_, std::span(&object, 1));
    return object;
  }

  const detail::GeometryEntry<T>* entry_;
  std::uint32_t geometry_;
  std::uint32_t primitive_;
};

}  // namespace planetree
