#pragma once

#include <planetree/geometry/sheared_ray.hpp>
#include <planetree/object.hpp>
#include <planetree/split/build_report.hpp>
#include <planetree/split/reference.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace planetree::detail {

/// An object as the builder receives it.
struct BoundedObject {
  Reference reference;
  std::optional<SkipReason> skipReason;  ///< set if the object cannot enter the tree
};

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

/// How the compiled core reaches objects whose type it does not know: plain functions that take the
/// address of an object range. Called once per batch while building and once per leaf while
/// tracing, so that the indirect call is shared by many objects.
template <class T>
struct ObjectTable {
  /// Bounds the primitives `first`, `first + 1`, ...: one for each entry of `objects`. The object
  /// numbers are left unset.
  void (*bound)(const void* range, std::uint32_t first, std::span<BoundedObject> objects);

  /// Shrinks the box of each reference to what its object has inside the cell.
  void (*clip)(const void* range, std::uint32_t firstObject, const Box3& cell,
               std::span<Reference> references);

  /// Replaces `hit` by the first, in the order of `isBefore`, of itself and the hits of the run
  /// with t in [tMin, tMax].
  LeafAnswer (*findNearest)(const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                            T tMax, Hit<T>& hit) noexcept;

  /// Stops at the first object that is hit with t in [tMin, tMax].
  LeafAnswer (*findAny)(const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                        T tMax) noexcept;
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

/// An object in the form the builder takes, or the reason why it cannot be taken.
template <Object O>
[[nodiscard]] BoundedObject boundObject(const O& object) {
  BoundedObject bounded;
  Reference& reference = bounded.reference;
  reference.bounds = objectBounds(object);
  for (const Axis axis : kAxes) {
    if (objectPlanarSide(object, axis) < 0)
      reference.leftSides |= 1u << static_cast<unsigned>(axis);
  }
  if (reference.bounds == Box3{}) {
    bounded.skipReason = SkipReason::Empty;
  } else if (!isFinite(reference.bounds.lower) || !isFinite(reference.bounds.upper)) {
    bounded.skipReason = SkipReason::NotFinite;
  } else if (reference.bounds.isEmpty()) {
    bounded.skipReason = SkipReason::Empty;
  }
  return bounded;
}

/// The table for a range of objects: anything with `operator[]` that gives an `Object`.
template <class Range, class T>
inline constexpr ObjectTable<T> kObjectTable = {
    .bound =
        [](const void* range, std::uint32_t first, std::span<BoundedObject> objects) {
          const Range& shapes = *static_cast<const Range*>(range);
          for (BoundedObject& object : objects)
            object = boundObject(shapes[first++]);
        },
    .clip =
        [](const void* range, std::uint32_t firstObject, const Box3& cell,
           std::span<Reference> references) {
          const Range& shapes = *static_cast<const Range*>(range);
          for (Reference& reference : references) {
            const Box3 clipped = objectClippedBounds(shapes[reference.object - firstObject], cell);
            reference.bounds = intersection(reference.bounds, intersection(clipped, cell));
          }
        },
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
};

}  // namespace planetree::detail
