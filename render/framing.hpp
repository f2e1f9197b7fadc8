#pragma once

#include "render/camera.hpp"

#include <planetree/geometry/vec3.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <optional>
#include <span>
#include <vector>

namespace planetree::render {

/// Which coordinate points up in a model.
enum class UpAxis { Y, Z };

[[nodiscard]] Vec3f upVector(UpAxis up) noexcept;

/// How a model is to be looked at.
struct Framing {
  UpAxis up = UpAxis::Y;
  float fovDegrees = 40.0f;
  double aspect = 4.0 / 3.0;  ///< width of the picture divided by its height
  bool showsBox = false;      ///< the box around the model has to be in the picture, too
};

/// The camera that shows all of a model, a little from the right and from above, as near as the
/// frame allows. Far strays are left out: points outside the box from the 2nd to the 98th
/// percentile of each coordinate, after the box was enlarged to every side by its largest size.
/// Points not finite do not count. Nothing without any finite point. Linear in the points.
[[nodiscard]] std::optional<Camera> frameCamera(std::span<const Vec3f> points,
                                                const Framing& framing);

/// The corners of a mesh's usable faces, each vertex once: what of the mesh can be seen.
[[nodiscard]] std::vector<Vec3f> visiblePoints(const TriangleMeshView<float>& mesh);

}  // namespace planetree::render
