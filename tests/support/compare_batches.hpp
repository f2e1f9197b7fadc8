#pragma once

#include <planetree/batch/trace_batch.hpp>
#include <planetree/traversal/find_intersection.hpp>

#include "support/print_hit.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <sstream>
#include <string>
#include <vector>

/// Batches against the same rays one by one.
namespace planetree::test {

template <class T>
[[nodiscard]] bool hasSameBits(const Hit<T>& a, const Hit<T>& b) noexcept {
  static_assert(sizeof(Hit<T>) == 6 * sizeof(T) + 4 * sizeof(std::uint32_t), "no padding");
  return std::memcmp(&a, &b, sizeof(Hit<T>)) == 0;
}

template <class T>
[[nodiscard]] std::string describeRay(const Ray<T>& ray) {
  std::ostringstream text;
  text << std::hexfloat << "ray (" << ray.origin.x << ", " << ray.origin.y << ", " << ray.origin.z
       << ") + t (" << ray.direction.x << ", " << ray.direction.y << ", " << ray.direction.z
       << "), t in [" << ray.tMin << ", " << ray.tMax << "]";
  return text.str();
}

/// What each ray says when it is asked alone.
template <class T>
struct SingleAnswers {
  std::vector<Hit<T>> hits;
  std::vector<std::uint8_t> flags;
  std::size_t hitCount = 0;

  SingleAnswers(const TreeView<T>& tree, std::span<const Ray<T>> rays,
                const QueryOptions& query = {}) {
    for (const Ray<T>& ray : rays) {
      const auto hit = findIntersection(tree, ray, query);
      hits.push_back(hit.value_or(Hit<T>{}));
      flags.push_back(isOccluded(tree, ray, query) ? 1u : 0u);
      hitCount += hit ? 1u : 0u;
    }
  }
};

/// What no query answers: a batch must leave it alone where it has no business.
template <class T>
[[nodiscard]] Hit<T> untouchedHit() noexcept {
  return {.t = T(-77), .geometry = 77, .primitive = 77, .part = 77, .instance = 77};
}
inline constexpr std::uint8_t kUntouchedFlag = 77;

template <class T>
void expectSameHits(std::span<const Ray<T>> rays, std::span<const Hit<T>> hits,
                    std::span<const Hit<T>> expected) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_TRUE(hasSameBits(hits[i], expected[i]))
        << describeRay(rays[i]) << ", number " << i << " of " << rays.size() << "\n  hits "
        << testing::PrintToString(hits[i]) << "\n  alone " << testing::PrintToString(expected[i]);
  }
}

inline void expectSameFlags(std::span<const std::uint8_t> flags,
                            std::span<const std::uint8_t> expected) {
  for (std::size_t i = 0; i < flags.size(); ++i)
    ASSERT_EQ(int{flags[i]}, int{expected[i]}) << "ray " << i << " of " << flags.size();
}

/// Both kinds of batch, over arrays of structures. Nothing beside the answers may be written.
template <class T>
void expectAnswers(const TreeView<T>& tree, std::span<const Ray<T>> rays,
                   const SingleAnswers<T>& expected, const BatchOptions& options = {}) {
  constexpr std::size_t kMargin = 16;
  const std::size_t count = rays.size();
  std::vector<Hit<T>> hits(count + 2 * kMargin, untouchedHit<T>());
  const std::span<Hit<T>> asked = std::span(hits).subspan(kMargin, count);
  EXPECT_EQ(findIntersections<T>(tree, rays, asked, options), expected.hitCount);
  expectSameHits<T>(rays, asked, expected.hits);
  std::vector<std::uint8_t> flags(count + 2 * kMargin, kUntouchedFlag);
  const std::span<std::uint8_t> askedFlags = std::span(flags).subspan(kMargin, count);
  EXPECT_EQ(areOccluded<T>(tree, rays, askedFlags, options), expected.hitCount);
  expectSameFlags(askedFlags, expected.flags);
  for (std::size_t i = 0; i < kMargin; ++i) {
    ASSERT_TRUE(hasSameBits(hits[i], untouchedHit<T>()));
    ASSERT_TRUE(hasSameBits(hits[kMargin + count + i], untouchedHit<T>()));
    ASSERT_EQ(flags[i], kUntouchedFlag);
    ASSERT_EQ(flags[kMargin + count + i], kUntouchedFlag);
  }
}

template <class T>
void expectSameAsAlone(const TreeView<T>& tree, const std::vector<Ray<T>>& rays,
                       const BatchOptions& options = {}) {
  expectAnswers<T>(tree, rays, SingleAnswers<T>(tree, rays, options.query), options);
}

}  // namespace planetree::test
