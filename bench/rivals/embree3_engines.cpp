#include "bench/rivals/denormals_flushed.hpp"
#include "bench/rivals/embree3_packets.hpp"
#include "bench/rivals/engines.hpp"

#include <embree3/rtcore.h>

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

/// Embree 3 from Debian, used as its manual recommends: denormals are flushed while it works.
namespace planetree::bench {

namespace {

RTCRay toEmbree(const Rayf& ray) {
  RTCRay out;
  out.org_x = ray.origin.x;
  out.org_y = ray.origin.y;
  out.org_z = ray.origin.z;
  out.tnear = ray.tMin;
  out.dir_x = ray.direction.x;
  out.dir_y = ray.direction.y;
  out.dir_z = ray.direction.z;
  out.time = 0.0f;
  out.tfar = ray.tMax;
  out.mask = ~0u;
  out.id = 0;
  out.flags = 0;
  return out;
}

Hitf fromEmbree(const RTCRayHit& found) {
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    return {};
  return {.t = found.ray.tfar,
          .u = found.hit.u,
          .v = found.hit.v,
          .normal = {found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z},
          .geometry = found.hit.geomID,
          .primitive = found.hit.primID};
}

/// What Embree hands on to the callbacks of shapes: with it the ray as it was given need not be put
/// together again from Embree's.
struct RayContext {
  RTCIntersectContext embree;  ///< first, so that a pointer to it is one to the whole
  const Rayf* ray = nullptr;

  RayContext() { rtcInitIntersectContext(&embree); }

  [[nodiscard]] static const Rayf& rayOf(const RTCIntersectContext* context) noexcept {
    return *reinterpret_cast<const RayContext*>(context)->ray;
  }
};

template <class S>
const S& shapeOf(const void* shapes, unsigned number) noexcept {
  return static_cast<const S*>(shapes)[number];
}

template <class S>
void boundShape(const RTCBoundsFunctionArguments* arguments) {
  const Box3 box = objectBounds(shapeOf<S>(arguments->geometryUserPtr, arguments->primID));
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = box.lower.x;
  bounds.lower_y = box.lower.y;
  bounds.lower_z = box.lower.z;
  bounds.upper_x = box.upper.x;
  bounds.upper_y = box.upper.y;
  bounds.upper_z = box.upper.z;
}

/// For single rays: modes with packets take no shapes.
template <class S>
void intersectShape(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0)
    return;
  auto& found = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  const auto hit =
      objectIntersect(shapeOf<S>(arguments->geometryUserPtr, arguments->primID),
                      RayContext::rayOf(arguments->context), found.ray.tnear, found.ray.tfar);
  if (!hit)
    return;
  found.ray.tfar = hit->t;
  found.hit.u = hit->u;
  found.hit.v = hit->v;
  found.hit.Ng_x = hit->normal.x;
  found.hit.Ng_y = hit->normal.y;
  found.hit.Ng_z = hit->normal.z;
  found.hit.primID = arguments->primID;
  found.hit.geomID = arguments->geomID;
  found.hit.instID[0] = arguments->context->instID[0];
}

template <class S>
void occludeShape(const RTCOccludedFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0)
    return;
  auto& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
  if (objectIntersect(shapeOf<S>(arguments->geometryUserPtr, arguments->primID),
                      RayContext::rayOf(arguments->context), ray.tnear, ray.tfar))
    ray.tfar = -std::numeric_limits<float>::infinity();
}

/// The geometry of a mesh or of shapes, to be released by the caller.
RTCGeometry makeGeometry(RTCDevice device, const TriangleMesh<float>& mesh) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.positions.data(), 0, sizeof(Vec3f), mesh.positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.faces.data(), 0, sizeof(FaceIndices), mesh.faces.size());
  return geometry;
}
template <class S>
RTCGeometry makeGeometry(RTCDevice device, std::span<const S> shapes) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(shapes.size()));
  // Embree has no pointer to const; the callbacks only read.
  rtcSetGeometryUserData(geometry, const_cast<S*>(shapes.data()));
  rtcSetGeometryBoundsFunction(geometry, &boundShape<S>, nullptr);
  rtcSetGeometryIntersectFunction(geometry, &intersectShape<S>);
  rtcSetGeometryOccludedFunction(geometry, &occludeShape<S>);
  return geometry;
}
RTCGeometry makeGeometry(RTCDevice device, const SceneObjects& objects) {
  if (const TriangleMesh<float>* const mesh = objects.mesh())
    return makeGeometry(device, *mesh);
  return objects.visit([&]<class Input>(const Input& shapes) -> RTCGeometry {
    if constexpr (std::is_same_v<Input, TriangleMeshView<float>>)
      return nullptr;
    else
      return makeGeometry(device, shapes);
  });
}

/// Threads, and what Embree keeps for all scenes of a program. Making one is not part of a build.
class Device {
 public:
  explicit Device(unsigned threadCount)
      : device_(rtcNewDevice(("threads=" + std::to_string(threadCount)).c_str())) {
    if (!device_)
      throw std::runtime_error("Embree made no device. Is its library damaged? Install it anew.");
  }
  ~Device() { rtcReleaseDevice(device_); }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] RTCDevice get() const noexcept { return device_; }

  /// The device for a number of threads; the last one stays until another number is asked for.
  static std::shared_ptr<const Device> with(unsigned threadCount) {
    static std::pair<unsigned, std::shared_ptr<const Device>> last;
    if (!last.second || last.first != threadCount) {
      last.second.reset();
      last = {threadCount, std::make_shared<const Device>(threadCount)};
    }
    return last.second;
  }

 private:
  RTCDevice device_;
};

/// A scene that is built, without a way to ask it.
class Embree3Structure : public Structure {
 public:
  Embree3Structure(std::shared_ptr<const Device> device, const SceneObjects& objects,
                   RTCBuildQuality quality, RTCSceneFlags flags)
      : device_(std::move(device)), scene_(rtcNewScene(device_->get())) {
    const DenormalsFlushed flushed;
    rtcSetSceneBuildQuality(scene_, quality);
    rtcSetSceneFlags(scene_, flags);
    const RTCGeometry geometry = makeGeometry(device_->get(), objects);
    rtcSetGeometryBuildQuality(geometry, quality);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_->get()) != RTC_ERROR_NONE) {
      rtcReleaseScene(scene_);
      throw std::runtime_error("Embree could not build. Try a smaller scene, or leave it out.");
    }
  }
  ~Embree3Structure() override { rtcReleaseScene(scene_); }

 protected:
  [[nodiscard]] RTCScene scene() const noexcept { return scene_; }

 private:
  std::shared_ptr<const Device> device_;
  RTCScene scene_;
};

/// Asked by single rays.
class SingleRayStructure final : public Embree3Structure {
 public:
  using Embree3Structure::Embree3Structure;

  void findIntersections(std::span<const Rayf> rays, std::span<Hitf> hits) const override {
    const DenormalsFlushed flushed;
    RayContext context;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRayHit rayHit;
      rayHit.ray = toEmbree(rays[i]);
      rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      context.ray = &rays[i];
      rtcIntersect1(scene(), &context.embree, &rayHit);
      hits[i] = fromEmbree(rayHit);
    }
  }

  void findOcclusions(std::span<const Rayf> rays, std::span<std::uint8_t> occluded) const override {
    const DenormalsFlushed flushed;
    RayContext context;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRay ray = toEmbree(rays[i]);
      context.ray = &rays[i];
      rtcOccluded1(scene(), &context.embree, &ray);
      // Embree tells an occluded ray by a negative tfar.
      occluded[i] = ray.tfar < 0.0f ? 1 : 0;
    }
  }
};

/// Asked by packets of rays.
class PacketStructure final : public Embree3Structure {
 public:
  using Embree3Structure::Embree3Structure;

  void findIntersections(std::span<const Rayf> rays, std::span<Hitf> hits) const override {
    Embree3Packets packets(scene(), rays, false, PacketLayout());
    packets.trace(1);
    packets.readHits(hits);
  }

  void findOcclusions(std::span<const Rayf> rays, std::span<std::uint8_t> occluded) const override {
    Embree3Packets packets(scene(), rays, true, PacketLayout());
    packets.trace(1);
    packets.readOcclusions(occluded);
  }

  [[nodiscard]] std::unique_ptr<Batch> makeBatch(const RaySet& set,
                                                 std::size_t /*callSize*/) const override {
    return std::make_unique<Embree3Packets>(
        scene(), set.rays, asksForAnyHit(set.kind),
        PacketLayout{.pictureWidth = set.pictureWidth,
                     .areCoherent = set.kind == RayKind::Primary});
  }
};

/// `S` is what it builds: a `SingleRayStructure` or a `PacketStructure`.
template <class S>
class Embree3Engine final : public Engine {
 public:
  Embree3Engine(std::string mode, RTCBuildQuality quality, RTCSceneFlags flags)
      : mode_(std::move(mode)), quality_(quality), flags_(flags) {}

  [[nodiscard]] std::string name() const override { return "embree3"; }
  [[nodiscard]] std::string mode() const override { return mode_; }
  [[nodiscard]] bool isDefault() const override {
    return !kHasPackets && quality_ == RTC_BUILD_QUALITY_MEDIUM && flags_ == RTC_SCENE_FLAG_NONE;
  }
  /// Shapes are told the ray as it was given, which a packet has not kept.
  [[nodiscard]] bool takesShapes() const override { return !kHasPackets; }

  void prepare(unsigned threadCount) const override {
    static_cast<void>(Device::with(threadCount));
  }

  [[nodiscard]] std::unique_ptr<Structure> build(const SceneObjects& objects,
                                                 unsigned threadCount) const override {
    return std::make_unique<S>(Device::with(threadCount), objects, quality_, flags_);
  }

 private:
  static constexpr bool kHasPackets = std::is_same_v<S, PacketStructure>;

  std::string mode_;
  RTCBuildQuality quality_;
  RTCSceneFlags flags_;
};

constexpr std::array kVariants = {std::pair("", RTC_SCENE_FLAG_NONE),
                                  std::pair("-robust", RTC_SCENE_FLAG_ROBUST)};

}  // namespace

EngineList embree3Engines() {
  const std::array qualities = {std::pair("low", RTC_BUILD_QUALITY_LOW),
                                std::pair("medium", RTC_BUILD_QUALITY_MEDIUM),
                                std::pair("high", RTC_BUILD_QUALITY_HIGH)};
  EngineList engines;
  for (const auto& [suffix, flags] : kVariants) {
    for (const auto& [name, quality] : qualities) {
      engines.push_back(std::make_unique<Embree3Engine<SingleRayStructure>>(
          std::string(name) + suffix, quality, flags));
    }
  }
  return engines;
}

EngineList embree3EnginesForBatches() {
  // Not the low quality: for rays it never is the best.
  const std::array qualities = {std::pair("medium", RTC_BUILD_QUALITY_MEDIUM),
                                std::pair("high", RTC_BUILD_QUALITY_HIGH)};
  EngineList engines;
  for (const auto& [suffix, flags] : kVariants) {
    for (const auto& [name, quality] : qualities) {
      engines.push_back(std::make_unique<Embree3Engine<PacketStructure>>(
          std::string(name) + suffix + "-packets", quality, flags));
    }
  }
  return engines;
}

}  // namespace planetree::bench
