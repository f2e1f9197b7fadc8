#include <planetree/detail/bounding_table.hpp>
#include <planetree/detail/tree_data.hpp>
#include <planetree/error.hpp>
#include <planetree/split/scene_range.hpp>

#include "mesh/pack_leaf.hpp"
#include "node/retract_splits.hpp"
#include "node/tree_pieces.hpp"
#include "node/widen_tree.hpp"
#include "split/bound_objects.hpp"
#include "split/build_monitor.hpp"
#include "split/tree_builder.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace planetree::detail {
namespace {

void require(bool condition, const std::string& problem, const std::string& advice) {
  if (!condition)
    throw Error(ErrorCode::InvalidOption, problem, advice);
}

void requireValid(const BuildOptions& options) {
  const auto isCost = [](double cost) { return cost >= 0.0 && std::isfinite(cost); };
  const CostModel& cost = options.cost;
  require(!options.depthLimit || (*options.depthLimit >= 1 && *options.depthLimit <= kMaxTreeDepth),
          "depthLimit is out of range",
          "Give a depth limit from 1 to " + std::to_string(kMaxTreeDepth) +
              ", or none to let it grow with the scene.");
  require(isCost(cost.traversalCost), "cost.traversalCost is negative or not finite",
          "Give a traversal cost of 0 or more, such as 1.5.");
  require(isCost(cost.intersectionCost), "cost.intersectionCost is negative or not finite",
          "Give an intersection cost of 0 or more, such as 1.");
  require(isCost(cost.faceCost), "cost.faceCost is negative or not finite",
          "Give a face cost of 0 or more, such as 0.05.");
  require(cost.emptyBonus >= 0.0 && cost.emptyBonus < 1.0, "cost.emptyBonus is out of range",
          "Give an empty bonus from 0 to less than 1, such as 0.2.");
}

/// Havran and Bittner, "On improving kd-trees for ray shooting", WSCG 2002: 8 + 1.3 log2 N.
std::uint32_t depthLimitFor(const BuildOptions& options, std::size_t objectCount) {
  if (options.depthLimit)
    return *options.depthLimit;
  const double levels =
      8.0 + 1.3 * std::log2(static_cast<double>(std::max<std::size_t>(objectCount, 1)));
  return std::min(static_cast<std::uint32_t>(std::lround(levels)), kMaxTreeDepth);
}

double referenceBudget(const BuildOptions& options, std::size_t objectCount) {
  if (options.referencesPerObject == 0)
    return std::numeric_limits<double>::infinity();
  return static_cast<double>(options.referencesPerObject) * static_cast<double>(objectCount);
}

/// oneTBB complains on standard error if it is asked for more threads than it may have.
int threadCountFor(const BuildOptions& options) {
  const std::size_t allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const std::size_t wanted = options.threadCount;
  return static_cast<int>(wanted == 0 ? allowed : std::min(wanted, allowed));
}

template <class T>
ClipReferences clipperFor(const std::vector<GeometryEntry<T>>& geometries) {
  return [&geometries](const Box3& cell, std::span<Reference> references) {
    while (!references.empty()) {
      const GeometryEntry<T>& geometry =
          geometries[geometryOf<T>(geometries, references.front().object)];
      const std::uint64_t end = std::uint64_t{geometry.firstObject} + geometry.size;
      const auto run = std::partition_point(references.begin(), references.end(),
                                            [&](const Reference& r) { return r.object < end; });
      const auto count = static_cast<std::size_t>(run - references.begin());
      geometry.bounding->clip(geometry.range, geometry.firstObject, cell, references.first(count));
      references = references.subspan(count);
    }
  };
}

/// The options with the costs that the tree's queries have.
template <class T>
BuildOptions optionsFor(const TreeData<T>& tree) {
  BuildOptions options = tree.options;
  options.cost.intersectionCost = intersectionCostOf(tree);
  return options;
}

template <class T>
std::uint32_t commonMaskOf(const std::vector<GeometryEntry<T>>& geometries) noexcept {
  std::uint32_t common = 0xFFFF'FFFFu;
  for (const GeometryEntry<T>& geometry : geometries)
    common &= geometry.mask;
  return common;
}

/// Takes back splits in all pieces at once.
void retractSplits(TreePieces& pieces, const Box3& bounds, LeafCuts cuts,
                   const MakeLeafPacker& makePacker, BuildMonitor& monitor) {
  const SlotPlanner planner(bounds, pieces.referenceCount());
  const auto total = static_cast<double>(std::max<std::size_t>(pieces.referenceCount(), 1));
  tbb::parallel_for(std::size_t{0}, pieces.subtrees().size(), [&](std::size_t i) {
    const NodeArray& subtree = pieces.subtrees()[i];
    const double part = static_cast<double>(subtree.references().size()) / total;
    NodeArray retracted = retractSplits(subtree, cuts, *makePacker(), planner);
    retracted.chargeMemory(monitor.memory());
    pieces.replaceSubtree(i, std::move(retracted));
    monitor.advance(part);
  });
}

std::size_t bytesOfBinaryTree(const TreePieces& pieces) noexcept {
  std::size_t nodeCount = pieces.top().size();
  for (const NodeArray& subtree : pieces.subtrees())
    nodeCount += subtree.nodes().size();
  return nodeCount * sizeof(Node) + pieces.referenceCount() * sizeof(std::uint32_t);
}

template <class T>
bool holdsOnlyFaces(const TreeData<T>& tree) noexcept {
  return std::all_of(tree.geometries.begin(), tree.geometries.end(), isTriangleMesh<T>);
}

}  // namespace

template <class T>
double intersectionCostOf(const TreeData<T>& tree) noexcept {
  return holdsOnlyFaces(tree) ? tree.options.cost.faceCost : tree.options.cost.intersectionCost;
}

template <class T>
TreeData<T> buildTreeData(std::vector<GeometryEntry<T>> geometries, const BuildOptions& options,
                          const BuildControl& control) {
  requireValid(options);
  TreeData<T> tree;
  BuildMonitor monitor(control, tree.report);
  tree.options = options;
  tree.geometries = std::move(geometries);

  const auto build = [&] {
    const bool retracts = options.retractsSplits && holdsOnlyFaces(tree);
    const double whole = retracts ? 0.35 : 1.0;
    monitor.beginPhase("bound", 0.05 * whole);
    BoundedObjects objects = boundObjects<T>(tree.geometries, tree.report, monitor);
    tree.bounds = objects.bounds;
    tree.report.sceneRange = sceneRangeOf(tree.bounds);
    requireReferenceRoom(objects.all.references.size());

    monitor.beginPhase("split", 0.55 * whole);
    const std::size_t objectCount = objects.all.references.size();
    const ClipReferences clip = clipperFor(tree.geometries);
    const BuildOptions effective = optionsFor(tree);
    const TreeBuilder builder(effective, depthLimitFor(options, objectCount), clip, monitor);
    TreePieces pieces =
        builder.build(std::move(objects.all), tree.bounds, referenceBudget(options, objectCount));

    const Vec3f center = centerOfWideTree(tree.bounds);
    const MakeLeafPacker makePacker = [&] {
      return std::make_unique<FacePacker<T>>(tree.geometries, center);
    };
    const LeafCuts cuts = options.exactPlanes ? LeafCuts::AllPositions : LeafCuts::Bins;
    if (retracts) {
      monitor.beginPhase("retract", 1.0 - whole);
      retractSplits(pieces, tree.bounds, cuts, makePacker, monitor);
    }

    monitor.beginPhase("assemble", 0.01 * whole);
    const MemoryCharge binaryCharge(monitor.memory(), bytesOfBinaryTree(pieces));
    BinaryTree binary = joinPieces(pieces);
    tree.nodes = std::move(binary.nodes);
    tree.references = std::move(binary.references);
    tree.report.referenceCount = tree.references.size();

    monitor.beginPhase("widen", 0.39 * whole);
    WideTree wide = widenTree(std::move(pieces), tree.bounds, cuts, makePacker, monitor.memory(),
                              [&](double part) { monitor.advance(part); });
    wide.commonMask = commonMaskOf(tree.geometries);
    tree.wide = std::make_shared<const WideTree>(std::move(wide));
    monitor.finish();
  };
  // An arena of its own keeps the caller's tasks out of the build, and the build out of them.
  tbb::task_arena arena(threadCountFor(options));
  arena.execute(build);
  return tree;
}

template double intersectionCostOf(const TreeData<float>&) noexcept;
template double intersectionCostOf(const TreeData<double>&) noexcept;
template TreeData<float> buildTreeData<float>(std::vector<GeometryEntry<float>>,
                                              const BuildOptions&, const BuildControl&);
template TreeData<double> buildTreeData<double>(std::vector<GeometryEntry<double>>,
                                                const BuildOptions&, const BuildControl&);

}  // namespace planetree::detail
