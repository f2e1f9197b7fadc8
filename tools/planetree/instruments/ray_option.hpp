#pragma once

#include "command_options.hpp"
#include "option_values.hpp"

#include <planetree/geometry/ray.hpp>

#include <concepts>

namespace planetree::tool {

/// "ox,oy,oz,dx,dy,dz[,tMin,tMax]", rounded as `planetree trace` rounds the rays of a table;
/// without tMin and tMax the ray has these limits. Throws `UsageError` also for rays that miss
/// whatever is in their way: nobody asks for such a ray on purpose.
template <std::floating_point T>
[[nodiscard]] Ray<T> parseRay(const OptionText& option, const RayLimits& limits);

extern template Ray<float> parseRay<float>(const OptionText&, const RayLimits&);
extern template Ray<double> parseRay<double>(const OptionText&, const RayLimits&);

}  // namespace planetree::tool
