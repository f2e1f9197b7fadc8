#include "batch/trace_portion.hpp"

#include <planetree/detail/geometry_entry.hpp>
#include <planetree/traversal/find_intersection.hpp>

#include "node/wide_node.hpp"
#include "traversal/hit_choices.hpp"
#include "traversal/ray_packet.hpp"

#include <algorithm>
#include <bit>
#include <type_traits>

namespace planetree::detail {
namespace {

constexpr std::size_t kRayCount = RayPacket::kRayCount;

/// Calls `visit` for each member of a set.
template <class Visit>
void forEachIn(std::uint32_t set, const Visit& visit) {
  for (; set != 0; set &= set - 1)
    visit(static_cast<std::size_t>(std::countr_zero(set)));
}

void fill(const RayColumns<float>& rays, const PacketOrder::Place& place,
          RayPacket& packet) noexcept {
  packet.rays = (1u << place.count) - 1u;
  for (std::size_t i = 0; i < kRayCount; ++i) {
    // Places without a ray get the last one once more.
    const std::size_t ray = place.rays[std::min(i, place.count - 1)];
    if (rays.records != nullptr) {
      // Number by number: as a whole it would go through memory.
      const float* const from = &rays.records[ray].origin.x;
      for (std::size_t a = 0; a < 3; ++a) {
        packet.origin[a][i] = from[a];
        packet.direction[a][i] = from[3 + a];
      }
      packet.tMin[i] = from[6];
      packet.hitT[i] = from[7];
    } else {
      for (std::size_t a = 0; a < 3; ++a) {
        packet.origin[a][i] = rays.origin[a][ray];
        packet.direction[a][i] = rays.direction[a][ray];
      }
      packet.tMin[i] = rays.tMin[ray];
      packet.hitT[i] = rays.tMax[ray];
    }
  }
}

/// What a ray of an answered packet hits.
Hitf hitOf(const TreeView<float>& tree, const RayPacket& packet, std::size_t i) noexcept {
  Hitf hit;
  if ((packet.hits >> i & 1u) == 0)
    return hit;
  hit.t = packet.hitT[i];
  hit.u = packet.u[i];
  hit.v = packet.v[i];
  hit.geometry = geometryOf(tree.geometries, packet.hitObject[i]);
  hit.primitive = packet.hitObject[i] - tree.geometries[hit.geometry].firstObject;
  hit.normal = {packet.normal[0][i], packet.normal[1][i], packet.normal[2][i]};
  if ((packet.flatHits >> i & 1u) != 0) {
    const Vec3d along(packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]);
    hit.normal = static_cast<Vec3f>(normalized(-along));
  }
  return hit;
}

}  // namespace

template <class T>
PortionTracer<T>::PortionTracer(const TreeView<T>& tree, const RayColumns<T>& rays,
                                const QueryOptions& options) noexcept
    : tree_(tree), rays_(rays), order_(rays, tree.bounds), options_(options) {
  if constexpr (std::is_same_v<T, float>) {
    const bool arePacked = tree.wide != nullptr && !tree.wide->nodes.empty() &&
                           !tree.wide->holdsObjects && (options.mask & tree.wide->commonMask) != 0;
    if (arePacked && !hasChoices(options))
      kernels_ = &activeKernels();
  }
}

template <class T>
std::size_t PortionTracer<T>::findNearest(std::size_t begin, std::size_t end,
                                          const HitColumns<T>& hits) const noexcept {
  std::size_t hitCount = 0;
  const auto traceAlone = [&](std::size_t ray) {
    const auto hit = findIntersection(tree_, rays_[ray], options_);
    hits.write(ray, hit.value_or(Hit<T>{}));
    hitCount += hit ? 1u : 0u;
  };
  for (; begin < end; ++begin) {
    const PacketOrder::Place place = order_[begin];
    if constexpr (std::is_same_v<T, float>) {
      if (kernels_ != nullptr) {
        RayPacket packet;
        fill(rays_, place, packet);
        kernels_->findNearestOfPacket(*tree_.wide, packet);
        forEachIn(packet.unanswered, [&](std::size_t i) { traceAlone(place.rays[i]); });
        forEachIn(packet.rays & ~packet.unanswered,
                  [&](std::size_t i) { hits.write(place.rays[i], hitOf(tree_, packet, i)); });
        hitCount += static_cast<std::size_t>(std::popcount(packet.hits));
        continue;
      }
    }
    for (std::size_t i = 0; i < place.count; ++i)
      traceAlone(place.rays[i]);
  }
  return hitCount;
}

template <class T>
std::size_t PortionTracer<T>::findAny(std::size_t begin, std::size_t end,
                                      std::span<std::uint8_t> flags) const noexcept {
  std::size_t hitCount = 0;
  const auto write = [&](std::size_t ray, bool isHit) {
    flags[ray] = isHit ? 1u : 0u;
    hitCount += isHit ? 1u : 0u;
  };
  const auto traceAlone = [&](std::size_t ray) {
    write(ray, isOccluded(tree_, rays_[ray], options_));
  };
  for (; begin < end; ++begin) {
    const PacketOrder::Place place = order_[begin];
    if constexpr (std::is_same_v<T, float>) {
      if (kernels_ != nullptr) {
        RayPacket packet;
        fill(rays_, place, packet);
        kernels_->findAnyOfPacket(*tree_.wide, packet);
        forEachIn(packet.unanswered, [&](std::size_t i) { traceAlone(place.rays[i]); });
        forEachIn(packet.rays & ~packet.unanswered,
                  [&](std::size_t i) { write(place.rays[i], (packet.hits >> i & 1u) != 0); });
        continue;
      }
    }
    for (std::size_t i = 0; i < place.count; ++i)
      traceAlone(place.rays[i]);
  }
  return hitCount;
}

template class PortionTracer<float>;
template class PortionTracer<double>;

}  // namespace planetree::detail
