#include "shape/centered_ray.hpp"
#include "shape/outward.hpp"

#include <planetree/geometry/rounding.hpp>
#include <planetree/shape/box.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace planetree {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where the ray passes the plane of one side.
struct Crossing {
  double t;
  Axis axis = Axis::X;
  bool isUpper = false;
};

/// True if the box holds at least a point; false also if a member is NaN.
template <class T>
[[nodiscard]] bool hasSurface(const Box<T>& box) noexcept {
  return isFinite(box.lower) && isFinite(box.upper) && box.lower.x <= box.upper.x &&
         box.lower.y <= box.upper.y && box.lower.z <= box.upper.z;
}

/// The position of `coordinate` between the bounds, as a fraction; 0 where the box is flat.
[[nodiscard]] double fractionBetween(double lower, double upper, double coordinate) noexcept {
  return lower < upper ? std::clamp((coordinate - lower) / (upper - lower), 0.0, 1.0) : 0.0;
}

template <class T>
[[nodiscard]] Hit<T> hitOnSide(const Box<T>& box, const Ray<T>& ray, T t,
                               const Crossing& crossing) noexcept {
  const Axis uAxis = nextAxis(crossing.axis);
  const Axis vAxis = nextAxis(uAxis);
  const auto fractionAlong = [&](Axis axis) {
    const double coordinate = static_cast<double>(ray.origin[axis]) +
                              crossing.t * static_cast<double>(ray.direction[axis]);
    return static_cast<T>(fractionBetween(static_cast<double>(box.lower[axis]),
                                          static_cast<double>(box.upper[axis]), coordinate));
  };
  Hit<T> hit;
  hit.t = t;
  hit.u = fractionAlong(uAxis);
  hit.v = fractionAlong(vAxis);
  hit.normal[crossing.axis] = crossing.isUpper ? T(1) : T(-1);
  hit.part = 2 * static_cast<std::uint32_t>(crossing.axis) + (crossing.isUpper ? 1u : 0u);
  return hit;
}

}  // namespace

template <std::floating_point T>
Box3 Box<T>::bounds() const noexcept {
  if (!isFinite(lower) || !isFinite(upper))
    return detail::notFiniteBox();
  if (!hasSurface(*this))
    return {};
  Box3 box;
  box.extend(lower);
  box.extend(upper);
  return box;
}

template <std::floating_point T>
Box3 Box<T>::clippedBounds(const Box3& cell) const noexcept {
  const Box3 whole = bounds();
  Box3 clipped;
  if (whole.isEmpty())
    return clipped;
  for (const Axis axis : kAxes) {
    for (const T position : {lower[axis], upper[axis]}) {
      Box3 side = whole;
      side.lower[axis] = roundDown(static_cast<double>(position));
      side.upper[axis] = roundUp(static_cast<double>(position));
      const Box3 inside = intersection(side, cell);
      if (!inside.isEmpty())
        clipped.extend(inside);
    }
  }
  return clipped;
}

template <std::floating_point T>
std::optional<Hit<T>> Box<T>::intersect(const Ray<T>& ray, T tMin, T tMax) const noexcept {
  if (!hasSurface(*this) || !isFinite(ray.origin) || !isFinite(ray.direction))
    return std::nullopt;

  // Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986. Equal planes give equal t whatever
  // box they belong to, and the order of t is exact: hence no leak between boxes, nor at edges.
  Crossing entry{.t = -kInfinity};
  Crossing exit{.t = kInfinity};
  for (const Axis axis : kAxes) {
    const auto origin = static_cast<double>(ray.origin[axis]);
    const auto direction = static_cast<double>(ray.direction[axis]);
    const auto lowerPlane = static_cast<double>(lower[axis]);
    const auto upperPlane = static_cast<double>(upper[axis]);
    if (direction == 0.0) {
      if (origin < lowerPlane || origin > upperPlane)
        return std::nullopt;
      continue;
    }
    const bool isRising = direction > 0.0;
    const double nearT = ((isRising ? lowerPlane : upperPlane) - origin) / direction;
    const double farT = ((isRising ? upperPlane : lowerPlane) - origin) / direction;
    if (nearT > entry.t)
      entry = {nearT, axis, !isRising};
    if (farT < exit.t)
      exit = {farT, axis, isRising};
  }
  if (entry.t > exit.t)
    return std::nullopt;

  for (const Crossing& crossing : {entry, exit}) {
    const T t = static_cast<T>(crossing.t);
    if (detail::isWithin(t, tMin, tMax))
      return hitOnSide(*this, ray, t, crossing);
  }
  return std::nullopt;
}

template struct Box<float>;
template struct Box<double>;

}  // namespace planetree
