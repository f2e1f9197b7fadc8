#include "bench/rivals/engines.hpp"

#include <planetree/geometry/vec3.hpp>

// CGAL's own headers bring warnings that are not ours to mend; the build marks them as the
// system's.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

/// CGAL's AABB_tree with the kernel that its manual uses: exact predicates, constructions in
/// double.
namespace planetree::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 toPoint(const Vec3f& p) {
  return {p.x, p.y, p.z};
}

Vec3d toVector(const Kernel::Vector_3& v) {
  return {v.x(), v.y(), v.z()};
}

/// The weights of the second and third corner at a point of the triangle; `normal` has the length
/// of twice its area.
std::pair<double, double> weights(const Vec3d& ab, const Vec3d& ac, const Vec3d& ap,
                                  const Vec3d& normal) {
  const double squared = dot(normal, normal);
  return {dot(cross(ap, ac), normal) / squared, dot(cross(ab, ap), normal) / squared};
}

/// The rays must begin at tMin = 0, as all of the benchmark do: CGAL knows no other beginning.
class CgalStructure final : public Structure {
 public:
  explicit CgalStructure(const TriangleMesh<float>& mesh) {
    triangles_.reserve(mesh.faces.size());
    for (const auto& [a, b, c] : mesh.faces) {
      triangles_.emplace_back(toPoint(mesh.positions[a]), toPoint(mesh.positions[b]),
                              toPoint(mesh.positions[c]));
    }
    // Triangles without area break a precondition of CGAL's intersection.
    for (auto triangle = triangles_.cbegin(); triangle != triangles_.cend(); ++triangle) {
      if (!triangle->is_degenerate())
        tree_.insert(Primitive(triangle));
    }
    tree_.build();
  }

  void findIntersections(std::span<const Rayf> rays, std::span<Hitf> hits) const override {
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = findIntersection(rays[i]);
  }

  void findOcclusions(std::span<const Rayf> rays, std::span<std::uint8_t> occluded) const override {
    for (std::size_t i = 0; i < rays.size(); ++i)
      occluded[i] = isOccluded(rays[i]) ? 1 : 0;
  }

 private:
  [[nodiscard, gnu::noinline]] Hitf findIntersection(const Rayf& ray) const;
  [[nodiscard, gnu::noinline]] bool isOccluded(const Rayf& ray) const;

  Triangles triangles_;
  Tree tree_;
};

Kernel::Ray_3 toCgal(const Rayf& ray) {
  return {toPoint(ray.origin), Kernel::Vector_3(ray.direction.x, ray.direction.y, ray.direction.z)};
}

/// The distance at which a unit direction meets what a ray and a triangle share: a point, or a
/// segment where the ray lies in the triangle.
struct NearestDistance {
  using result_type = double;

  const Kernel::Ray_3& ray;

  double operator()(const Kernel::Point_3& point) const {
    return (point - ray.source()) * ray.to_vector();
  }
  double operator()(const Kernel::Segment_3& segment) const {
    return std::min((*this)(segment.source()), (*this)(segment.target()));
  }
};

Hitf CgalStructure::findIntersection(const Rayf& ray) const {
  const Kernel::Ray_3 query = toCgal(ray);
  const auto found = tree_.first_intersection(query);
  if (!found)
    return {};
  const double t = boost::apply_visitor(NearestDistance{query}, found->first);
  if (t > static_cast<double>(ray.tMax))
    return {};
  const auto& triangle = *found->second;
  const Vec3d ab = toVector(triangle[1] - triangle[0]);
  const Vec3d ac = toVector(triangle[2] - triangle[0]);
  const Vec3d ap = toVector(query.source() + t * query.to_vector() - triangle[0]);
  const Vec3d normal = cross(ab, ac);
  const auto [u, v] = weights(ab, ac, ap, normal);
  return {.t = static_cast<float>(t),
          .u = static_cast<float>(u),
          .v = static_cast<float>(v),
          .normal = Vec3f(normal),
          .geometry = 0,
          .primitive = static_cast<std::uint32_t>(found->second - triangles_.cbegin())};
}

bool CgalStructure::isOccluded(const Rayf& ray) const {
  const Kernel::Ray_3 query = toCgal(ray);
  if (!std::isfinite(ray.tMax))
    return tree_.do_intersect(query);
  const Kernel::Point_3 end = query.source() + static_cast<double>(ray.tMax) * query.to_vector();
  return tree_.do_intersect(Kernel::Segment_3(query.source(), end));
}

class CgalEngine final : public Engine {
 public:
  [[nodiscard]] std::string name() const override { return "cgal"; }
  [[nodiscard]] std::string mode() const override { return "aabb-tree"; }
  [[nodiscard]] bool isDefault() const override { return true; }

  /// Its primitives must come with CGAL's own intersections.
  [[nodiscard]] bool takesShapes() const override { return false; }

  /// CGAL builds on one thread, whatever is asked for.
  [[nodiscard]] std::unique_ptr<Structure> build(const SceneObjects& objects,
                                                 unsigned /*threadCount*/) const override {
    if (objects.mesh() == nullptr)
      throw std::logic_error("CGAL takes no shapes. Leave it out.");
    return std::make_unique<CgalStructure>(*objects.mesh());
  }
};

}  // namespace

EngineList cgalEngines() {
  EngineList engines;
  engines.push_back(std::make_unique<CgalEngine>());
  return engines;
}

}  // namespace planetree::bench
