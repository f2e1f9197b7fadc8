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
  explicit WideSearch(const Request<float>& of) noexcept : request(of), tree(of.tree) {
    nodes = tree.wide->nodes.data();
    blocks = tree.wide->blocks.data();
    root = tree.wide->root;
    tMin = request.interval.tMin;
    hitT = request.interval.tMax;
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
        return search.sees(geometryOf(search.tree.geometries, block.objects[lane]));
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
                                hitBlock->corner(hitLane, 2), request.asked.direction);
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
    const LeafNode& leaf = tree.nodes[leafIndex].leaf();
    if (!visitLeaf<Goal>(leaf, query(), objectHit, unobserved))
      return false;
    if (Goal::kStopsAtAnyHit)
      return true;
    hitT = objectHit.t;
    hitObject = tree.geometries[objectHit.geometry].firstObject + objectHit.primitive;
    hitBlock = nullptr;
    return true;
  }

 private:
  [[nodiscard]] bool sees(std::uint32_t geometry) const noexcept {
    return (tree.geometries[geometry].mask & request.mask) != 0;
  }

  /// The sink knows the hits, the kernel only where they end; hence it must not take those that do
  /// not compete.
  template <class Goal>
  [[nodiscard]] bool offer(const TriangleBlock& block, std::uint32_t lane) noexcept {
    const auto geometries = tree.geometries;
    const std::uint32_t object = block.objects[lane];
    const std::uint32_t geometry = geometryOf(geometries, object);
    if (!sees(geometry))
      return false;
    const ShearedRay<float>& ray = query().ray.sheared;
    const Vec3f a = block.corner(lane, 0);
    const Vec3f b = block.corner(lane, 1);
    const Vec3f c = block.corner(lane, 2);
    HitSink<float>& sink = *request.sink;
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
        visitLeaf<Goal>(tree.nodes[leafIndex].leaf(), query(), unused, unobserved);
    hitT = request.sink->tMax;
    // A triangle at the same t must not be turned away for its number: the sink compares keys.
    hitObject = kNoId;
    return isKept;
  }

  [[nodiscard]] bool seesAll() const noexcept {
    for (const GeometryEntry<float>& geometry : tree.geometries) {
      if ((geometry.mask & request.mask) == 0)
        return false;
    }
    return true;
  }

  /// t and the ids of the best hit, which is on a triangle of a block.
  [[nodiscard]] Hitf unfinishedHit() const noexcept {
    const auto geometries = tree.geometries;
    Hitf hit;
    hit.t = hitT;
    hit.geometry = geometryOf(geometries, hitObject);
    hit.primitive = hitObject - geometries[hit.geometry].firstObject;
    return hit;
  }

  /// The ray as single objects see it, made when the first of them asks.
  [[nodiscard]] const Query<float>& query() noexcept {
    if (!query_)
      query_.emplace(request);
    return *query_;
  }

  const Request<float>& request;
  const TreeView<float>& tree;
  std::optional<Query<float>> query_;
  Hitf objectHit;  ///< the best hit on anything but a triangle of a block
};

}  // namespace

template <class Goal>
std::optional<bool> searchWide(const Request<float>& request, Hitf& hit,
                               const WideKernels& kernels) noexcept {
  const WideTree* const form = request.tree.wide;
  if (form == nullptr)
    return std::nullopt;
  if (request.tree.bounds.isEmpty())
    return false;
  WideSearch search(request);
  if (!search.prepare(request.asked, request.tree.bounds, form->center))
    return std::nullopt;
  search.setAcceptance<Goal>();
  search.testObjects = [](WideQuery& wide, std::uint32_t leafIndex) noexcept {
    return static_cast<WideSearch&>(wide).testLeaf<Goal>(leafIndex);
  };
  const bool asks = search.accepts != nullptr;
  if (Goal::kStopsAtAnyHit)
    return asks ? kernels.findAnyAccepted(search) : kernels.findAny(search);
  if (!(asks ? kernels.findNearestAccepted(search) : kernels.findNearest(search)))
    return false;
  if (Goal::kOffersHits)
    return true;
  hit = search.finishedHit();
  return true;
}

#define PLANETREE_INSTANTIATE(Goal)                                         \
  template std::optional<bool> searchWide<Goal>(const Request<float>&, Hitf&, \
                                                const WideKernels&) noexcept;
PLANETREE_INSTANTIATE(NearestHit)
PLANETREE_INSTANTIATE(AnyHit)
PLANETREE_INSTANTIATE(NearestOffer)
PLANETREE_INSTANTIATE(AnyOffer)
PLANETREE_INSTANTIATE(EveryOffer)
#undef PLANETREE_INSTANTIATE

}  // namespace planetree::detail
