#include "bench/support/answer_check.hpp"

#include "bench/support/parallel_for.hpp"
#include "bench/support/random.hpp"

#include <planetree/geometry/sheared_ray.hpp>
#include <planetree/mesh/triangle_intersection.hpp>
#include <planetree/object.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace planetree::bench {

namespace {

constexpr std::uint64_t kSampleSeed = 20'260'131u;
constexpr std::size_t kRaysOfAPiece = 2048;

bool isHit(const Hitf& hit) {
  return hit.primitive != kNoId;
}

bool sameBits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// Of the normal not even engines that are exact say the same: it may have any length.
bool sameBits(const Hitf& a, const Hitf& b) {
  return sameBits(a.t, b.t) && sameBits(a.u, b.u) && sameBits(a.v, b.v) &&
         a.geometry == b.geometry && a.primitive == b.primitive;
}

bool sameDistance(float a, float b, double diagonal) {
  const double larger = std::max({static_cast<double>(a), static_cast<double>(b), diagonal});
  // A NaN is no distance: it must not compare as close.
  return std::fabs(static_cast<double>(a) - static_cast<double>(b)) <= kDistanceTolerance * larger;
}

void countHits(const Answers& answers, const Answers& reference, double diagonal,
               Disagreement& found) {
  for (std::size_t i = 0; i < reference.hits.size(); ++i) {
    const Hitf& hit = answers.hits[i];
    const Hitf& expected = reference.hits[i];
    if (!sameBits(hit, expected))
      ++found.bitsDiffer;
    if (isHit(hit) != isHit(expected))
      ++(isHit(expected) ? found.missed : found.invented);
    else if (isHit(expected) && !sameDistance(hit.t, expected.t, diagonal))
      ++found.otherDistance;
    else if (hit.primitive != expected.primitive || hit.geometry != expected.geometry)
      ++found.otherId;
  }
}

void countOcclusions(const Answers& answers, const Answers& reference, Disagreement& found) {
  for (std::size_t i = 0; i < reference.occluded.size(); ++i) {
    if (answers.occluded[i] == reference.occluded[i])
      continue;
    ++found.bitsDiffer;
    ++(reference.occluded[i] != 0 ? found.missed : found.invented);
  }
}

template <class T>
Hit<T> bruteForceHit(const TriangleMeshView<T>& mesh, const Ray<T>& ray) {
  const ShearedRay<T> sheared(ray);
  Hit<T> nearest;
  for (std::size_t face = 0; face < mesh.size(); ++face) {
    if (!mesh[face].isUsable())
      continue;
    const auto [a, b, c] = mesh.corners(face);
    const auto found = intersectTriangle(sheared, a, b, c, ray.tMin, ray.tMax);
    if (!found)
      continue;
    const Hit<T> hit = {.t = found->t,
                        .u = found->u,
                        .v = found->v,
                        .normal = triangleNormal(a, b, c, ray.direction),
                        .geometry = 0,
                        .primitive = static_cast<std::uint32_t>(face)};
    if (isBefore(hit, nearest))
      nearest = hit;
  }
  return nearest;
}

template <class S>
Hitf bruteForceHit(std::span<const S> shapes, const Rayf& ray) {
  Hitf nearest;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    auto hit = objectIntersect(shapes[i], ray, ray.tMin, ray.tMax);
    if (!hit)
      continue;
    hit->geometry = 0;
    hit->primitive = static_cast<std::uint32_t>(i);
    if (isBefore(*hit, nearest))
      nearest = *hit;
  }
  return nearest;
}

template <class T, class Input>
std::vector<Hitf> bruteForceHits(const Input& input, const std::vector<Rayf>& rays,
                                 unsigned threadCount) {
  std::vector<Hitf> hits(rays.size());
  parallelFor(hits.size(), 1, threadCount, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      hits[i] = inFloat(bruteForceHit(input, rayIn<T>(rays[i])));
  });
  return hits;
}

bool isAcceptable(const Disagreement& found, bool mustBeExact) {
  if (mustBeExact)
    return found.bitsDiffer == 0;
  const double allowed = std::max(1.0, kAllowedWrong * static_cast<double>(found.rayCount));
  return static_cast<double>(found.wrong()) <= allowed;
}

}  // namespace

Answers roomForAnswers(const RaySet& set) {
  Answers answers;
  if (asksForAnyHit(set.kind))
    answers.occluded.resize(set.rays.size());
  else
    answers.hits.resize(set.rays.size());
  return answers;
}

void takeAnswers(const Structure& structure, const RaySet& set, unsigned threadCount,
                 Answers& answers) {
  const std::span<const Rayf> rays = set.rays;
  const bool anyHit = asksForAnyHit(set.kind);
  parallelFor(rays.size(), kRaysOfAPiece, threadCount, [&](std::size_t begin, std::size_t end) {
    const auto piece = rays.subspan(begin, end - begin);
    if (anyHit)
      structure.findOcclusions(piece, std::span(answers.occluded).subspan(begin, end - begin));
    else
      structure.findIntersections(piece, std::span(answers.hits).subspan(begin, end - begin));
  });
}

Disagreement compareAnswers(const Answers& answers, const Answers& reference, double diagonal) {
  Disagreement found;
  found.rayCount = reference.hits.size() + reference.occluded.size();
  countHits(answers, reference, diagonal, found);
  countOcclusions(answers, reference, found);
  return found;
}

Answers bruteForceAnswers(const SceneObjects& objects, const RaySet& set, unsigned threadCount,
                          Precision precision) {
  std::vector<Hitf> hits =
      precision == Precision::Float
          ? objects.visit([&](const auto& input) {
              return bruteForceHits<float>(input, set.rays, threadCount);
            })
          : bruteForceHits<double>(meshIn<double>(*objects.mesh()).view(), set.rays, threadCount);
  Answers answers;
  if (!asksForAnyHit(set.kind)) {
    answers.hits = std::move(hits);
    return answers;
  }
  for (const Hitf& hit : hits)
    answers.occluded.push_back(isHit(hit) ? 1 : 0);
  return answers;
}

std::vector<std::size_t> sampleOf(const RaySet& set, std::size_t count) {
  Random random(kSampleSeed + static_cast<std::uint64_t>(set.kind));
  std::vector<std::size_t> places;
  // Knuth, "The art of computer programming", volume 2, algorithm S: each sample is as likely.
  for (std::size_t i = 0; i < set.rays.size() && places.size() < count; ++i) {
    const auto raysLeft = static_cast<double>(set.rays.size() - i);
    if (random.unit() * raysLeft < static_cast<double>(count - places.size()))
      places.push_back(i);
  }
  return places;
}

RaySet selected(const RaySet& set, const std::vector<std::size_t>& places) {
  RaySet chosen{.kind = set.kind, .rays = {}};
  for (const std::size_t place : places)
    chosen.rays.push_back(set.rays[place]);
  return chosen;
}

Answers selected(const Answers& answers, const std::vector<std::size_t>& places) {
  Answers chosen;
  for (const std::size_t place : places) {
    if (!answers.hits.empty())
      chosen.hits.push_back(answers.hits[place]);
    if (!answers.occluded.empty())
      chosen.occluded.push_back(answers.occluded[place]);
  }
  return chosen;
}

std::vector<CheckedPair> checkAnswers(const SceneObjects& objects, const RaySet& set,
                                      const std::vector<CheckedAnswers>& all, double diagonal,
                                      std::size_t sampleSize, unsigned threadCount) {
  const std::vector<std::size_t> places = sampleOf(set, sampleSize);
  const RaySet sample = selected(set, places);
  std::map<Precision, Answers> truths;
  std::vector<CheckedPair> pairs;
  for (const CheckedAnswers& checked : all) {
    const auto [truth, isNew] = truths.try_emplace(checked.precision);
    if (isNew)
      truth->second = bruteForceAnswers(objects, sample, threadCount, checked.precision);
    const Disagreement found =
        compareAnswers(selected(checked.answers, places), truth->second, diagonal);
    pairs.push_back(
        {checked.engine, checked.mode, "brute force", found, isAcceptable(found, checked.isExact)});
  }
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Disagreement found = compareAnswers(all[i].answers, all[0].answers, diagonal);
    const bool mustBeExact =
        all[i].isExact && all[0].isExact && all[i].precision == all[0].precision;
    pairs.push_back({all[i].engine, all[i].mode, all[0].engine + " " + all[0].mode, found,
                     isAcceptable(found, mustBeExact)});
  }
  return pairs;
}

}  // namespace planetree::bench
