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

void fill(const RayColumns<float>& rays, const PacketOrder::Place& place,
          RayPacket& packet) noexcept {
  packet.rays = (1u << place.count) - 1u;
  for (std::size_t i = 0; i < kRayCount; ++i) {
    // Places without a ray get the last one once more.
    const std::size_t ray = place.rays[std::min(i, place.count - 1)];
    packet.rows[i] = rays.records != nullptr ? &rays.records[ray].origin.x : nullptr;
    if (rays.records == nullptr) {
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
    const Vec3f along{packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]};
    hit.normal = static_cast<Vec3f>(normalized(-static_cast<Vec3d>(along)));
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
  if constexpr (std::is_same_v<T, float>) {
    if (kernels_ != nullptr) {
      traceGroups(
          begin, end, kernels_->findNearestOfPackets, traceAlone,
          [&](std::size_t ray) { hits.fetch(ray); },
          [&](std::size_t ray, const RayPacket& packet, std::size_t i) {
            hits.write(ray, hitOf(tree_, packet, i));
            hitCount += packet.hits >> i & 1u;
          });
      return hitCount;
    }
  }
  forEachRay(begin, end, traceAlone);
  return hitCount;
}

template <class T>
std::size_t PortionTracer<T>::findAny(std::size_t begin, std::size_t end,
                                      std::span<std::uint8_t> flags) const noexcept {
  std::size_t hitCount = 0;
  const auto traceAlone = [&](std::size_t ray) {
    flags[ray] = isOccluded(tree_, rays_[ray], options_) ? 1u : 0u;
    hitCount += flags[ray];
  };
  if constexpr (std::is_same_v<T, float>) {
    if (kernels_ != nullptr) {
      traceGroups(
          begin, end, kernels_->findAnyOfPackets, traceAlone, [](std::size_t) {},
          [&](std::size_t ray, const RayPacket& packet, std::size_t i) {
            flags[ray] = packet.hits >> i & 1u;
            hitCount += flags[ray];
          });
      return hitCount;
    }
  }
  forEachRay(begin, end, traceAlone);
  return hitCount;
}

template <class T>
template <class Visit>
void PortionTracer<T>::forEachRay(std::size_t begin, std::size_t end, const Visit& visit) const {
  for (; begin < end; ++begin) {
    const PacketOrder::Place place = order_[begin];
    for (std::size_t i = 0; i < place.count; ++i)
      visit(place.rays[i]);
  }
}

template <class T>
template <class TraceAlone, class Fetch, class Write>
void PortionTracer<T>::traceGroups(std::size_t begin, std::size_t end, SearchPackets search,
                                   const TraceAlone& traceAlone, const Fetch& fetch,
                                   const Write& write) const {
  if constexpr (std::is_same_v<T, float>) {
    RayPacket packets[RayPacket::kGroupSize];
    PacketOrder::Place places[RayPacket::kGroupSize];
    PacketOrder::Place nextPlaces[RayPacket::kGroupSize];
    const auto findNext = [&](std::size_t from) {
      const std::size_t count = std::min(RayPacket::kGroupSize, end - from);
      for (std::size_t i = 0; i < count; ++i) {
        nextPlaces[i] = order_[from + i];
        for (std::size_t k = 0; k < nextPlaces[i].count; ++k)
          rays_.fetch(nextPlaces[i].rays[k]);
      }
      return count;
    };
    std::size_t nextCount = findNext(begin);
    while (begin < end) {
      const std::size_t count = nextCount;
      for (std::size_t i = 0; i < count; ++i) {
        places[i] = nextPlaces[i];
        fill(rays_, places[i], packets[i]);
        for (std::size_t k = 0; k < places[i].count; ++k)
          fetch(places[i].rays[k]);
      }
      begin += count;
      nextCount = findNext(begin);
      search(*tree_.wide, packets, count);
      for (std::size_t i = 0; i < count; ++i) {
        const RayPacket& packet = packets[i];
        for (std::size_t k = 0; k < places[i].count; ++k)
          write(places[i].rays[k], packet, k);
        for (std::uint32_t rest = packet.unanswered; rest != 0; rest &= rest - 1)
          traceAlone(places[i].rays[static_cast<std::size_t>(std::countr_zero(rest))]);
      }
    }
  }
}

template class PortionTracer<float>;
template class PortionTracer<double>;

}  // namespace planetree::detail
