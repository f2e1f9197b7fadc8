#pragma once

#include <planetree/kd_tree.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include "exact/exact_judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// Compares the answers of all kinds of queries with what the exact judge expects.
namespace planetree::test {

/// All that the library says of one ray.
template <class T>
struct Answers {
  std::optional<Hit<T>> nearest;
  bool any = false;
  std::vector<Hit<T>> all;
  std::vector<Hit<T>> crossings;
  Hit<T> nearestOfBatch;
  bool anyOfBatch = false;
};

struct Verdicts {
  std::uint64_t rays = 0;
  // Pairs of a ray and a triangle, by how they meet exactly.
  std::uint64_t hits = 0;
  std::uint64_t misses = 0;
  std::uint64_t touchings = 0;
  /// Patches that had to be hit, and such as could be hit or missed within the bound.
  std::uint64_t certainPatches = 0;
  std::uint64_t openPatches = 0;
  std::uint64_t hitsChecked = 0;
  /// The largest distance of a reported point from its triangle, in roundoffs of D, rounded up.
  int farthestInRoundoffs = 0;
  std::uint64_t wrongAnswers = 0;
  std::vector<std::string> firstFaults;

  Verdicts& operator+=(const Verdicts& other) {
    rays += other.rays;
    hits += other.hits;
    misses += other.misses;
    touchings += other.touchings;
    certainPatches += other.certainPatches;
    openPatches += other.openPatches;
    hitsChecked += other.hitsChecked;
    farthestInRoundoffs = std::max(farthestInRoundoffs, other.farthestInRoundoffs);
    wrongAnswers += other.wrongAnswers;
    firstFaults.insert(firstFaults.end(), other.firstFaults.begin(), other.firstFaults.end());
    return *this;
  }
};

/// The documented bound, in roundoffs: docs/numerics.md, section 1.
template <class T>
inline constexpr double kBoundInRoundoffs = sizeof(T) == sizeof(float) ? 8.0 : 25.0;

template <class T>
Rayd exactly(const Ray<T>& ray) {
  return {static_cast<Vec3d>(ray.origin), static_cast<Vec3d>(ray.direction),
          static_cast<double>(ray.tMin), static_cast<double>(ray.tMax)};
}

/// The faces of a mesh for the judge; such as the tree skips have corners that are no numbers.
template <class T>
std::vector<Corners> cornersOf(const TriangleMesh<T>& mesh) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Corners> faces;
  for (const FaceIndices& face : mesh.faces) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = face[i] < mesh.positions.size() ? static_cast<Vec3d>(mesh.positions[face[i]])
                                                   : Vec3d{kNan, kNan, kNan};
    }
    faces.push_back(corners);
  }
  return faces;
}

/// Judges the answers for one tree.
template <class T>
class AnswerJudge {
 public:
  AnswerJudge(const TriangleMesh<T>& mesh, const Box3& bounds)
      : judge_(cornersOf(mesh), bounds, kBoundInRoundoffs<T>,
               static_cast<double>(std::numeric_limits<T>::epsilon()) / 2.0) {}

  void judge(const Ray<T>& ray, const Answers<T>& answers, Verdicts& verdicts) {
    ray_ = exactly(ray);
    expectation_ = judge_.expect(ray_);
    fault_.clear();
    ++verdicts.rays;
    verdicts.hits += expectation_.hitCount;
    verdicts.misses += expectation_.missCount;
    verdicts.touchings += expectation_.touchingCount;
    for (const Patch& patch : expectation_.patches) {
      verdicts.certainPatches += mustBeHit(patch) ? 1u : 0u;
      verdicts.openPatches += isOpen(patch) ? 1u : 0u;
    }

    checkNearest(answers.nearest, verdicts);
    checkAny(answers.any);
    checkAll(answers.all, verdicts);
    checkCrossings(answers.crossings);
    const std::optional<Hit<T>> ofBatch = answers.nearestOfBatch.primitive == kNoId
                                              ? std::nullopt
                                              : std::optional(answers.nearestOfBatch);
    if (ofBatch != answers.nearest || answers.anyOfBatch != answers.any)
      complain("the batch and the single ray differ");
    if (fault_.empty())
      return;
    ++verdicts.wrongAnswers;
    if (verdicts.firstFaults.size() < 3)
      verdicts.firstFaults.push_back(fault_ + describe(ray));
  }

 private:
  [[nodiscard]] bool mustBeHit(const Patch& patch) const {
    return patch.mustBeHit(ray_.tMin, ray_.tMax);
  }

  /// Whether its triangles may be hit or missed: the outline is near, or an end of the interval is.
  [[nodiscard]] bool isOpen(const Patch& patch) const {
    const bool isInReach = patch.tUpper >= ray_.tMin && patch.tLower <= ray_.tMax;
    return isInReach && !(patch.isCertain && patch.isWithin(ray_.tMin, ray_.tMax));
  }

  void complain(const std::string& fault) { fault_ += fault + "; "; }

  void checkHit(const Hit<T>& hit, Verdicts& verdicts) {
    const auto t = static_cast<double>(hit.t);
    ++verdicts.hitsChecked;
    if (!(t >= ray_.tMin && t <= ray_.tMax))
      complain("a hit outside of the interval");
    const int bound = static_cast<int>(judge_.boundInRoundoffs());
    // Nearly all points lie closer than the farthest so far, which one look tells.
    const int seen = verdicts.farthestInRoundoffs;
    if (judge_.isWithin(ray_, t, hit.primitive, seen))
      return;
    verdicts.farthestInRoundoffs = judge_.distanceInRoundoffs(ray_, t, hit.primitive, bound + 1);
    if (verdicts.farthestInRoundoffs > bound) {
      verdicts.farthestInRoundoffs = seen;
      complain("a false hit: the point is too far from face " + std::to_string(hit.primitive));
    }
  }

  void checkNearest(const std::optional<Hit<T>>& nearest, Verdicts& verdicts) {
    if (nearest)
      checkHit(*nearest, verdicts);
    for (const Patch& patch : expectation_.patches) {
      if (mustBeHit(patch) && !(nearest && static_cast<double>(nearest->t) <= patch.tUpper))
        complain("the nearest hit misses face " + std::to_string(patch.faces.front()));
    }
  }

  void checkAny(bool any) {
    bool must = false;
    bool may = false;
    for (const Patch& patch : expectation_.patches) {
      must = must || mustBeHit(patch);
      may = may || (patch.tUpper >= ray_.tMin && patch.tLower <= ray_.tMax);
    }
    if (any ? !may : must)
      complain(any ? "something occludes the ray, but nothing can" : "nothing occludes the ray");
  }

  void checkAll(const std::vector<Hit<T>>& hits, Verdicts& verdicts) {
    std::vector<std::uint32_t> faces;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      checkHit(hits[i], verdicts);
      faces.push_back(hits[i].primitive);
      if (i > 0 && !isBefore(hits[i - 1], hits[i]))
        complain("all hits are not in order");
      const Patch* patch = expectation_.patchOf(hits[i].primitive);
      const auto t = static_cast<double>(hits[i].t);
      if (!patch || !(t >= patch->tLower && t <= patch->tUpper))
        complain("face " + std::to_string(hits[i].primitive) + " is hit where it cannot be");
    }
    std::sort(faces.begin(), faces.end());
    if (std::adjacent_find(faces.begin(), faces.end()) != faces.end())
      complain("a face is hit twice");
    for (const Patch& patch : expectation_.patches) {
      if (mustBeHit(patch) && countIn(patch, hits).first == 0)
        complain("all hits miss face " + std::to_string(patch.faces.front()));
    }
  }

  void checkCrossings(const std::vector<Hit<T>>& hits) {
    for (const Patch& patch : expectation_.patches) {
      if (patch.isCertain && patch.isWithin(ray_.tMin, ray_.tMax) &&
          countIn(patch, hits).second != patch.winding)
        complain("wrong crossings around face " + std::to_string(patch.faces.front()));
    }
    for (const Hit<T>& hit : hits) {
      if (!expectation_.patchOf(hit.primitive))
        complain("a crossing of face " + std::to_string(hit.primitive) + ", which is not near");
    }
  }

  /// How many of the hits are on the patch, and how many more from behind than from the front.
  [[nodiscard]] std::pair<int, int> countIn(const Patch& patch,
                                            const std::vector<Hit<T>>& hits) const {
    int count = 0;
    int sum = 0;
    for (const Hit<T>& hit : hits) {
      if (std::find(patch.faces.begin(), patch.faces.end(), hit.primitive) == patch.faces.end())
        continue;
      ++count;
      // As a caller finds out.
      sum += dot(hit.normal, static_cast<Vec3<T>>(ray_.direction)) > T(0) ? 1 : -1;
    }
    return {count, sum};
  }

  static std::string describe(const Ray<T>& ray) {
    std::ostringstream text;
    text << std::hexfloat << "ray " << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z
         << ", " << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z << ", "
         << ray.tMin << ' ' << ray.tMax;
    return text.str();
  }

  ExactJudge judge_;
  Rayd ray_;
  Expectation expectation_;
  std::string fault_;
};

/// Asks every kind of query about every ray.
template <class T>
std::vector<Answers<T>> ask(const KdTree<Face<T>>& tree, const std::vector<Ray<T>>& rays) {
  std::vector<Hit<T>> hits(rays.size());
  std::vector<std::uint8_t> flags(rays.size());
  tree.findIntersections(rays, hits);
  tree.areOccluded(rays, flags);
  const auto findAll = [&](const Ray<T>& ray, const QueryOptions& options) {
    std::vector<Hit<T>> all(8);
    while (true) {
      const FoundHits found = tree.findIntersections(ray, all, options);
      all.resize(found.hasMore ? all.size() * 2 : found.count);
      if (!found.hasMore)
        return all;
    }
  };
  std::vector<Answers<T>> answers;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    answers.push_back({tree.findIntersection(rays[i]), tree.isOccluded(rays[i]),
                       findAll(rays[i], {}), findAll(rays[i], {.crossings = true}), hits[i],
                       flags[i] != 0});
  }
  return answers;
}

}  // namespace planetree::test
