#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <memory>
#include <span>

/// The same rays put to Embree, where the build has found it.
namespace planetree::test {

enum class EmbreeMode : std::uint8_t {
  Robust,  ///< RTC_SCENE_FLAG_ROBUST: Embree's own answer to leaks
  Fast,    ///< without flags
};

/// A mesh in a scene of Embree. Denormals are not flushed, which Embree advises for speed alone.
/// May be asked from several threads.
class EmbreeScene {
 public:
  /// False if the program was built without Embree; then there is no scene to be made.
  [[nodiscard]] static bool isAvailable() noexcept;
  /// Such as "3.13.5"; empty without Embree.
  [[nodiscard]] static const char* version() noexcept;

  /// The mesh must outlive the scene.
  EmbreeScene(const TriangleMesh<float>& mesh, EmbreeMode mode);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// How many of the rays find no nearest hit, or seem to be free.
  [[nodiscard]] std::uint64_t countLeaks(std::span<const Rayf> rays) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace planetree::test
