#include "soak/embree_leaks.hpp"

#ifdef PLANETREE_SOAK_EMBREE

#include <embree3/rtcore.h>

#include <algorithm>
#include <stdexcept>

namespace planetree::test {

struct EmbreeScene::Impl {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = nullptr;

  Impl() {
    if (!device)
      throw std::runtime_error("Embree made no device. Is its library damaged? Install it anew.");
    scene = rtcNewScene(device);
  }
  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
};

bool EmbreeScene::isAvailable() noexcept {
  return true;
}

const char* EmbreeScene::version() noexcept {
  return RTC_VERSION_STRING;
}

EmbreeScene::EmbreeScene(const TriangleMesh<float>& mesh, EmbreeMode mode)
    : impl_(std::make_unique<Impl>()) {
  const RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  // Embree reads corners sixteen bytes at a time, so that its own buffer is the safe place.
  auto* const positions = static_cast<Vec3f*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f),
                              mesh.positions.size()));
  std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.faces.data(), 0, sizeof(FaceIndices), mesh.faces.size());
  rtcSetSceneFlags(impl_->scene,
                   mode == EmbreeMode::Robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
  if (rtcGetDeviceError(impl_->device) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree could not build. Leave it out, or use smaller meshes.");
}

EmbreeScene::~EmbreeScene() = default;

std::uint64_t EmbreeScene::countLeaks(std::span<const Rayf> rays) const {
  std::uint64_t leaks = 0;
  for (const Rayf& ray : rays) {
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x;
    query.ray.org_y = ray.origin.y;
    query.ray.org_z = ray.origin.z;
    query.ray.tnear = ray.tMin;
    query.ray.dir_x = ray.direction.x;
    query.ray.dir_y = ray.direction.y;
    query.ray.dir_z = ray.direction.z;
    query.ray.tfar = ray.tMax;
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCRay shadow = query.ray;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(impl_->scene, &context, &query);
    rtcInitIntersectContext(&context);
    rtcOccluded1(impl_->scene, &context, &shadow);
    // What is occluded gets a negative end.
    const bool isLeak = query.hit.geomID == RTC_INVALID_GEOMETRY_ID || shadow.tfar >= 0.0f;
    leaks += isLeak ? 1u : 0u;
  }
  return leaks;
}

}  // namespace planetree::test

#else

namespace planetree::test {

struct EmbreeScene::Impl {};

bool EmbreeScene::isAvailable() noexcept {
  return false;
}
const char* EmbreeScene::version() noexcept {
  return "";
}
EmbreeScene::EmbreeScene(const TriangleMesh<float>&, EmbreeMode) {}
EmbreeScene::~EmbreeScene() = default;
std::uint64_t EmbreeScene::countLeaks(std::span<const Rayf>) const {
  return 0;
}

}  // namespace planetree::test

#endif
