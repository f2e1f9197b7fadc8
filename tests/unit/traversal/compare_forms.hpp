#pragma once

#include <planetree/traversal/find_intersection.hpp>

#include "traversal/search_wide.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace planetree::detail {

/// What the binary form says; it is compared with brute force elsewhere.
template <class T>
[[nodiscard]] std::optional<Hit<T>> askBinaryForm(const TreeView<T>& tree, const Ray<T>& ray,
                                                  const QueryOptions& options = {}) {
  StepCounts steps;
  return findIntersection(tree, ray, options, &steps);
}

/// Compares all instruction sets with the binary form; returns how many rays the wide form took.
template <class T>
std::size_t compareForms(const TreeView<T>& tree, const std::vector<Ray<T>>& rays,
                         const QueryOptions& options = {}) {
  std::size_t answeredCount = 0;
  for (const Ray<T>& ray : rays) {
    const std::optional<Hit<T>> expected = askBinaryForm(tree, ray, options);
    Request<T> request(tree, ray, ray.tMin, ray.tMax);
    request.mask = options.mask;
    for (const Kernels& kernels : supportedKernels()) {
      Hit<T> hit;
      const std::optional<bool> found = searchWide<NearestHit>(request, hit, kernels);
      if (!found)
        continue;
      ++answeredCount;
      EXPECT_EQ(*found, expected.has_value()) << kernels.name;
      EXPECT_EQ(hit, expected.value_or(Hit<T>{})) << kernels.name;
      Hit<T> unused;
      EXPECT_EQ(searchWide<AnyHit>(request, unused, kernels), expected.has_value()) << kernels.name;
    }
  }
  return answeredCount;
}

}  // namespace planetree::detail
