#pragma once

#include "bench/rivals/engine.hpp"
#include "bench/support/answers.hpp"
#include "bench/support/ray_kinds.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// No engine is timed before its answers were checked: a fast wrong answer is worth nothing.
namespace planetree::bench {

/// Room for the answers to a set of rays.
[[nodiscard]] Answers roomForAnswers(const RaySet& set);

/// Has a structure answer a set of rays on `threadCount` threads, into answers with room for them:
/// what is timed, and what is checked before.
void takeAnswers(const Structure& structure, const RaySet& set, unsigned threadCount,
                 Answers& answers);

/// How the answers of two differ, each ray counted once, by the first that applies.
struct Disagreement {
  std::size_t rayCount = 0;
  std::size_t missed = 0;         ///< a hit of the reference's is missed
  std::size_t invented = 0;       ///< a hit where the reference has none
  std::size_t otherDistance = 0;  ///< t differs by more than the tolerance
  /// The same t, but another primitive or geometry: the usual thing on an edge, where two faces
  /// tie, and with doubled faces. Never a reason to fail.
  std::size_t otherId = 0;
  std::size_t bitsDiffer = 0;  ///< of all rays those whose t, u, v or ids are not the same bits

  /// Of all rays, those with a wrong answer.
  [[nodiscard]] std::size_t wrong() const noexcept { return missed + invented + otherDistance; }
};

/// Distances agree if they differ by no more than this times the larger of t and the diagonal of
/// the scene. Float coordinates are known to 2^-24 of their size, and a triangle that is met at a
/// small angle stretches that; hits of another surface are much farther off.
inline constexpr double kDistanceTolerance = 1e-4;

/// The part of the rays that may be answered differently by engines that are not exact: at edges,
/// between surfaces that nearly touch, and where they leak.
inline constexpr double kAllowedWrong = 0.005;

[[nodiscard]] Disagreement compareAnswers(const Answers& answers, const Answers& reference,
                                          double diagonal);

/// The answers of testing every object with every ray, on `threadCount` threads. Only meshes can be
/// asked in double.
[[nodiscard]] Answers bruteForceAnswers(const SceneObjects& objects, const RaySet& set,
                                        unsigned threadCount,
                                        Precision precision = Precision::Float);

/// At most `count` rays of the set, chosen at random with a fixed seed, in their order.
[[nodiscard]] std::vector<std::size_t> sampleOf(const RaySet& set, std::size_t count);

/// The rays, or the answers, at these places.
[[nodiscard]] RaySet selected(const RaySet& set, const std::vector<std::size_t>& places);
[[nodiscard]] Answers selected(const Answers& answers, const std::vector<std::size_t>& places);

/// An engine's answers beside the others'.
struct CheckedAnswers {
  std::string engine;
  std::string mode;
  bool isExact = false;
  Precision precision = Precision::Float;
  Answers answers;
};

/// One comparison of the check.
struct CheckedPair {
  std::string engine;
  std::string mode;
  std::string reference;  ///< "brute force", or the engine compared with
  Disagreement disagreement;
  bool isAcceptable = true;
};

/// Compares all engines with brute force on a sample of at most `sampleSize` rays, and with the
/// first engine on all rays. An exact engine must have the bits of brute force in its own
/// precision; the others may be wrong about `kAllowedWrong` of the rays, and one ray of a small
/// set, and so may exact ones of different precision about each other's.
[[nodiscard]] std::vector<CheckedPair> checkAnswers(const SceneObjects& objects, const RaySet& set,
                                                    const std::vector<CheckedAnswers>& all,
                                                    double diagonal, std::size_t sampleSize,
                                                    unsigned threadCount);

}  // namespace planetree::bench
