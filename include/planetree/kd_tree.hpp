#pragma once

#include <planetree/any_object.hpp>
#include <planetree/batch/trace_batch.hpp>
#include <planetree/detail/leaf_objects.hpp>
#include <planetree/detail/tree_data.hpp>
#include <planetree/node/node.hpp>
#include <planetree/node/tree_statistics.hpp>
#include <planetree/object.hpp>
#include <planetree/traversal/explain_intersection.hpp>
#include <planetree/traversal/find_intersection.hpp>
#include <planetree/traversal/find_intersections.hpp>
#include <planetree/traversal/leaf_node_intersection.hpp>
#include <planetree/traversal/split_node_intersection.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace planetree {

/// A kd-tree over objects, made by `buildTree` and never changed after. It answers which object a
/// ray hits first, and whether it hits any.
///
/// Every query may be made from any number of threads at once; all but batches and explained ones
/// are `noexcept` and allocate nothing. Copies are cheap: they share one tree. The coordinates
/// within which no hit is missed are in docs/limits.md.
template <Object O>
class KdTree {
 public:
  using Scalar = ScalarOf<O>;

  /// A tree without objects, which every ray misses.
  KdTree() : KdTree(detail::TreeData<Scalar>{.nodes = {LeafNode(0, 0)}}) {}

  // Moving copies, which is as cheap: a tree that was moved from can still be asked.
  KdTree(const KdTree&) = default;
  KdTree& operator=(const KdTree&) = default;
  ~KdTree() = default;

  explicit KdTree(detail::TreeData<Scalar> data)
      : data_(std::make_shared<const detail::TreeData<Scalar>>(std::move(data))),
        view_{data_->nodes, data_->references, data_->geometries, data_->bounds,
              data_->wide.get()} {}

  // --- queries ---

  /// The nearest hit with t in [ray.tMin, ray.tMax], or nothing. Of hits at the same t the one with
  /// the lower (geometry, primitive, part) wins: the answer is bit for bit what testing every
  /// object one by one would give, whatever the build options were.
  [[nodiscard]] std::optional<Hit<Scalar>> findIntersection(
      const Ray<Scalar>& ray, const QueryOptions& options = {}) const noexcept {
    return planetree::findIntersection(view(), ray, options);
  }
  /// The same, and adds the work done to `steps`.
  [[nodiscard]] std::optional<Hit<Scalar>> findIntersection(
      const Ray<Scalar>& ray, StepCounts& steps, const QueryOptions& options = {}) const noexcept {
    return planetree::findIntersection(view(), ray, options, &steps);
  }

  /// Whether the ray hits anything with t in [ray.tMin, ray.tMax]. Faster than the nearest hit.
  [[nodiscard]] bool isOccluded(const Ray<Scalar>& ray,
                                const QueryOptions& options = {}) const noexcept {
    return planetree::isOccluded(view(), ray, options);
  }
  /// The same, and adds the work done to `steps`.
  [[nodiscard]] bool isOccluded(const Ray<Scalar>& ray, StepCounts& steps,
                                const QueryOptions& options = {}) const noexcept {
    return planetree::isOccluded(view(), ray, options, &steps);
  }

  /// All hits of the ray, each once, in the order of `isBefore`: as many as `hits` has room for,
  /// and whether there are more. See find_intersections.hpp, also for what these cost.
  [[nodiscard]] FoundHits findIntersections(const Ray<Scalar>& ray, std::span<Hit<Scalar>> hits,
                                            const QueryOptions& options = {}) const noexcept {
    return planetree::findIntersections(view(), ray, hits, options);
  }
  /// The hits behind another one.
  [[nodiscard]] FoundHits findNextIntersections(const Ray<Scalar>& ray, const Hit<Scalar>& after,
                                                std::span<Hit<Scalar>> hits,
                                                const QueryOptions& options = {}) const noexcept {
    return planetree::findNextIntersections(view(), ray, after, hits, options);
  }
  /// The first hit behind another one, or nothing; with it all hits can be visited without storage.
  [[nodiscard]] std::optional<Hit<Scalar>> findNextIntersection(
      const Ray<Scalar>& ray, const Hit<Scalar>& after,
      const QueryOptions& options = {}) const noexcept {
    return planetree::findNextIntersection(view(), ray, after, options);
  }

  /// Many rays in one call, with the same answers; see trace_batch.hpp. The nearest hit of each
  /// ray, default-made where it misses, and whether it hits any, as 1 or 0. These return how many
  /// rays hit something.
  std::size_t findIntersections(std::span<const Ray<Scalar>> rays, std::span<Hit<Scalar>> hits,
                                const BatchOptions& options = {},
                                const BatchControl& control = {}) const {
    return planetree::findIntersections(view(), rays, hits, options, control);
  }
  std::size_t findIntersections(const RayArrays<Scalar>& rays, const HitArrays<Scalar>& hits,
                                const BatchOptions& options = {},
                                const BatchControl& control = {}) const {
    return planetree::findIntersections(view(), rays, hits, options, control);
  }
  std::size_t areOccluded(std::span<const Ray<Scalar>> rays, std::span<std::uint8_t> flags,
                          const BatchOptions& options = {},
                          const BatchControl& control = {}) const {
    return planetree::areOccluded(view(), rays, flags, options, control);
  }
  std::size_t areOccluded(const RayArrays<Scalar>& rays, std::span<std::uint8_t> flags,
                          const BatchOptions& options = {},
                          const BatchControl& control = {}) const {
    return planetree::areOccluded(view(), rays, flags, options, control);
  }

  /// The nearest hit, or any, told step by step, for looking at single rays. These allocate.
  [[nodiscard]] Walk<Scalar> explainIntersection(const Ray<Scalar>& ray,
                                                 const QueryOptions& options = {}) const {
    return planetree::explainIntersection(view(), ray, options);
  }
  [[nodiscard]] Walk<Scalar> explainOcclusion(const Ray<Scalar>& ray,
                                              const QueryOptions& options = {}) const {
    return planetree::explainOcclusion(view(), ray, options);
  }

  // --- geometry ---

  /// The box around all objects in the tree; empty without any.
  [[nodiscard]] const Box3& bounds() const noexcept { return data_->bounds; }

  /// Objects in the tree and skipped ones together, over all geometries.
  [[nodiscard]] std::uint64_t objectCount() const noexcept { return data_->report.objectCount; }

  [[nodiscard]] std::size_t geometryCount() const noexcept { return data_->geometries.size(); }
  /// How many objects a geometry has, the skipped ones included.
  [[nodiscard]] std::size_t primitiveCount(std::uint32_t geometry) const noexcept {
    return data_->geometries[geometry].size;
  }
  /// What a geometry was added with; `geometry` as in `Hit`.
  [[nodiscard]] std::uint32_t geometryMask(std::uint32_t geometry) const noexcept {
    return data_->geometries[geometry].mask;
  }
  [[nodiscard]] void* userPointer(std::uint32_t geometry) const noexcept {
    return data_->geometries[geometry].userPointer;
  }

  /// The object that a hit names (not one that was skipped); by value where the tree holds handles
  /// (`Face`, `AnyObject`).
  [[nodiscard]] decltype(auto) object(std::uint32_t geometry, std::uint32_t primitive) const {
    if constexpr (std::same_as<O, AnyObject<Scalar>>) {
      return AnyObject<Scalar>(data_->geometries[geometry], geometry, primitive);
    } else {
      using Range = typename detail::RangeOf<O>::type;
      return (*static_cast<const Range*>(data_->geometries[geometry].range))[primitive];
    }
  }

  // --- the structure ---

  /// The root; a `SplitNode` or a `LeafNode`. Nodes live as long as the tree or a copy of it.
  [[nodiscard]] const Node& root() const noexcept { return data_->nodes.front(); }

  /// The object with this number; `references` and `objects` say what the numbers are.
  [[nodiscard]] decltype(auto) object(std::uint32_t number) const {
    const std::uint32_t geometry = detail::geometryOf<Scalar>(data_->geometries, number);
    return object(geometry, number - data_->geometries[geometry].firstObject);
  }

  /// The objects of a leaf of this tree, in rising order of their number, as a range. The tree, not
  /// a copy of it, must outlive the range.
  [[nodiscard]] detail::LeafObjects<KdTree> objects(const LeafNode& leaf) const noexcept {
    return {*this, references(leaf)};
  }

  /// The entries of a leaf of this tree. They number the objects of all geometries one after the
  /// other; with one geometry they are its primitives.
  [[nodiscard]] std::span<const std::uint32_t> references(const LeafNode& leaf) const noexcept {
    return std::span(data_->references).subspan(leaf.firstReference(), leaf.count());
  }

  /// All nodes, depth first, the root in front.
  [[nodiscard]] std::span<const Node> nodes() const noexcept { return data_->nodes; }

  /// The search below one node of this tree, under the names of the algorithm as it is taught:
  /// hits with t in [tMin, tMax] that come before `i` replace it, and the answer is whether one
  /// did. See split_node_intersection.hpp for the steps of a split.
  bool findIntersection(const Node& node, const Ray<Scalar>& r, Hit<Scalar>& i, Scalar tMin,
                        Scalar tMax) const noexcept {
    return node.isLeaf() ? planetree::findIntersection(node.leaf(), view(), r, i, tMin, tMax)
                         : planetree::findIntersection(node.split(), view(), r, i, tMin, tMax);
  }

  /// The arrays of the tree, for functions of the traversal headers. Valid as long as this tree.
  [[nodiscard]] const TreeView<Scalar>& view() const noexcept { return view_; }

  // --- reports ---

  /// How it was built, and which objects were skipped.
  [[nodiscard]] const BuildReport& report() const noexcept { return data_->report; }
  [[nodiscard]] const BuildOptions& options() const noexcept { return data_->options; }

  /// The tree in numbers. Walks it: linear in the nodes.
  [[nodiscard]] TreeStatistics statistics() const {
    const CostModel& cost = data_->options.cost;
    return treeStatistics(data_->nodes, data_->bounds,
                          {cost.traversalCost, detail::intersectionCostOf(*data_)});
  }

 private:
  std::shared_ptr<const detail::TreeData<Scalar>> data_;
  TreeView<Scalar> view_;  ///< of `data_`, made once: every query needs it
};

}  // namespace planetree
