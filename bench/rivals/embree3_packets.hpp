#pragma once

#include "bench/rivals/engine.hpp"

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>

#include <embree3/rtcore.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::bench {

/// What is known of rays when they are put into packets.
struct PacketLayout {
  std::size_t pictureWidth = 0;  ///< as in `RaySet`
  bool areCoherent = false;      ///< neighbours go the same way
};

/// Rays in packets of eight, as Embree 3 takes them, and hits that stay in the packets.
class Embree3Packets final : public Batch {
 public:
  /// The rays and the scene outlive the packets, which are ready to be traced.
  Embree3Packets(RTCScene scene, std::span<const Rayf> rays, bool asksForAnyHit,
                 const PacketLayout& layout);

  void reset() override;
  void trace(unsigned threadCount) override;
  void readAnswers(Answers& answers) const override;

  void readHits(std::span<Hitf> hits) const;
  void readOcclusions(std::span<std::uint8_t> occluded) const;

 private:
  RTCScene scene_;
  std::span<const Rayf> rays_;
  bool asksForAnyHit_;
  bool areCoherent_;
  /// The ray in each lane of the packets, one packet after the other. The last packet may have
  /// fewer rays than lanes.
  std::vector<std::uint32_t> order_;
  // One of the two, by the question.
  std::vector<RTCRayHit8> rayHits_;
  std::vector<RTCRay8> shadowRays_;
};

}  // namespace planetree::bench
