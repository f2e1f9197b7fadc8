#pragma once

#include "bench/rivals/engine.hpp"
#include "bench/support/ray_kinds.hpp"

#include <cstddef>
#include <memory>

/// The ways in which the rays of a set are handed to a structure. The structure and the set outlive
/// the batch.
namespace planetree::bench {

/// Ray by ray, each a call of its own.
[[nodiscard]] std::unique_ptr<Batch> oneByOne(const Structure& structure, const RaySet& set);

/// All together, by what the library has for many rays; ray by ray where it has nothing.
[[nodiscard]] std::unique_ptr<Batch> allAtOnce(const Structure& structure, const RaySet& set);

}  // namespace planetree::bench
