#pragma once

#include <planetree/kd_tree.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Asks a tree of a closed mesh every kind of query, and counts answers that only a leak can give.
namespace planetree::test {

struct LeakCounts {
  std::uint64_t innerRays = 0;
  // Rays from inside that found nothing, by the kind of query.
  std::uint64_t nearest = 0;
  std::uint64_t any = 0;
  std::uint64_t all = 0;
  std::uint64_t nearestOfBatch = 0;
  std::uint64_t anyOfBatch = 0;
  /// Rays from inside that do not leave the mesh once more than they enter it.
  std::uint64_t innerCrossings = 0;

  std::uint64_t outerRays = 0;
  /// Rays from outside that do not enter the mesh as often as they leave it.
  std::uint64_t outerCrossings = 0;
  /// Rays, from anywhere, to which two kinds of queries give different answers.
  std::uint64_t contradictions = 0;

  [[nodiscard]] std::uint64_t leaks() const noexcept {
    return nearest + any + all + nearestOfBatch + anyOfBatch + innerCrossings + outerCrossings +
           contradictions;
  }
  LeakCounts& operator+=(const LeakCounts& other) noexcept {
    innerRays += other.innerRays;
    nearest += other.nearest;
    any += other.any;
    all += other.all;
    nearestOfBatch += other.nearestOfBatch;
    anyOfBatch += other.anyOfBatch;
    innerCrossings += other.innerCrossings;
    outerRays += other.outerRays;
    outerCrossings += other.outerCrossings;
    contradictions += other.contradictions;
    return *this;
  }
};

/// Asks one tree; keeps the storage for a block of rays, and is for one thread.
template <class T>
class LeakCounter {
 public:
  explicit LeakCounter(const KdTree<Face<T>>& tree) : tree_(tree) {}

  /// Rays from strictly inside.
  void askInside(std::span<const Ray<T>> rays, LeakCounts& counts) {
    askBatch(rays);
    counts.innerRays += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto nearest = tree_.findIntersection(rays[i]);
      const bool any = tree_.isOccluded(rays[i]);
      const std::size_t all = findAll(rays[i], {});
      counts.nearest += nearest ? 0u : 1u;
      counts.any += any ? 0u : 1u;
      counts.all += all > 0 ? 0u : 1u;
      counts.nearestOfBatch += hits_[i].primitive != kNoId ? 0u : 1u;
      counts.anyOfBatch += flags_[i] != 0 ? 0u : 1u;
      const bool agree = nearest && *nearest == hits_[i] && all > 0 && *nearest == all_.front();
      counts.contradictions += agree || !nearest ? 0u : 1u;
      counts.innerCrossings += sumOfSides(rays[i]) == 1 ? 0u : 1u;
    }
  }

  /// Rays from outside, which may hit or miss.
  void askOutside(std::span<const Ray<T>> rays, LeakCounts& counts) {
    askBatch(rays);
    counts.outerRays += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto nearest = tree_.findIntersection(rays[i]);
      const std::size_t all = findAll(rays[i], {});
      const bool agree = nearest ? all > 0 && *nearest == all_.front() && *nearest == hits_[i]
                                 : all == 0 && hits_[i] == Hit<T>{};
      const bool sameAny = tree_.isOccluded(rays[i]) == nearest.has_value() &&
                           (flags_[i] != 0) == nearest.has_value();
      counts.contradictions += agree && sameAny ? 0u : 1u;
      counts.outerCrossings += sumOfSides(rays[i]) == 0 ? 0u : 1u;
    }
  }

 private:
  void askBatch(std::span<const Ray<T>> rays) {
    hits_.resize(rays.size());
    flags_.resize(rays.size());
    tree_.findIntersections(rays, hits_, {.threadCount = 1});
    tree_.areOccluded(rays, flags_, {.threadCount = 1});
  }

  /// All hits, in `all_`.
  std::size_t findAll(const Ray<T>& ray, const QueryOptions& options) {
    if (all_.size() < 16)
      all_.resize(16);
    std::size_t count = 0;
    while (true) {
      const FoundHits found = tree_.findIntersections(ray, all_, options);
      count = found.count;
      if (!found.hasMore)
        return count;
      all_.resize(all_.size() * 2);
    }
  }

  /// Crossings from behind less crossings from the front.
  int sumOfSides(const Ray<T>& ray) {
    const std::size_t count = findAll(ray, {.crossings = true});
    int sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      sum += dot(all_[i].normal, ray.direction) > T(0) ? 1 : -1;
    return sum;
  }

  const KdTree<Face<T>>& tree_;
  std::vector<Hit<T>> hits_;
  std::vector<std::uint8_t> flags_;
  std::vector<Hit<T>> all_;
};

}  // namespace planetree::test
