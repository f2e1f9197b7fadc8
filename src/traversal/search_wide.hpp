#pragma once

#include <planetree/geometry/rounding.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/mesh/triangle_intersection.hpp>
#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/traversal/tree_view.hpp>

#include "isa/kernels.hpp"
#include "mesh/float_normal.hpp"
#include "node/wide_node.hpp"
#include "traversal/traverse.hpp"
#include "traversal/wide_query.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

namespace planetree::detail {

/// Whether the request sees all geometries; nearly always the first question tells.
template <class T>
[[nodiscard]] bool seesAll(const Request<T>& request) noexcept {
  return (request.mask & request.tree.wide->commonMask) != 0 ||
         std::all_of(request.tree.geometries.begin(), request.tree.geometries.end(),
                     [&](const GeometryEntry<T>& entry) { return request.sees(entry); });
}

/// A query of the wide form, and the answer to everything that kernels cannot decide.
template <class Goal, class T>
class WideSearch : public WideQuery {
 public:
  WideSearch(const Request<T>& request, Hit<T>& hit) noexcept
      : WideQuery(*request.tree.wide, kTests, roundDown(request.interval.tMin),
                  roundUp(request.interval.tMax)),
        request_(request),
        tree_(request.tree),
        hit_(hit) {}

  /// Whether the query can be answered. Rays in float are prepared by the kernels, which may still
  /// find that they cannot.
  [[nodiscard]] bool prepareRay() noexcept {
    if constexpr (std::is_same_v<T, float>) {
      static_assert(sizeof(Rayf) == 8 * sizeof(float) && offsetof(Rayf, direction) == 12);
      ray = &request_.asked.origin.x;
      return true;
    } else {
      const PreparedRay<T> prepared(request_.asked, tree_.bounds);
      sheared_ = prepared.sheared;
      return prepare(prepared);
    }
  }

  [[nodiscard]] bool run(const Kernels& kernels) noexcept {
    const bool handsOver = !std::is_same_v<T, float> || Goal::kOffersHits || !seesAll(request_);
    if constexpr (Goal::kStopsAtAnyHit)
      return (handsOver ? kernels.handOverForAny : kernels.findAny)(*this);
    if (!(handsOver ? kernels.handOverForNearest : kernels.findNearest)(*this))
      return false;
    if constexpr (!Goal::kOffersHits)
      finishHit();
    return true;
  }

  /// The same for rays in float among all triangles, with the steps it takes.
  [[nodiscard]] bool count(const Kernels& kernels, WideSteps& steps) noexcept {
    return (Goal::kStopsAtAnyHit ? kernels.countAny : kernels.countNearest)(*this, steps);
  }

 private:
  static constexpr WideTests kTests = {
      .testObject =
          [](WideQuery& wide, std::uint32_t object) noexcept {
            return static_cast<WideSearch&>(wide).testObject(object);
          },
      .testCandidates =
          [](WideQuery& wide, Candidates& candidates) noexcept {
            return static_cast<WideSearch&>(wide).testFaces(candidates);
          }};

  /// The ray as single objects see it, made when the first of them asks.
  [[nodiscard]] const ShearedRay<T>& sheared() noexcept {
    if (!sheared_)
      sheared_.emplace(request_.asked);
    return *sheared_;
  }

  [[nodiscard]] bool testObject(const std::uint32_t& object) noexcept {
    // Objects of other kinds must know what they compete with.
    if (hitBlock != nullptr)
      hit_ = hitInBlock();
    Unobserved unobserved;
    const bool found =
        visitObjects<Goal>(std::span(&object, 1), request_, sheared(), hit_, unobserved);
    if (found)
      normalIsMissing_ = false;
    return takeOver(found);
  }

  [[nodiscard]] bool testFaces(Candidates& candidates) noexcept {
    if constexpr (!Goal::kOffersHits) {
      // After the hit of the nearest the others may be too far.
      const auto nearest = static_cast<std::size_t>(
          std::min_element(candidates.earliest, candidates.earliest + candidates.count) -
          candidates.earliest);
      std::swap(candidates.objects[0], candidates.objects[nearest]);
      std::swap(candidates.earliest[0], candidates.earliest[nearest]);
    }
    bool found = false;
    for (std::uint32_t i = 0; i < candidates.count; ++i) {
      if (candidates.earliest[i] > hitT || !testFace(candidates.objects[i]))
        continue;
      found = true;
      if (Goal::kStopsAtAnyHit)
        break;
    }
    return found;
  }

  [[nodiscard]] bool testFace(const std::uint32_t& object) noexcept {
    const std::uint32_t geometry = geometryOf(tree_.geometries, object);
    const GeometryEntry<T>& entry = tree_.geometries[geometry];
    if (!request_.sees(entry))
      return false;
    if constexpr (Goal::kOffersHits) {
      const LeafRun run{std::span(&object, 1), entry.firstObject, geometry};
      return takeOver(
          entry.intersecting
              ->offerHits(entry.range, run, sheared(), request_.interval.tMin, *request_.sink)
              .found);
    } else {
      return takeOver(intersectFace(entry, geometry, object - entry.firstObject));
    }
  }

  /// Leaves the normal to be found for the nearest hit alone.
  [[nodiscard]] bool intersectFace(const GeometryEntry<T>& entry, std::uint32_t geometry,
                                   std::uint32_t face) noexcept {
    const auto [from, to] = request_.interval;
    const auto [a, b, c] = meshOf(entry).corners(face);
    const auto at = intersectTriangle(sheared(), a, b, c, from, hit_.t < to ? hit_.t : to);
    if (!at || Goal::kStopsAtAnyHit)
      return at.has_value();
    const Hit<T> candidate = {
        .t = at->t, .u = at->u, .v = at->v, .geometry = geometry, .primitive = face};
    if (!isBefore(candidate, hit_))
      return false;
    hit_ = candidate;
    normalIsMissing_ = true;
    return true;
  }

  /// Shortens the ray to the best hit, or a little beyond: a cell that holds another as near must
  /// still be met. Returns whether there is a new best one.
  [[nodiscard]] bool takeOver(bool found) noexcept {
    if constexpr (Goal::kOffersHits) {
      hitT = roundUp(request_.sink->tMax);
    } else if (found && !Goal::kStopsAtAnyHit) {
      hitT = roundUp(hit_.t);
      hitObject = tree_.geometries[hit_.geometry].firstObject + hit_.primitive;
      hitBlock = nullptr;
    }
    return found;
  }

  void finishHit() noexcept {
    // Only triangles in float are decided by the kernels.
    if constexpr (std::is_same_v<T, float>) {
      if (hitBlock != nullptr) {
        hit_ = hitInBlock();
        const double sum = hitWeights[0] + hitWeights[1] + hitWeights[2];
        hit_.u = static_cast<float>(hitWeights[1] / sum);
        hit_.v = static_cast<float>(hitWeights[2] / sum);
        hit_.normal = floatNormal(hitBlock->corner(hitLane, 0), hitBlock->corner(hitLane, 1),
                                  hitBlock->corner(hitLane, 2), request_.asked.direction);
        return;
      }
    }
    if (normalIsMissing_) {
      const auto [a, b, c] = meshOf(tree_.geometries[hit_.geometry]).corners(hit_.primitive);
      hit_.normal = triangleNormal(a, b, c, request_.asked.direction);
    }
  }

  /// t and the ids of the best hit, which a kernel found.
  [[nodiscard]] Hit<T> hitInBlock() const noexcept {
    Hit<T> hit;
    hit.t = static_cast<T>(hitT);
    hit.geometry = geometryOf(tree_.geometries, hitObject);
    hit.primitive = hitObject - tree_.geometries[hit.geometry].firstObject;
    return hit;
  }

  [[nodiscard]] static const TriangleMeshView<T>& meshOf(const GeometryEntry<T>& entry) noexcept {
    return *static_cast<const TriangleMeshView<T>*>(entry.range);
  }

  const Request<T>& request_;
  const TreeView<T>& tree_;
  Hit<T>& hit_;  ///< the best so far, but for one in a block
  std::optional<ShearedRay<T>> sheared_;
  bool normalIsMissing_ = false;
};

/// What the wide form of the tree says, bit for bit what `traverse` would. Nothing if there is no
/// wide form, or if the ray's numbers are beyond its range: then the binary form has to be asked.
/// Goals that offer hits leave `hit` alone.
///
/// Triangles in float whose hits all count are decided by the kernels. In double, and where there
/// are choices to make, the kernels find the candidates, which takes a few dozen nanoseconds more.
template <class Goal, class T>
[[nodiscard]] std::optional<bool> searchWide(const Request<T>& request, Hit<T>& hit,
                                             const Kernels& kernels = activeKernels()) noexcept {
  if (request.tree.wide == nullptr)
    return std::nullopt;
  WideSearch<Goal, T> search(request, hit);
  if (!search.prepareRay())
    return std::nullopt;
  const bool found = search.run(kernels);
  if (search.isOutOfRange)
    return std::nullopt;
  return found;
}

}  // namespace planetree::detail
