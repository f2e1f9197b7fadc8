#pragma once

#include <planetree/kd_tree.hpp>

#include "traversal/search_wide.hpp"

#include "support/brute_force_hits.hpp"
#include "support/promise.hpp"
#include "support/within_limits.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

/// What holds of every query, whatever the tree and the ray are. Within the limits all ways to ask
/// have the bits of brute force; beyond them no hit is invented.
namespace planetree::fuzz {

template <class T>
[[nodiscard]] bool haveSameBits(const Hit<T>& a, const Hit<T>& b) noexcept {
  static_assert(sizeof(Hit<T>) == 6 * sizeof(T) + 4 * sizeof(std::uint32_t), "no padding");
  return std::memcmp(&a, &b, sizeof(Hit<T>)) == 0;
}

template <class T>
[[nodiscard]] std::string describe(const Ray<T>& ray) {
  std::ostringstream text;
  text << std::hexfloat << "ray (" << ray.origin.x << ", " << ray.origin.y << ", " << ray.origin.z
       << ") + t (" << ray.direction.x << ", " << ray.direction.y << ", " << ray.direction.z
       << "), t in [" << ray.tMin << ", " << ray.tMax << "]\n";
  return text.str();
}

template <class T>
[[nodiscard]] std::string describe(const Hit<T>& hit) {
  std::ostringstream text;
  text << std::hexfloat << "t " << hit.t << " u " << hit.u << " v " << hit.v << " normal ("
       << hit.normal.x << ", " << hit.normal.y << ", " << hit.normal.z << ") geometry " << std::dec
       << hit.geometry << " primitive " << hit.primitive << " part " << hit.part << '\n';
  return text.str();
}

/// All ways to ask one ray, compared with the hits that testing every object one by one gives.
template <Object O>
class RayCheck {
 public:
  using T = ScalarOf<O>;

  RayCheck(const KdTree<O>& tree, const Ray<T>& ray, const QueryOptions& options)
      : tree_(tree),
        ray_(ray),
        options_(options),
        isExact_(isWithinLimits(ray, tree.bounds())),
        expected_(test::bruteForceHits(tree, ray, options)) {}

  void run() const {
    checkNearest();
    checkAny();
    checkAll();
    checkOneByOne();
  }

 private:
  void checkNearest() const {
    StepCounts steps;
    requireFirst(tree_.findIntersection(ray_, options_), "the nearest hit");
    requireFirst(tree_.findIntersection(ray_, steps, options_), "the nearest hit, binary form");
    requireFirst(tree_.explainIntersection(ray_, options_).hit, "the nearest hit, explained");
    if (options_.cullsBackFaces || options_.crossings || options_.skip != PrimitiveId{})
      return;
    detail::Request<T> request(tree_.view(), ray_, ray_.tMin, ray_.tMax);
    request.mask = options_.mask;
    for (const detail::Kernels& kernels : detail::supportedKernels()) {
      Hit<T> hit;
      const auto found = detail::searchWide<detail::NearestHit>(request, hit, kernels);
      if (found)
        requireFirst(*found ? std::optional(hit) : std::nullopt, kernels.name);
      const auto foundAny = detail::searchWide<detail::AnyHit>(request, hit, kernels);
      if (foundAny)
        requireAny(*foundAny, kernels.name);
    }
  }

  void checkAny() const {
    StepCounts steps;
    requireAny(tree_.isOccluded(ray_, options_), "any hit");
    requireAny(tree_.isOccluded(ray_, steps, options_), "any hit, binary form");
  }

  void checkAll() const {
    for (const std::size_t room : {expected_.size() + 1, std::size_t{2}}) {
      std::vector<Hit<T>> hits(room);
      const FoundHits found = tree_.findIntersections(ray_, hits, options_);
      require(found.count <= room, "no more hits than there is room for");
      hits.resize(found.count);
      requireBeginning(hits, "all hits");
      const std::size_t present = std::min(room, expected_.size());
      if (isExact_) {
        requireHere(hits.size() == present, "all hits are found", {});
        requireHere(found.hasMore == (expected_.size() > room), "it is known if there are more",
                    {});
      }
    }
  }

  /// From each hit to the next one.
  void checkOneByOne() const {
    std::vector<Hit<T>> hits;
    for (auto hit = tree_.findIntersection(ray_, options_); hit && hits.size() <= expected_.size();
         hit = tree_.findNextIntersection(ray_, *hit, options_))
      hits.push_back(*hit);
    requireBeginning(hits, "hits one by one");
    if (isExact_)
      requireHere(hits.size() == expected_.size(), "each hit leads to the next one", {});
  }

  void requireBeginning(const std::vector<Hit<T>>& hits, std::string_view what) const {
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const bool holds =
          isExact_ ? i < expected_.size() && haveSameBits(hits[i], expected_[i]) : isReal(hits[i]);
      requireHere(holds, what, hits[i]);
      requireHere(i == 0 || isBefore(hits[i - 1], hits[i]), "hits are sorted", hits[i]);
    }
  }

  void requireFirst(const std::optional<Hit<T>>& hit, std::string_view what) const {
    if (isExact_)
      requireHere(hit.has_value() == !expected_.empty(), what, hit.value_or(Hit<T>{}));
    if (hit)
      requireHere(isExact_ ? haveSameBits(*hit, expected_.front()) : isReal(*hit), what, *hit);
  }

  void requireAny(bool isHit, std::string_view what) const {
    requireHere(isHit ? !expected_.empty() : !isExact_ || expected_.empty(), what, {});
  }

  [[nodiscard]] bool isReal(const Hit<T>& hit) const {
    return std::any_of(expected_.begin(), expected_.end(),
                       [&](const Hit<T>& one) { return haveSameBits(hit, one); });
  }

  void requireHere(bool holds, std::string_view what, const Hit<T>& hit) const {
    require(holds, what, [&] {
      std::string text =
          describe(ray_) + (isExact_ ? "within" : "beyond") + " the limits\nfound " + describe(hit);
      for (const Hit<T>& one : expected_)
        text += "expected " + describe(one);
      return text;
    });
  }

  const KdTree<O>& tree_;
  const Ray<T>& ray_;
  const QueryOptions& options_;
  bool isExact_;
  std::vector<Hit<T>> expected_;
};

template <Object O>
void checkRay(const KdTree<O>& tree, const Ray<ScalarOf<O>>& ray,
              const QueryOptions& options = {}) {
  RayCheck<O>(tree, ray, options).run();
}

/// Batches answer what each ray says alone, within the limits or beyond them.
template <Object O>
void checkBatch(const KdTree<O>& tree, const std::vector<Ray<ScalarOf<O>>>& rays,
                const QueryOptions& query = {}) {
  using T = ScalarOf<O>;
  BatchOptions options;
  options.query = query;
  options.threadCount = 1;
  std::vector<Hit<T>> hits(rays.size());
  std::vector<std::uint8_t> flags(rays.size());
  tree.findIntersections(std::span(rays), std::span(hits), options);
  tree.areOccluded(std::span(rays), std::span(flags), options);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit<T> alone = tree.findIntersection(rays[i], query).value_or(Hit<T>{});
    const auto details = [&] {
      return "number " + std::to_string(i) + " of " + std::to_string(rays.size()) + ": " +
             describe(rays[i]) + "alone " + describe(alone) + "found " + describe(hits[i]);
    };
    require(haveSameBits(hits[i], alone), "a batch has the bits of single rays", details);
    require((flags[i] != 0) == tree.isOccluded(rays[i], query),
            "a batch has the flags of single rays", details);
  }
}

}  // namespace planetree::fuzz
