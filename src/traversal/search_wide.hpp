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
template <class Goal>
[[nodiscard]] std::optional<bool> searchWide(const Query<float>& query, Hitf& hit,
                                             const WideKernels& kernels = wideKernels()) noexcept;

/// In double a few dozen nanoseconds more: the float boxes and triangles of the wide form leave
/// candidates, which are decided with the corners of their mesh.
template <class Goal>
[[nodiscard]] std::optional<bool> searchWide(const Query<double>& query, Hitd& hit,
                                             const WideKernels& kernels = wideKernels()) noexcept;

extern template std::optional<bool> searchWide<NearestHit>(const Query<float>&, Hitf&,
                                                           const WideKernels&) noexcept;
extern template std::optional<bool> searchWide<AnyHit>(const Query<float>&, Hitf&,
                                                       const WideKernels&) noexcept;
extern template std::optional<bool> searchWide<NearestHit>(const Query<double>&, Hitd&,
                                                           const WideKernels&) noexcept;
extern template std::optional<bool> searchWide<AnyHit>(const Query<double>&, Hitd&,
                                                       const WideKernels&) noexcept;

}  // namespace planetree::detail
