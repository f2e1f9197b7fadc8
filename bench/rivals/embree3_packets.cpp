#include "bench/rivals/embree3_packets.hpp"

#include "bench/rivals/denormals_flushed.hpp"
#include "bench/support/parallel_for.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace planetree::bench {

namespace {

constexpr std::size_t kLanes = 8;
constexpr std::size_t kPacketsOfAPiece = 256;
// Pixels that a packet covers.
constexpr std::size_t kTileWidth = 4;
constexpr std::size_t kTileHeight = 2;

/// The number whose even bits are those of `x`, and whose odd ones those of `y`.
std::uint64_t interleaved(std::size_t x, std::size_t y) {
  std::uint64_t code = 0;
  for (unsigned bit = 0; bit < 32; ++bit) {
    code |= static_cast<std::uint64_t>((x >> bit) & 1u) << (2 * bit);
    code |= static_cast<std::uint64_t>((y >> bit) & 1u) << (2 * bit + 1);
  }
  return code;
}

/// The rays of a picture in tiles, and other rays in their own order. The tiles follow each other
/// on Morton's curve, so that what one of them has brought into the caches serves the next.
std::vector<std::uint32_t> orderOf(std::size_t rayCount, std::size_t width) {
  std::vector<std::uint32_t> order(rayCount);
  std::iota(order.begin(), order.end(), 0u);
  if (width == 0)
    return order;
  std::vector<std::uint64_t> tiles(rayCount);
  for (std::size_t i = 0; i < rayCount; ++i)
    tiles[i] = interleaved(i % width / kTileWidth, i / width / kTileHeight);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return tiles[a] < tiles[b]; });
  return order;
}

std::size_t packetCountFor(std::size_t rayCount) {
  return (rayCount + kLanes - 1) / kLanes;
}

void writeRay(const Rayf& ray, RTCRay8& packet, std::size_t lane) {
  packet.org_x[lane] = ray.origin.x;
  packet.org_y[lane] = ray.origin.y;
  packet.org_z[lane] = ray.origin.z;
  packet.tnear[lane] = ray.tMin;
  packet.dir_x[lane] = ray.direction.x;
  packet.dir_y[lane] = ray.direction.y;
  packet.dir_z[lane] = ray.direction.z;
  packet.time[lane] = 0.0f;
  packet.mask[lane] = ~0u;
  packet.id[lane] = 0;
  packet.flags[lane] = 0;
}

Hitf readHit(const RTCRayHit8& packet, std::size_t lane) {
  if (packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID)
    return {};
  return {.t = packet.ray.tfar[lane],
          .u = packet.hit.u[lane],
          .v = packet.hit.v[lane],
          .normal = {packet.hit.Ng_x[lane], packet.hit.Ng_y[lane], packet.hit.Ng_z[lane]},
          .geometry = packet.hit.geomID[lane],
          .primitive = packet.hit.primID[lane]};
}

/// Which lanes of a packet have a ray.
struct alignas(32) ValidLanes {
  std::array<int, kLanes> lanes = {};

  explicit ValidLanes(std::size_t count) {
    std::fill_n(lanes.begin(), std::min(count, kLanes), -1);
  }
};

}  // namespace

Embree3Packets::Embree3Packets(RTCScene scene, std::span<const Rayf> rays, bool asksForAnyHit,
                               const PacketLayout& layout)
    : scene_(scene),
      rays_(rays),
      asksForAnyHit_(asksForAnyHit),
      areCoherent_(layout.areCoherent),
      order_(orderOf(rays.size(), layout.pictureWidth)) {
  const std::size_t packetCount = packetCountFor(rays.size());
  if (asksForAnyHit_)
    shadowRays_.resize(packetCount);
  else
    rayHits_.resize(packetCount);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    RTCRay8& packet = asksForAnyHit_ ? shadowRays_[i / kLanes] : rayHits_[i / kLanes].ray;
    writeRay(rays_[order_[i]], packet, i % kLanes);
  }
  reset();
}

void Embree3Packets::reset() {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const std::size_t lane = i % kLanes;
    const float tMax = rays_[order_[i]].tMax;
    if (asksForAnyHit_) {
      shadowRays_[i / kLanes].tfar[lane] = tMax;
      continue;
    }
    RTCRayHit8& packet = rayHits_[i / kLanes];
    packet.ray.tfar[lane] = tMax;
    packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  }
}

void Embree3Packets::trace(unsigned threadCount) {
  const std::size_t packetCount = packetCountFor(rays_.size());
  const ValidLanes all(kLanes);
  const ValidLanes ofLast(rays_.size() - (packetCount - 1) * kLanes);
  const auto lanesOf = [&](std::size_t packet) {
    return (packet + 1 == packetCount ? ofLast : all).lanes.data();
  };
  parallelFor(packetCount, kPacketsOfAPiece, threadCount, [&](std::size_t begin, std::size_t end) {
    const DenormalsFlushed flushed;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags =
        areCoherent_ ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    for (std::size_t i = begin; i < end; ++i) {
      if (asksForAnyHit_)
        rtcOccluded8(lanesOf(i), scene_, &context, &shadowRays_[i]);
      else
        rtcIntersect8(lanesOf(i), scene_, &context, &rayHits_[i]);
    }
  });
}

void Embree3Packets::readAnswers(Answers& answers) const {
  if (asksForAnyHit_)
    readOcclusions(answers.occluded);
  else
    readHits(answers.hits);
}

void Embree3Packets::readHits(std::span<Hitf> hits) const {
  for (std::size_t i = 0; i < order_.size(); ++i)
    hits[order_[i]] = readHit(rayHits_[i / kLanes], i % kLanes);
}

void Embree3Packets::readOcclusions(std::span<std::uint8_t> occluded) const {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    // Embree tells an occluded ray by a negative tfar.
    occluded[order_[i]] = shadowRays_[i / kLanes].tfar[i % kLanes] < 0.0f ? 1 : 0;
  }
}

}  // namespace planetree::bench
