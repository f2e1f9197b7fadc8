#pragma once

#include "support/random.hpp"
#include "unit/shape/reference_shapes.hpp"

#include <planetree/shape/shapes.hpp>

#include <cmath>
#include <utility>

/// Random shapes of all sizes, proportions and positions, and rays that try them where it hurts.
namespace planetree::test {

[[nodiscard]] inline Vec3d inCube(Random& random, double halfSize) {
  return random.pointIn<double>({-halfSize, -halfSize, -halfSize}, {halfSize, halfSize, halfSize});
}

/// A unit vector, often along an axis or in a coordinate plane.
[[nodiscard]] inline Vec3d randomDirection(Random& random) {
  Vec3d v = random.direction();
  for (const Axis axis : kAxes) {
    if (random.chance(0.2))
      v[axis] = random.chance(0.5) ? 0.0 : -0.0;
  }
  return v == Vec3d{} ? Vec3d{0.0, 0.0, 1.0} : normalized(v);
}

/// Rounds to T, and often to float: bounds of such coordinates are exact, with no room to spare.
template <class T>
[[nodiscard]] T rounded(double x, Random& random) {
  return static_cast<T>(random.chance(0.7) ? static_cast<double>(static_cast<float>(x)) : x);
}
template <class T>
[[nodiscard]] Vec3<T> rounded(const Vec3d& v, Random& random) {
  return Vec3<T>(random.chance(0.7) ? Vec3d(Vec3f(v)) : v);
}

/// A random size of the shape: from a flake to a needle.
[[nodiscard]] inline double randomStretch(Random& random) {
  return random.chance(0.5) ? random.between(0.5, 2.0) : std::exp2(random.between(-9.0, 9.0));
}

template <class S>
struct MakeShape;

template <class T>
struct MakeShape<Sphere<T>> {
  static Sphere<T> at(const Vec3d& center, double scale, Random& random) {
    return {rounded<T>(center, random), rounded<T>(scale * random.between(0.5, 2.0), random)};
  }
  static Vec3d remarkablePoint(const Sphere<T>& sphere, Random& random) {
    return Vec3d(sphere.center) + randomDirection(random) * static_cast<double>(sphere.radius);
  }
};

template <class T>
struct MakeShape<Box<T>> {
  static Box<T> at(const Vec3d& center, double scale, Random& random) {
    Vec3d half;
    for (const Axis axis : kAxes)
      half[axis] = scale * randomStretch(random);
    return {rounded<T>(center - half, random), rounded<T>(center + half, random)};
  }
  /// A corner, or a point of an edge or a side.
  static Vec3d remarkablePoint(const Box<T>& box, Random& random) {
    Vec3d point;
    for (const Axis axis : kAxes) {
      const double fraction =
          random.chance(0.3) ? random.between(0.0, 1.0) : static_cast<double>(random.below(2));
      const auto lower = static_cast<double>(box.lower[axis]);
      const auto upper = static_cast<double>(box.upper[axis]);
      point[axis] = fraction == 1.0 ? upper : lower + fraction * (upper - lower);
    }
    return point;
  }
};

template <class T>
struct MakeShape<Square<T>> {
  static Square<T> at(const Vec3d& center, double scale, Random& random) {
    const Vec3d u = randomDirection(random) * scale * random.between(0.5, 2.0);
    Vec3d v = cross(u, random.direction());
    if (random.chance(0.5))
      v = v + u * random.between(-0.5, 0.5);
    return {rounded<T>(center, random), rounded<T>(u, random), rounded<T>(v, random)};
  }
  static Vec3d remarkablePoint(const Square<T>& square, Random& random) {
    const double u =
        random.chance(0.5) ? random.between(-0.5, 0.5) : static_cast<double>(random.below(2)) - 0.5;
    const double v =
        random.chance(0.5) ? random.between(-0.5, 0.5) : static_cast<double>(random.below(2)) - 0.5;
    return Vec3d(square.center) + Vec3d(square.edgeU) * u + Vec3d(square.edgeV) * v;
  }
};

template <class T>
struct MakeShape<Cone<T>> {
  static Cone<T> at(const Vec3d& center, double scale, Random& random) {
    const Vec3d axis = randomDirection(random) * (scale * randomStretch(random));
    const double bottom = scale * randomStretch(random);
    const double top = random.chance(0.5) ? 0.0 : bottom * random.between(0.0, 2.0);
    const bool isUpsideDown = random.chance(0.3);
    return {rounded<T>(center - axis / 2.0, random), rounded<T>(axis, random),
            rounded<T>(isUpsideDown ? top : bottom, random),
            rounded<T>(isUpsideDown ? bottom : top, random), random.chance(0.7)};
  }
  /// A point of a rim, the apex, or a point of a line from apex to base.
  static Vec3d remarkablePoint(const Cone<T>& cone, Random& random) {
    const Vec3d axis(cone.axis);
    const Vec3d across = normalized(cross(axis, random.direction()));
    const double z =
        random.chance(0.4) ? random.between(0.0, 1.0) : static_cast<double>(random.below(2));
    const double radius = (1.0 - z) * static_cast<double>(cone.bottomRadius) +
                          z * static_cast<double>(cone.topRadius);
    return Vec3d(cone.base) + axis * z + across * radius;
  }
};

template <class T>
struct MakeShape<Cylinder<T>> {
  static Cylinder<T> at(const Vec3d& center, double scale, Random& random) {
    const Cone<T> cone = MakeShape<Cone<T>>::at(center, scale, random);
    const T radius = cone.bottomRadius != T(0) ? cone.bottomRadius : cone.topRadius;
    return {cone.base, cone.axis, radius, cone.capped};
  }
  static Vec3d remarkablePoint(const Cylinder<T>& cylinder, Random& random) {
    return MakeShape<Cone<T>>::remarkablePoint(asCone(cylinder), random);
  }
};

template <class T>
struct MakeShape<Triangle<T>> {
  static Triangle<T> at(const Vec3d& center, double scale, Random& random) {
    return {rounded<T>(center, random),
            rounded<T>(center + randomDirection(random) * scale, random),
            rounded<T>(center + inCube(random, scale), random)};
  }
  static Vec3d remarkablePoint(const Triangle<T>& triangle, Random& random) {
    const double along =
        random.chance(0.5) ? random.between(0.0, 1.0) : static_cast<double>(random.below(2));
    return Vec3d(triangle.a) * (1.0 - along) + Vec3d(triangle.b) * along;
  }
};

template <class S>
[[nodiscard]] S randomShape(Random& random) {
  const double scale = std::exp2(random.between(-30.0, 30.0));
  const double offset = random.chance(0.5) ? 0.0 : scale * std::exp2(random.between(-5.0, 10.0));
  return MakeShape<S>::at(inCube(random, offset), scale, random);
}

/// A ray toward the shape: from near and far, along the axes, through edges and rims, from inside,
/// and with a direction of any length.
template <class S, class T = typename S::Scalar>
[[nodiscard]] Ray<T> randomRay(const S& shape, Random& random) {
  const Box3 bounds = shape.bounds();
  const Vec3d center = (Vec3d(bounds.lower) + Vec3d(bounds.upper)) / 2.0;
  const Vec3d half = (Vec3d(bounds.upper) - Vec3d(bounds.lower)) / 2.0;
  const double size = length(half);
  const auto pointInBounds = [&] { return center + random.pointIn<double>(-half, half); };
  const auto target = [&] {
    return random.chance(0.5) ? pointInBounds() : MakeShape<S>::remarkablePoint(shape, random);
  };

  const Vec3d aim = target();
  Vec3d origin;
  switch (random.below(5)) {
    case 0:
      origin = aim + randomDirection(random) * (size * std::exp2(random.between(-3.0, 3.0)));
      break;
    case 1:
      origin = aim + randomDirection(random) * (size * std::exp2(random.between(3.0, 20.0)));
      break;
    case 2:
      origin = pointInBounds();
      break;
    case 3:
      origin = target();
      break;
    default:
      origin = center + inCube(random, 2.0 * size);
      break;
  }
  Vec3d direction = aim - origin;
  if (random.chance(0.2))
    direction = randomDirection(random);
  if (!(length(direction) > 0.0))
    direction = randomDirection(random);
  direction = normalized(direction);
  if (random.chance(0.5))
    direction = direction * std::pow(10.0, random.between(-12.0, 12.0));
  return {Vec3<T>(origin), Vec3<T>(direction)};
}

/// A part of a box, or a bit more than it, as splitting makes cells.
[[nodiscard]] inline Box3 randomCell(const Box3& bounds, Random& random) {
  Box3 cell = bounds;
  for (const Axis axis : kAxes) {
    const auto lower = static_cast<double>(bounds.lower[axis]);
    const double size = static_cast<double>(bounds.upper[axis]) - lower;
    double from = lower + size * random.between(-0.1, 1.1);
    double to = lower + size * random.between(-0.1, 1.1);
    if (from > to)
      std::swap(from, to);
    if (random.chance(0.7))
      cell.lower[axis] = static_cast<float>(from);
    if (random.chance(0.7))
      cell.upper[axis] = static_cast<float>(to);
  }
  return cell;
}

}  // namespace planetree::test
