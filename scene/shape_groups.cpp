#include "scene/shape_groups.hpp"

#include "scene/transformed_shape.hpp"

#include <planetree/error.hpp>
#include <planetree/shape/cone.hpp>
#include <planetree/shape/cylinder.hpp>
#include <planetree/shape/sphere.hpp>
#include <planetree/shape/square.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace planetree::scene {

namespace {

constexpr std::uint32_t kFacesPerBox = 12;

/// Whether circles around z stay circles, and upright on the axis: then a cone stays a cone.
bool keepsConesRight(const Affine& placement) noexcept {
  constexpr double kTolerance = 1e-12;
  const Vec3d& x = placement.column(0);
  const Vec3d& y = placement.column(1);
  const Vec3d& z = placement.column(2);
  const double xx = dot(x, x);
  const double tilt = kTolerance * std::sqrt(xx * dot(z, z));
  return std::fabs(dot(y, y) - xx) <= kTolerance * xx && std::fabs(dot(x, y)) <= kTolerance * xx &&
         std::fabs(dot(x, z)) <= tilt && std::fabs(dot(y, z)) <= tilt;
}

/// Shapes of one kind, and where each comes from.
template <class S>
struct ShapeList {
  std::vector<S> objects;
  ShapeGroup group;

  void add(S object, std::uint32_t shape) {
    objects.push_back(std::move(object));
    group.shapes.push_back(shape);
  }
};

/// Sorts shapes into lists of one kind each, so that a thousand spheres are one geometry.
class ShapeSorter {
 public:
  explicit ShapeSorter(const SceneDescription& description) : description_(description) {}

  GroupedShapes sorted() {
    for (std::size_t i = 0; i < description_.shapes.size(); ++i) {
      shape_ = static_cast<std::uint32_t>(i);
      placement_ = &description_.shapes[i].placement;
      const auto inverse = placement_->inverse();
      if (!placement_->isFinite() || !inverse) {
        throw Error(ErrorCode::InvalidGeometry,
                    "the transform of shape " + std::to_string(i) + " is singular",
                    "Scale by factors other than zero.");
      }
      toLocal_ = *inverse;
      std::visit([&](const auto& shape) { add(shape); }, description_.shapes[i].shape);
    }
    addList(spheres_);
    addList(squares_);
    addList(cylinders_);
    addList(cones_);
    addList(ellipsoids_);
    addList(transformedCones_);
    if (!boxes_.faces.empty()) {
      boxGroup_.primitivesPerShape = kFacesPerBox;
      result_.scene.add(std::move(boxes_));
      result_.groups.push_back(std::move(boxGroup_));
    }
    return std::move(result_);
  }

 private:
  void add(const UnitSphere&) {
    if (const auto scale = placement_->uniformScale()) {
      spheres_.add({Vec3f(placement_->origin()), static_cast<float>(*scale)}, shape_);
    } else {
      ellipsoids_.add(Ellipsoid({}, *placement_, toLocal_), shape_);
    }
  }

  void add(const UnitSquare&) {
    squares_.add(
        {Vec3f(placement_->origin()), Vec3f(placement_->column(0)), Vec3f(placement_->column(1))},
        shape_);
  }

  /// Twelve triangles: shared corners are rounded but once, so there is no gap at an edge.
  void add(const UnitBox&) {
    const auto first = static_cast<std::uint32_t>(boxes_.positions.size());
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
      const auto side = [corner](std::uint32_t axis) { return (corner >> axis & 1u) - 0.5; };
      boxes_.positions.push_back(Vec3f(placement_->point({side(0), side(1), side(2)})));
    }
    // Two of each side, in the order -x, x, -y, y, -z, z.
    constexpr FaceIndices kFaces[kFacesPerBox] = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},
                                                  {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                  {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    for (const FaceIndices& face : kFaces)
      boxes_.faces.push_back(outward({first + face[0], first + face[1], first + face[2]}));
    boxGroup_.shapes.push_back(shape_);
  }

  void add(const UnitCylinder& cylinder) {
    if (keepsConesRight(*placement_)) {
      cylinders_.add({.base = Vec3f(placement_->origin()),
                      .axis = Vec3f(placement_->column(2)),
                      .radius = static_cast<float>(length(placement_->column(0))),
                      .capped = cylinder.isCapped},
                     shape_);
    } else {
      addTransformed(ConeShape{1.0, 1.0, 1.0, cylinder.isCapped});
    }
  }

  void add(const ConeShape& cone) {
    if (keepsConesRight(*placement_)) {
      const double scale = length(placement_->column(0));
      cones_.add({.base = Vec3f(placement_->origin()),
                  .axis = Vec3f(placement_->column(2) * cone.height),
                  .bottomRadius = static_cast<float>(std::fabs(cone.bottomRadius) * scale),
                  .topRadius = static_cast<float>(std::fabs(cone.topRadius) * scale),
                  .capped = cone.isCapped},
                 shape_);
    } else {
      addTransformed(cone);
    }
  }

  void addTransformed(const ConeShape& cone) {
    const Cone<double> local{.base = {0, 0, 0},
                             .axis = {0, 0, cone.height},
                             .bottomRadius = std::fabs(cone.bottomRadius),
                             .topRadius = std::fabs(cone.topRadius),
                             .capped = cone.isCapped};
    transformedCones_.add(TransformedCone(local, *placement_, toLocal_), shape_);
  }

  void add(const std::shared_ptr<const MeshShape>& mesh) {
    TriangleMesh<float> placed;
    placed.positions.reserve(mesh->positions.size());
    for (const Vec3d& position : mesh->positions)
      placed.positions.push_back(Vec3f(placement_->point(position)));
    placed.faces.reserve(mesh->faces.size());
    for (const FaceIndices& face : mesh->faces)
      placed.faces.push_back(outward(face));
    result_.scene.add(std::move(placed));
    result_.groups.push_back({.shapes = {shape_}, .primitivesPerShape = 0});
  }

  /// A mirrored face turns its back to where it faced: its second and third corner change places.
  [[nodiscard]] FaceIndices outward(const FaceIndices& face) const noexcept {
    return placement_->determinant() < 0.0 ? FaceIndices{face[0], face[2], face[1]} : face;
  }

  template <class S>
  void addList(ShapeList<S>& list) {
    if (list.objects.empty())
      return;
    result_.scene.add(std::move(list.objects));
    result_.groups.push_back(std::move(list.group));
  }

  const SceneDescription& description_;
  std::uint32_t shape_ = 0;
  const Affine* placement_ = nullptr;
  Affine toLocal_;
  ShapeList<Sphere<float>> spheres_;
  ShapeList<Square<float>> squares_;
  ShapeList<Cylinder<float>> cylinders_;
  ShapeList<Cone<float>> cones_;
  ShapeList<Ellipsoid> ellipsoids_;
  ShapeList<TransformedCone> transformedCones_;
  TriangleMesh<float> boxes_;
  ShapeGroup boxGroup_;
  GroupedShapes result_;
};

}  // namespace

GroupedShapes groupShapes(const SceneDescription& description) {
  return ShapeSorter(description).sorted();
}

BoxPlace placeOnUnitBox(const Vec3d& point, std::uint32_t primitive) noexcept {
  const auto place = [](double u, double v) { return BoxPlace{u + 0.5, v + 0.5}; };
  switch (primitive % kFacesPerBox / 2) {
    case 0:  // -x
      return place(point.z, point.y);
    case 1:
      return place(-point.z, point.y);
    case 2:  // -y
      return place(point.x, point.z);
    case 3:
      return place(point.x, -point.z);
    case 4:  // -z
      return place(-point.x, point.y);
    default:
      return place(point.x, point.y);
  }
}

}  // namespace planetree::scene
