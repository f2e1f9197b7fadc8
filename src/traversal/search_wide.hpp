#pragma once

#include <planetree/hit/hit.hpp>
#include <planetree/traversal/prepared_ray.hpp>
#include <planetree/traversal/tree_view.hpp>

#include "isa/wide_kernels.hpp"
#include "traversal/traverse.hpp"

#include <optional>

namespace planetree::detail {

/// What the wide form of the tree says, bit for bit what `traverse` would. Nothing if there is no
/// wide form, or if the ray's numbers are beyond its range: then the binary form has to be asked.
/// Goals that offer hits leave `hit` alone.
template <class Goal>
[[nodiscard]] std::optional<bool> searchWide(const Request<float>& request, Hitf& hit,
                                             const WideKernels& kernels = wideKernels()) noexcept;

#define PLANETREE_DECLARE(Goal)                                                    \
  extern template std::optional<bool> searchWide<Goal>(const Request<float>&, Hitf&, \
                                                       const WideKernels&) noexcept;
PLANETREE_DECLARE(NearestHit)
PLANETREE_DECLARE(AnyHit)
PLANETREE_DECLARE(NearestOffer)
PLANETREE_DECLARE(AnyOffer)
PLANETREE_DECLARE(EveryOffer)
#undef PLANETREE_DECLARE

}  // namespace planetree::detail
