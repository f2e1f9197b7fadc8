#pragma once

#include <planetree/kd_tree.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace planetree::test {

template <class T>
bool pointsSomewhere(const Ray<T>& ray) {
  return isFinite(ray.origin) && isFinite(ray.direction) && ray.direction != Vec3<T>{};
}

/// The oracle: tests every object of the tree's geometries one by one, without the tree.
template <Object O>
std::optional<Hit<ScalarOf<O>>> bruteForce(const KdTree<O>& tree, const Ray<ScalarOf<O>>& ray,
                                           std::uint32_t mask = 0xFFFF'FFFFu) {
  using T = ScalarOf<O>;
  Hit<T> nearest;
  if (!pointsSomewhere(ray))
    return std::nullopt;
  for (std::uint32_t geometry = 0; geometry < tree.geometryCount(); ++geometry) {
    if ((tree.geometryMask(geometry) & mask) == 0)
      continue;
    const auto count = static_cast<std::uint32_t>(tree.primitiveCount(geometry));
    for (std::uint32_t primitive = 0; primitive < count; ++primitive) {
      const auto& object = tree.object(geometry, primitive);
      const Box3 bounds = objectBounds(object);
      if (bounds.isEmpty() || !isFinite(bounds.lower) || !isFinite(bounds.upper))
        continue;
      auto hit = objectIntersect(object, ray, ray.tMin, ray.tMax);
      if (!hit || !std::isfinite(hit->t))
        continue;
      hit->geometry = geometry;
      hit->primitive = primitive;
      if (isBefore(*hit, nearest))
        nearest = *hit;
    }
  }
  if (nearest.primitive == kNoId)
    return std::nullopt;
  return nearest;
}

}  // namespace planetree::test
