#pragma once

#include <planetree/detail/hit_sink.hpp>
#include <planetree/geometry/sheared_ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/object.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace planetree::detail {

/// What a leaf found in one run of its references.
struct LeafAnswer {
  bool found = false;
  std::uint32_t testedCount = 0;
};

/// A run of objects of one geometry, as a leaf lists them: `references` are the tree's object
/// numbers, `firstObject` is the number of the geometry's primitive 0.
struct LeafRun {
  std::span<const std::uint32_t> references;
  std::uint32_t firstObject = 0;
  std::uint32_t geometry = 0;
};

/// How traversal reaches objects whose type it does not know: plain functions that take the address
/// of an object range. Called once per leaf, so that the indirect call is shared by its objects.
template <class T>
struct IntersectionTable {
  /// Replaces `hit` by the first, in the order of `isBefore`, of itself and the hits of the run
  /// with t in [tMin, tMax].
  LeafAnswer (*findNearest)(const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                            T tMax, Hit<T>& hit) noexcept;

  /// Stops at the first object that is hit with t in [tMin, tMax].
  LeafAnswer (*findAny)(const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                        T tMax) noexcept;

  /// Offers the sink every hit of the run with t in [tMin, sink.tMax], each object's in rising
  /// order. `found` tells whether one was kept.
  LeafAnswer (*offerHits)(const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                          HitSink<T>& sink) noexcept;
};

/// The same loop over a leaf for every kind of object; `intersect(primitive, tMin, tMax)` returns
/// an optional hit without ids.
template <class T, class Intersect>
LeafAnswer findNearestInRun(const LeafRun& run, T tMin, T tMax, Hit<T>& hit,
                            Intersect&& intersect) noexcept {
  LeafAnswer answer;
  answer.testedCount = static_cast<std::uint32_t>(run.references.size());
  for (const std::uint32_t object : run.references) {
    const std::uint32_t primitive = object - run.firstObject;
    std::optional<Hit<T>> candidate = intersect(primitive, tMin, hit.t < tMax ? hit.t : tMax);
    if (!candidate)
      continue;
    candidate->geometry = run.geometry;
    candidate->primitive = primitive;
    if (!isBefore(*candidate, hit))
      continue;
    hit = *candidate;
    answer.found = true;
  }
  return answer;
}

template <class T, class Intersect>
LeafAnswer findAnyInRun(const LeafRun& run, T tMin, T tMax, Intersect&& intersect) noexcept {
  LeafAnswer answer;
  for (const std::uint32_t object : run.references) {
    ++answer.testedCount;
    if (intersect(object - run.firstObject, tMin, tMax)) {
      answer.found = true;
      return answer;
    }
  }
  return answer;
}

/// Asks each object again from behind its last hit, until it has no more. A shape that breaks its
/// promise about the interval is not asked again: the loop must end.
template <class T, class Intersect>
LeafAnswer offerHitsInRun(const LeafRun& run, T tMin, HitSink<T>& sink,
                          Intersect&& intersect) noexcept {
  LeafAnswer answer;
  for (const std::uint32_t object : run.references) {
    if (!(tMin <= sink.tMax))
      return answer;
    ++answer.testedCount;
    const std::uint32_t primitive = object - run.firstObject;
    for (T from = tMin; from <= sink.tMax;) {
      std::optional<Hit<T>> hit = intersect(primitive, from, sink.tMax);
      if (!hit || !(hit->t >= from && hit->t <= sink.tMax))
        break;
      from = justBehind(hit->t);
      hit->geometry = run.geometry;
      hit->primitive = primitive;
      answer.found |= sink.offer(*hit);
    }
  }
  return answer;
}

/// The table for a range of objects: anything with `operator[]` that gives an `Object`.
template <class Range, class T>
inline constexpr IntersectionTable<T> kIntersectionTable = {
    .findNearest = [](const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                      T tMax, Hit<T>& hit) noexcept -> LeafAnswer {
      const Range& shapes = *static_cast<const Range*>(range);
      return findNearestInRun<T>(run, tMin, tMax, hit, [&](std::uint32_t primitive, T from, T to) {
        return objectIntersect(shapes[primitive], ray.ray, from, to);
      });
    },
    .findAny = [](const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                  T tMax) noexcept -> LeafAnswer {
      const Range& shapes = *static_cast<const Range*>(range);
      return findAnyInRun<T>(run, tMin, tMax, [&](std::uint32_t primitive, T from, T to) {
        return objectIntersect(shapes[primitive], ray.ray, from, to).has_value();
      });
    },
    .offerHits = [](const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                    HitSink<T>& sink) noexcept -> LeafAnswer {
      const Range& shapes = *static_cast<const Range*>(range);
      return offerHitsInRun<T>(run, tMin, sink, [&](std::uint32_t primitive, T from, T to) {
        return sink.crossings ? objectIntersectCrossing(shapes[primitive], ray.ray, from, to)
                              : objectIntersect(shapes[primitive], ray.ray, from, to);
      });
    },
};

}  // namespace planetree::detail
