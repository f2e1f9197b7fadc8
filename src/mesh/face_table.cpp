#include <planetree/detail/object_range.hpp>
#include <planetree/mesh/clip_triangle.hpp>
#include <planetree/mesh/triangle_intersection.hpp>

#include "mesh/triangle_hit.hpp"

#include <optional>

namespace planetree::detail {
namespace {

/// Why a face cannot be hit, if so. A face whose corners differ but lie on a line stays: rounding
/// may give it the tiny area by which a T-junction would otherwise leak.
template <class T>
std::optional<SkipReason> skipReasonOf(const TriangleMeshView<T>& mesh, std::uint32_t face) {
  for (const std::uint32_t vertex : mesh.indices(face)) {
    if (vertex >= mesh.vertexCount())
      return SkipReason::IndexOutOfRange;
  }
  const auto [a, b, c] = mesh.corners(face);
  if (!Face<T>(mesh, face).isUsable())
    return SkipReason::NotFinite;
  if (a == b || b == c || c == a)
    return SkipReason::RepeatedCorner;
  return std::nullopt;
}

template <class T>
void boundFaces(const void* range, std::uint32_t first, std::span<BoundedObject> objects) {
  const auto& mesh = *static_cast<const TriangleMeshView<T>*>(range);
  for (BoundedObject& object : objects) {
    const std::uint32_t face = first++;
    object.skipReason = skipReasonOf(mesh, face);
    if (object.skipReason)
      continue;
    // What `boundObject` would ask the face for, with its corners read once.
    const auto [a, b, c] = mesh.corners(face);
    Reference& reference = object.reference;
    reference.bounds.extend(a);
    reference.bounds.extend(b);
    reference.bounds.extend(c);
    reference.leftSides = triangleLeftSides(a, b, c);
  }
}

template <class T>
LeafAnswer findNearestFace(const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                           T tMax, Hit<T>& hit) noexcept {
  const auto& mesh = *static_cast<const TriangleMeshView<T>*>(range);
  const LeafAnswer answer = findNearestInRun<T>(
      run, tMin, tMax, hit, [&](std::uint32_t face, T from, T to) -> std::optional<Hit<T>> {
        const auto [a, b, c] = mesh.corners(face);
        const auto found = intersectTriangle(ray, a, b, c, from, to);
        if (!found)
          return std::nullopt;
        Hit<T> candidate;
        candidate.t = found->t;
        candidate.u = found->u;
        candidate.v = found->v;
        return candidate;
      });
  if (answer.found) {
    const auto [a, b, c] = mesh.corners(hit.primitive);
    hit.normal = triangleNormal(a, b, c, ray.ray.direction);
  }
  return answer;
}

template <class T>
LeafAnswer findAnyFace(const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                       T tMax) noexcept {
  const auto& mesh = *static_cast<const TriangleMeshView<T>*>(range);
  return findAnyInRun<T>(run, tMin, tMax, [&](std::uint32_t face, T from, T to) {
    const auto [a, b, c] = mesh.corners(face);
    return intersectTriangle(ray, a, b, c, from, to).has_value();
  });
}

template <class T>
LeafAnswer offerFaceHits(const void* range, const LeafRun& run, const ShearedRay<T>& ray, T tMin,
                         HitSink<T>& sink) noexcept {
  const auto& mesh = *static_cast<const TriangleMeshView<T>*>(range);
  return offerHitsInRun<T>(run, tMin, sink, [&](std::uint32_t face, T from, T to) {
    const auto [a, b, c] = mesh.corners(face);
    return sink.crossings ? findTriangleCrossing(ray, a, b, c, from, to)
                          : findTriangleHit(ray, a, b, c, from, to);
  });
}

}  // namespace

template <class T>
const BoundingTable& faceBoundingTable() noexcept {
  static constexpr BoundingTable kTable = {.bound = boundFaces<T>,
                                           .clip = clipReferences<TriangleMeshView<T>>};
  return kTable;
}

template <class T>
const IntersectionTable<T>& faceIntersectionTable() noexcept {
  static constexpr IntersectionTable<T> kTable = {
      .findNearest = findNearestFace<T>, .findAny = findAnyFace<T>, .offerHits = offerFaceHits<T>};
  return kTable;
}

template const BoundingTable& faceBoundingTable<float>() noexcept;
template const BoundingTable& faceBoundingTable<double>() noexcept;
template const IntersectionTable<float>& faceIntersectionTable<float>() noexcept;
template const IntersectionTable<double>& faceIntersectionTable<double>() noexcept;

}  // namespace planetree::detail
