#pragma once

#include <planetree/object.hpp>

#include <memory>
#include <optional>
#include <utility>

namespace planetree {

/// A virtual base for shapes that are chosen at run time: a tree holds pointers to it. It is one
/// way among others; `std::variant` and plain values need no base (see object.hpp, which also
/// states what each member must do).
template <std::floating_point T>
class Geometry {
 public:
  using Scalar = T;

  virtual ~Geometry() = default;

  [[nodiscard]] virtual Box3 bounds() const = 0;
  [[nodiscard]] virtual std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin,
                                                        T tMax) const noexcept = 0;
  [[nodiscard]] virtual std::optional<Hit<T>> intersectCrossing(const Ray<T>& ray, T tMin,
                                                                T tMax) const noexcept {
    return intersect(ray, tMin, tMax);
  }
  [[nodiscard]] virtual Box3 clippedBounds(const Box3& cell) const {
    return intersection(bounds(), cell);
  }
  [[nodiscard]] virtual int planarSide(Axis /*axis*/) const { return 0; }

 protected:
  Geometry() = default;
  Geometry(const Geometry&) = default;
  Geometry(Geometry&&) = default;
  Geometry& operator=(const Geometry&) = default;
  Geometry& operator=(Geometry&&) = default;
};

/// Any shape as a `Geometry`.
template <Shape S>
class GeometryOf final : public Geometry<typename S::Scalar> {
 public:
  using T = typename S::Scalar;

  explicit GeometryOf(S shape) : shape_(std::move(shape)) {}

  [[nodiscard]] const S& shape() const noexcept { return shape_; }
  [[nodiscard]] Box3 bounds() const override { return shape_.bounds(); }
  [[nodiscard]] std::optional<Hit<T>> intersect(const Ray<T>& ray, T tMin,
                                                T tMax) const noexcept override {
    return shape_.intersect(ray, tMin, tMax);
  }
  [[nodiscard]] std::optional<Hit<T>> intersectCrossing(const Ray<T>& ray, T tMin,
                                                        T tMax) const noexcept override {
    return objectIntersectCrossing(shape_, ray, tMin, tMax);
  }
  [[nodiscard]] Box3 clippedBounds(const Box3& cell) const override {
    return objectClippedBounds(shape_, cell);
  }
  [[nodiscard]] int planarSide(Axis axis) const override { return objectPlanarSide(shape_, axis); }

 private:
  S shape_;
};

/// The shape on the heap, behind the virtual base.
template <Shape S>
[[nodiscard]] std::unique_ptr<Geometry<typename S::Scalar>> makeGeometry(S shape) {
  return std::make_unique<GeometryOf<S>>(std::move(shape));
}

}  // namespace planetree
