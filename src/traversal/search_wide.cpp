#include "traversal/search_wide.hpp"

#include <planetree/mesh/triangle_intersection.hpp>

#include "node/wide_node.hpp"
#include "traversal/wide_query.hpp"

namespace planetree::detail {
namespace {

/// Sixteen megabytes of nodes, about what a thread has of a large cache. In smaller trees fetching
/// ahead costs as much as it saves.
constexpr std::size_t kLargeNodeCount = 32'768;

/// A query of the wide form that can also reach what is not in its blocks.
struct WideSearch : WideQuery {
  explicit WideSearch(const Query<float>& asked) noexcept : query(asked) {
    nodes = query.tree.wide->nodes.data();
    blocks = query.tree.wide->blocks.data();
    root = query.tree.wide->root;
    isLargeTree = query.tree.wide->nodes.size() > kLargeNodeCount;
    tMin = query.interval.tMin;
    hitT = query.interval.tMax;
    if (!seesAll())
      sees = [](const WideQuery& wide, std::uint32_t object) noexcept {
        const Query<float>& of = static_cast<const WideSearch&>(wide).query;
        const auto geometries = of.tree.geometries;
        return (geometries[geometryOf(geometries, object)].mask & of.mask) != 0;
      };
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
  [[nodiscard]] bool testReference(std::uint32_t reference) noexcept {
    // Objects of other kinds must know what they compete with.
    if (hitBlock != nullptr)
      objectHit = unfinishedHit();
    Unobserved unobserved;
    if (!visitLeaf<Goal>(LeafNode(reference, 1), query, objectHit, unobserved))
      return false;
    if (Goal::kStopsAtAnyHit)
      return true;
    hitT = objectHit.t;
    hitObject = query.tree.geometries[objectHit.geometry].firstObject + objectHit.primitive;
    hitBlock = nullptr;
    return true;
  }

 private:
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
  search.testObject = [](WideQuery& wide, std::uint32_t reference) noexcept {
    return static_cast<WideSearch&>(wide).testReference<Goal>(reference);
  };
  if (Goal::kStopsAtAnyHit)
    return kernels.findAny(search);
  if (!kernels.findNearest(search))
    return false;
  hit = search.finishedHit();
  return true;
}

template std::optional<bool> searchWide<NearestHit>(const Query<float>&, Hitf&,
                                                    const WideKernels&) noexcept;
template std::optional<bool> searchWide<AnyHit>(const Query<float>&, Hitf&,
                                                const WideKernels&) noexcept;

}  // namespace planetree::detail
