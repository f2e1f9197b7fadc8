#pragma once

#include <planetree/traversal/walk.hpp>

#include "traversal/hit_choices.hpp"
#include "traversal/traverse.hpp"

#include <span>
#include <vector>

namespace planetree::detail {

/// The observer that writes down all that the loop does.
template <class T>
class WalkRecorder {
 public:
  static constexpr bool kMayThrow = true;

  /// Of a search from the root, with the choices that it makes, or null. All must outlive the
  /// recorder.
  WalkRecorder(std::span<const Node> nodes, Walk<T>& walk, const HitChoices<T>* choices)
      : nodes_(nodes), walk_(walk), choices_(choices) {}

  void visitSplit(const Node& node, const Interval<T>& part, const ChildOrder<T>& order) {
    const NodeVisit<T> visit = arriveAt(node, part);
    const SplitNode& split = node.split();
    SplitStep<T> step{.visit = visit,
                      .axis = split.axis(),
                      .position = split.position(),
                      .leftIsNear = order.near == &split.left(),
                      .nearPart = {},
                      .farPart = {}};
    if (order.visitsNear)
      step.nearPart = order.nearPart;
    if (order.visitsFar)
      step.farPart = order.farPart;
    if (order.visitsNear && order.visitsFar)
      waiting_.push_back({order.far, visitOf(*order.far, visit.level + 1, order.farPart)});
    walk_.steps.push_back(step);
    ++walk_.counts.splitNodes;
  }

  void visitLeaf(const Node& node, const Interval<T>& part) {
    walk_.steps.push_back(LeafStep<T>{
        .visit = arriveAt(node, part), .objectCount = node.leaf().count(), .tests = {}});
    ++walk_.counts.leafNodes;
  }

  void testObjects(const Request<T>& request, const ShearedRay<T>& ray,
                   const GeometryEntry<T>& entry, const LeafRun& run, std::uint32_t testedCount) {
    LeafStep<T>& leaf = std::get<LeafStep<T>>(walk_.steps.back());
    for (std::size_t i = 0; i < testedCount; ++i) {
      const LeafRun object{run.references.subspan(i, 1), run.firstObject, run.geometry};
      leaf.tests.push_back(testAlone(request, ray, entry, object));
    }
    walk_.counts.objects += testedCount;
  }

  void leaveOut(const Node&, const Interval<T>&) {
    walk_.steps.push_back(LeftOutStep<T>{waiting_.back().visit});
    waiting_.pop_back();
  }

  void stopAtHit() {
    for (; !waiting_.empty(); waiting_.pop_back())
      walk_.steps.push_back(LeftOutStep<T>{waiting_.back().visit});
  }

 private:
  struct WaitingChild {
    const Node* node;
    NodeVisit<T> visit;
  };

  [[nodiscard]] NodeVisit<T> visitOf(const Node& node, std::uint32_t level,
                                     const Interval<T>& part) const noexcept {
    return {static_cast<std::uint32_t>(&node - nodes_.data()), level, part};
  }

  /// The loop comes to the child that it chose last, or to the one that has waited for the shortest
  /// time.
  [[nodiscard]] NodeVisit<T> arriveAt(const Node& node, const Interval<T>& part) {
    ++level_;
    if (!waiting_.empty() && waiting_.back().node == &node) {
      level_ = waiting_.back().visit.level;
      waiting_.pop_back();
    }
    return visitOf(node, level_, part);
  }

  /// The first hit of one object that counts, whatever else was hit before.
  [[nodiscard]] ObjectTest<T> testAlone(const Request<T>& request, const ShearedRay<T>& ray,
                                        const GeometryEntry<T>& entry, const LeafRun& object) {
    const auto [tMin, tMax] = request.interval;
    ObjectTest<T> test{.geometry = object.geometry,
                       .primitive = object.references.front() - object.firstObject,
                       .hit = {},
                       .isAccepted = false};
    Hit<T> hit;
    const IntersectionTable<T>& table = *entry.intersecting;
    bool found = false;
    if (choices_ != nullptr) {
      NearestSink<T> sink(*choices_, tMax, hit);
      found = table.offerHits(entry.range, object, ray, tMin, sink).found;
    } else {
      found = table.findNearest(entry.range, object, ray, tMin, tMax, hit).found;
    }
    if (found) {
      test.hit = hit;
      test.isAccepted = !walk_.hit || isBefore(hit, *walk_.hit);
      if (test.isAccepted)
        walk_.hit = hit;
    }
    return test;
  }

  std::span<const Node> nodes_;
  Walk<T>& walk_;
  const HitChoices<T>* choices_;
  std::vector<WaitingChild> waiting_;  ///< as on the stack of the loop
  std::uint32_t level_ = 0;            ///< of the node that the loop came to last
};

}  // namespace planetree::detail
