#pragma once

#include <planetree/kd_tree.hpp>

#include "support/brute_force.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace planetree::test {

/// Every hit of one object in [ray.tMin, ray.tMax], asking it again from behind each.
template <Object O>
std::vector<Hit<ScalarOf<O>>> hitsOfObject(const O& object, const Ray<ScalarOf<O>>& ray,
                                           bool crossings) {
  using T = ScalarOf<O>;
  const T last = std::min(ray.tMax, std::numeric_limits<T>::max());
  std::vector<Hit<T>> hits;
  for (T from = ray.tMin; from <= last;) {
    const auto hit = crossings ? objectIntersectCrossing(object, ray, from, last)
                               : objectIntersect(object, ray, from, last);
    if (!hit)
      break;
    hits.push_back(*hit);
    from = nextUp(hit->t);
    // Denormals may count as zero.
    if (!(from > hit->t))
      from = std::numeric_limits<T>::min();
  }
  return hits;
}

/// The oracle for queries with choices: every hit of every object that the options accept, sorted.
template <Object O>
std::vector<Hit<ScalarOf<O>>> bruteForceHits(const KdTree<O>& tree, const Ray<ScalarOf<O>>& ray,
                                             const QueryOptions& options = {}) {
  using T = ScalarOf<O>;
  std::vector<Hit<T>> hits;
  if (!pointsSomewhere(ray) || std::isnan(ray.tMin) || std::isnan(ray.tMax))
    return hits;
  for (std::uint32_t geometry = 0; geometry < tree.geometryCount(); ++geometry) {
    if ((tree.geometryMask(geometry) & options.mask) == 0)
      continue;
    const auto count = static_cast<std::uint32_t>(tree.primitiveCount(geometry));
    for (std::uint32_t primitive = 0; primitive < count; ++primitive) {
      if (options.skip == PrimitiveId{geometry, primitive})
        continue;
      const auto& object = tree.object(geometry, primitive);
      const Box3 bounds = objectBounds(object);
      if (bounds.isEmpty() || !isFinite(bounds.lower) || !isFinite(bounds.upper))
        continue;
      for (Hit<T> hit : hitsOfObject(object, ray, options.crossings)) {
        hit.geometry = geometry;
        hit.primitive = primitive;
        const bool isFromBehind = !(dot(hit.normal, ray.direction) < T(0));
        if (!(options.cullsBackFaces && isFromBehind) && options.filter.accepts(hit))
          hits.push_back(hit);
      }
    }
  }
  std::sort(hits.begin(), hits.end(), isBefore<T>);
  return hits;
}

}  // namespace planetree::test
