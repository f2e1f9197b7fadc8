#pragma once

#include <planetree/hit/hit.hpp>
#include <planetree/traversal/tree_view.hpp>

#include "isa/wide_kernels.hpp"
#include "traversal/traverse.hpp"

#include <optional>

namespace planetree::detail {

/// What the wide form of the tree says, bit for bit what `traverse` would. Nothing if there is no
/// wide form, or if the ray's numbers are beyond its range: then the binary form has to be asked.
/// Goals that offer hits leave `hit` alone.
///
/// Triangles in float whose hits all count are decided by the kernels. In double, and where there
/// are choices to make, the kernels find the candidates, which takes a few dozen nanoseconds more.
template <class Goal, class T>
[[nodiscard]] std::optional<bool> searchWide(const Request<T>& request, Hit<T>& hit,
                                             const WideKernels& kernels = wideKernels()) noexcept;

#define PLANETREE_DECLARE(Goal, T)                                                 \
  extern template std::optional<bool> searchWide<Goal>(const Request<T>&, Hit<T>&, \
                                                       const WideKernels&) noexcept;
#define PLANETREE_DECLARE_FOR(T)     \
  PLANETREE_DECLARE(NearestHit, T)   \
  PLANETREE_DECLARE(AnyHit, T)       \
  PLANETREE_DECLARE(NearestOffer, T) \
  PLANETREE_DECLARE(AnyOffer, T)     \
  PLANETREE_DECLARE(EveryOffer, T)
PLANETREE_DECLARE_FOR(float)
PLANETREE_DECLARE_FOR(double)
#undef PLANETREE_DECLARE_FOR
#undef PLANETREE_DECLARE

}  // namespace planetree::detail
