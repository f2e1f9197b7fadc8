#include "traversal/search_wide.hpp"

#include <planetree/mesh/triangle_intersection.hpp>

#include "mesh/triangle_hit.hpp"
#include "node/wide_node.hpp"
#include "traversal/wide_query.hpp"

#include <type_traits>

namespace planetree::detail {
namespace {

/// A query of the wide form that can also reach what is not in its blocks.
struct WideSearch : WideQuery {
  explicit WideSearch(const Query<float>& asked) noexcept : query(asked) {
    nodes = query.tree.wide->nodes.data();
    blocks = query.tree.wide->blocks.data();
    root = query.tree.wide->root;
    tMin = query.interval.tMin;
    hitT = query.interval.tMax;
  }

  /// Sets what the goal asks of each triangle that is hit.
  template <class Goal>
  void setAcceptance() noexcept {
    if constexpr (Goal::kOffersHits) {
      accepts = [](WideQuery& wide, const TriangleBlock& block, std::uint32_t lane) noexcept {
        return static_cast<WideSearch&>(wide).offer<Goal>(block, lane);
      };
    } else if (!seesAll()) {
      accepts = [](WideQuery& wide, const TriangleBlock& block, std::uint32_t lane) noexcept {
        const auto& search = static_cast<const WideSearch&>(wide);
        return search.sees(geometryOf(search.query.tree.geometries, block.objects[lane]));
      };
    }
  }

  /// The hit with everything that the kernels leave open.
  [[nodiscard]] Hitf finishedHit() const noexcept {
    if (hitBlock == nullptr)
      return objectHit;
    const double sum = hitWeights[0] + hitWeights[1] + hitWeights[2];
    Hitf hit = unfinishedHit();
    hit.u = static_cast<float>(hitWeights[1] / sum);
    hit.v = static_cast<float>(hitWeights[2] / sum);
    hit.normal = triangleNormal(hitBlock->corner(hitLane, 0), hitBlock->corner(hitLane, 1),
                                hitBlock->corner(hitLane, 2), query.ray.ray().direction);
    return hit;
  }

  template <class Goal>
  [[nodiscard]] bool testLeaf(std::uint32_t leafIndex) noexcept {
    if constexpr (Goal::kOffersHits)
      return offerLeaf<Goal>(leafIndex);
    // Objects of other kinds must know what they compete with.
    if (hitBlock != nullptr)
      objectHit = unfinishedHit();
    Unobserved unobserved;
    const LeafNode& leaf = query.tree.nodes[leafIndex].leaf();
    if (!visitLeaf<Goal>(leaf, query, objectHit, unobserved))
      return false;
    if (Goal::kStopsAtAnyHit)
      return true;
    hitT = objectHit.t;
    hitObject = query.tree.geometries[objectHit.geometry].firstObject + objectHit.primitive;
    hitBlock = nullptr;
    return true;
  }

 private:
  [[nodiscard]] bool sees(std::uint32_t geometry) const noexcept {
    return (query.tree.geometries[geometry].mask & query.mask) != 0;
  }

  /// The sink knows the hits, the kernel only where they end; hence it must not take those that do
  /// not compete.
  template <class Goal>
  [[nodiscard]] bool offer(const TriangleBlock& block, std::uint32_t lane) noexcept {
    const auto geometries = query.tree.geometries;
    const std::uint32_t object = block.objects[lane];
    const std::uint32_t geometry = geometryOf(geometries, object);
    if (!sees(geometry))
      return false;
    const ShearedRay<float>& ray = query.ray.sheared;
    const Vec3f a = block.corner(lane, 0);
    const Vec3f b = block.corner(lane, 1);
    const Vec3f c = block.corner(lane, 2);
    HitSink<float>& sink = *query.sink;
    std::optional<Hitf> hit = sink.crossings ? findTriangleCrossing(ray, a, b, c, tMin, sink.tMax)
                                             : findTriangleHit(ray, a, b, c, tMin, sink.tMax);
    if (!hit)
      return false;
    hit->geometry = geometry;
    hit->primitive = object - geometries[geometry].firstObject;
    const bool isKept = sink.offer(*hit);
    hitT = sink.tMax;
    return isKept && !std::is_same_v<Goal, EveryOffer>;
  }

  template <class Goal>
  [[nodiscard]] bool offerLeaf(std::uint32_t leafIndex) noexcept {
    Hitf unused;
    Unobserved unobserved;
    const bool isKept =
        visitLeaf<Goal>(query.tree.nodes[leafIndex].leaf(), query, unused, unobserved);
    hitT = query.sink->tMax;
    // A triangle at the same t must not be turned away for its number: the sink compares keys.
    hitObject = kNoId;
    return isKept;
  }

  [[nodiscard]] bool seesAll() const noexcept {
    for (const GeometryEntry<float>& geometry : query.tree.geometries) {
      if ((geometry.mask & query.mask) == 0)
        return false;
    }
    return true;
  }

  /// t and the ids of the best hit, which is on a triangle of a block.
  [[nodiscard]] Hitf unfinishedHit() const noexcept {
    const auto geometries = query.tree.geometries;
    Hitf hit;
    hit.t = hitT;
    hit.geometry = geometryOf(geometries, hitObject);
    hit.primitive = hitObject - geometries[hit.geometry].firstObject;
    return hit;
  }

  const Query<float>& query;
  Hitf objectHit;  ///< the best hit on anything but a triangle of a block
};

}  // namespace

template <class Goal>
std::optional<bool> searchWide(const Query<float>& query, Hitf& hit,
                               const WideKernels& kernels) noexcept {
  if (query.tree.wide == nullptr)
    return std::nullopt;
  if (!query.ray.isValid() || query.tree.bounds.isEmpty())
    return false;
  WideSearch search(query);
  if (!search.prepare(query.ray, query.tree.wide->center))
    return std::nullopt;
  search.setAcceptance<Goal>();
  search.testObjects = [](WideQuery& wide, std::uint32_t leafIndex) noexcept {
    return static_cast<WideSearch&>(wide).testLeaf<Goal>(leafIndex);
  };
  if (Goal::kStopsAtAnyHit)
    return kernels.findAny(search);
  if (!kernels.findNearest(search))
    return false;
  if (Goal::kOffersHits)
    return true;
  hit = search.finishedHit();
  return true;
}

#define PLANETREE_INSTANTIATE(Goal)                                         \
  template std::optional<bool> searchWide<Goal>(const Query<float>&, Hitf&, \
                                                const WideKernels&) noexcept;
PLANETREE_INSTANTIATE(NearestHit)
PLANETREE_INSTANTIATE(AnyHit)
PLANETREE_INSTANTIATE(NearestOffer)
PLANETREE_INSTANTIATE(AnyOffer)
PLANETREE_INSTANTIATE(EveryOffer)
#undef PLANETREE_INSTANTIATE

}  // namespace planetree::detail
