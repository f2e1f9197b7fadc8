#pragma once

#include "command_options.hpp"
#include "output_file.hpp"
#include "ray_files/ray_reader.hpp"

#include <planetree/kd_tree.hpp>
#include <planetree/mesh/face.hpp>

#include <concepts>
#include <cstdint>
#include <functional>

namespace planetree::tool {

/// What is asked of each ray.
enum class RayQuery : std::uint8_t {
  ClosestHit,  ///< the first hit
  AnyHit,      ///< only whether there is one
  AllHits,     ///< every hit, a row for each
};

struct TraceSettings {
  RayQuery query = RayQuery::ClosestHit;
  QueryOptions options;
  RayLimits limits;  ///< of rays that bring none
  TableFormat format = TableFormat::Csv;
  std::uint32_t threadCount = 0;  ///< 0 is as many as the machine has
  /// Told now and then which part of the rays was read, where that is known.
  std::function<void(double)> reportProgress;
};

struct TraceReport {
  std::uint64_t rayCount = 0;
  std::uint64_t hitCount = 0;  ///< rays that hit something
  std::uint64_t rowCount = 0;  ///< of the table of hits
  /// Rays that can hit nothing, because a number is not finite or the direction is zero.
  std::uint64_t invalidRayCount = 0;
  std::uint64_t byteCount = 0;  ///< of the table of hits
};

/// Traces all rays and writes the table of their hits, in their order. Blocks of rays are decoded,
/// traced and turned into rows by all threads at once; the number of blocks at hand is bounded, and
/// so is the memory, but for the hits of a block where all are asked for. Throws `Error` for the
/// first fault of the rays, or if writing fails.
///
/// A .npy table whose length is not known beforehand needs an output that can go back to its start.
template <std::floating_point T>
[[nodiscard]] TraceReport traceRays(const KdTree<Face<T>>& tree, RayReader& rays, OutputFile& hits,
                                    const TraceSettings& settings);

extern template TraceReport traceRays<float>(const KdTree<Face<float>>&, RayReader&, OutputFile&,
                                             const TraceSettings&);
extern template TraceReport traceRays<double>(const KdTree<Face<double>>&, RayReader&, OutputFile&,
                                              const TraceSettings&);

}  // namespace planetree::tool
