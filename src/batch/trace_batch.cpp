#include <planetree/batch/trace_batch.hpp>
#include <planetree/error.hpp>
#include <planetree/traversal/find_intersection.hpp>

#include "batch/batch_monitor.hpp"
#include "batch/columns.hpp"
#include "batch/trace_portion.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <functional>
#include <string>

namespace planetree {
namespace detail {
namespace {

/// Packets that one thread traces before it looks up: about a hundred microseconds.
constexpr std::size_t kPortion = 64;
/// Batches of no more packets are not worth waking other threads.
constexpr std::size_t kMostForOneThread = kPortion;

/// Of no more rays each is traced on its own: that costs less than to look what they share.
constexpr std::size_t kFewRays = 12;

void requireSize(std::size_t size, std::size_t rayCount, const std::string& what) {
  if (size == rayCount)
    return;
  throw Error(ErrorCode::InvalidOption,
              what + " has " + std::to_string(size) + " elements, and the batch " +
                  std::to_string(rayCount) + " rays",
              "Hand over spans of one size.");
}

template <class Number>
void requireSizeIfThere(std::span<Number> array, std::size_t rayCount, const char* name) {
  if (!array.empty())
    requireSize(array.size(), rayCount, name);
}

template <class T>
void requireSizes(const RayArrays<T>& rays) {
  const std::size_t count = rays.originX.size();
  requireSize(rays.originY.size(), count, "originY");
  requireSize(rays.originZ.size(), count, "originZ");
  requireSize(rays.directionX.size(), count, "directionX");
  requireSize(rays.directionY.size(), count, "directionY");
  requireSize(rays.directionZ.size(), count, "directionZ");
  requireSizeIfThere(rays.tMin, count, "tMin");
  requireSizeIfThere(rays.tMax, count, "tMax");
}

template <class T>
void requireSizes(const HitArrays<T>& hits, std::size_t rayCount) {
  requireSizeIfThere(hits.t, rayCount, "t");
  requireSizeIfThere(hits.u, rayCount, "u");
  requireSizeIfThere(hits.v, rayCount, "v");
  requireSizeIfThere(hits.normalX, rayCount, "normalX");
  requireSizeIfThere(hits.normalY, rayCount, "normalY");
  requireSizeIfThere(hits.normalZ, rayCount, "normalZ");
  requireSizeIfThere(hits.geometry, rayCount, "geometry");
  requireSizeIfThere(hits.primitive, rayCount, "primitive");
  requireSizeIfThere(hits.part, rayCount, "part");
}

/// Calls `trace(begin, end)`, which returns how many rays of these packets hit, for all packets in
/// portions, and returns the sum.
template <class Trace>
std::size_t traceInPortions(std::size_t packetCount, const BatchOptions& options,
                            const BatchControl& control, const Trace& trace) {
  throwIfStopped(control);
  BatchMonitor monitor(control, packetCount);
  const auto tracePortions = [&](std::size_t begin, std::size_t end) {
    std::size_t hitCount = 0;
    for (; begin < end; begin += std::min(kPortion, end - begin)) {
      const std::size_t portion = std::min(kPortion, end - begin);
      hitCount += trace(begin, begin + portion);
      monitor.advance(portion);
    }
    return hitCount;
  };
  std::size_t hitCount = 0;
  if (packetCount <= kMostForOneThread || options.threadCount == 1) {
    hitCount = tracePortions(0, packetCount);
  } else {
    // A group of its own: the end of a caller's group must not cut this one short. The mode of
    // rounding and of denormals is that of the calling thread, in all threads.
    using Context = tbb::task_group_context;
    Context context(Context::isolated, Context::default_traits | Context::fp_settings);
    const auto inParallel = [&] {
      hitCount = tbb::parallel_reduce(
          tbb::blocked_range<std::size_t>(0, packetCount, kPortion), std::size_t{0},
          [&](const tbb::blocked_range<std::size_t>& range, std::size_t sum) {
            return sum + tracePortions(range.begin(), range.end());
          },
          std::plus<>(), context);
    };
    if (options.threadCount == 0) {
      // A thread that waits must not begin another task of the caller, who may hold a lock.
      tbb::this_task_arena::isolate(inParallel);
    } else {
      // oneTBB complains on standard error where more are asked for than there are.
      const std::size_t allowed =
          tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
      const std::size_t wanted = options.threadCount;
      tbb::task_arena(static_cast<int>(std::min(wanted, allowed))).execute(inParallel);
    }
  }
  monitor.finish();
  return hitCount;
}

/// The same for rays that are too few to have something in common.
template <class TraceOne>
std::size_t traceFew(std::size_t rayCount, const BatchControl& control, const TraceOne& traceOne) {
  throwIfStopped(control);
  std::size_t hitCount = 0;
  for (std::size_t ray = 0; ray < rayCount; ++ray)
    hitCount += traceOne(ray) ? 1u : 0u;
  throwIfStopped(control);
  BatchMonitor(control, rayCount).finish();
  return hitCount;
}

template <class T>
std::size_t findNearest(const TreeView<T>& tree, const RayColumns<T>& rays,
                        const HitColumns<T>& hits, const BatchOptions& options,
                        const BatchControl& control) {
  if (rays.count <= kFewRays) {
    return traceFew(rays.count, control, [&](std::size_t ray) {
      const auto hit = findIntersection(tree, rays[ray], options.query);
      hits.write(ray, hit ? *hit : Hit<T>{});
      return hit.has_value();
    });
  }
  const PortionTracer<T> tracer(tree, rays, options.query);
  return traceInPortions(
      tracer.packetCount(), options, control,
      [&](std::size_t begin, std::size_t end) { return tracer.findNearest(begin, end, hits); });
}

template <class T>
std::size_t findAny(const TreeView<T>& tree, const RayColumns<T>& rays,
                    std::span<std::uint8_t> flags, const BatchOptions& options,
                    const BatchControl& control) {
  requireSize(flags.size(), rays.count, "flags");
  if (rays.count <= kFewRays) {
    return traceFew(rays.count, control, [&](std::size_t ray) {
      const bool isHit = isOccluded(tree, rays[ray], options.query);
      flags[ray] = isHit ? 1u : 0u;
      return isHit;
    });
  }
  const PortionTracer<T> tracer(tree, rays, options.query);
  return traceInPortions(
      tracer.packetCount(), options, control,
      [&](std::size_t begin, std::size_t end) { return tracer.findAny(begin, end, flags); });
}

}  // namespace
}  // namespace detail

template <class T>
std::size_t findIntersections(const TreeView<T>& tree, std::span<const Ray<T>> rays,
                              std::span<Hit<T>> hits, const BatchOptions& options,
                              const BatchControl& control) {
  detail::requireSize(hits.size(), rays.size(), "hits");
  return detail::findNearest(tree, detail::RayColumns<T>(rays), detail::HitColumns<T>(hits),
                             options, control);
}

template <class T>
std::size_t findIntersections(const TreeView<T>& tree, const RayArrays<T>& rays,
                              const HitArrays<T>& hits, const BatchOptions& options,
                              const BatchControl& control) {
  detail::requireSizes(rays);
  detail::requireSizes(hits, rays.originX.size());
  return detail::findNearest(tree, detail::RayColumns<T>(rays), detail::HitColumns<T>(hits),
                             options, control);
}

template <class T>
std::size_t areOccluded(const TreeView<T>& tree, std::span<const Ray<T>> rays,
                        std::span<std::uint8_t> flags, const BatchOptions& options,
                        const BatchControl& control) {
  return detail::findAny(tree, detail::RayColumns<T>(rays), flags, options, control);
}

template <class T>
std::size_t areOccluded(const TreeView<T>& tree, const RayArrays<T>& rays,
                        std::span<std::uint8_t> flags, const BatchOptions& options,
                        const BatchControl& control) {
  detail::requireSizes(rays);
  return detail::findAny(tree, detail::RayColumns<T>(rays), flags, options, control);
}

#define PLANETREE_INSTANTIATE(T)                                                      \
  template std::size_t findIntersections(const TreeView<T>&, std::span<const Ray<T>>, \
                                         std::span<Hit<T>>, const BatchOptions&,      \
                                         const BatchControl&);                        \
  template std::size_t findIntersections(const TreeView<T>&, const RayArrays<T>&,     \
                                         const HitArrays<T>&, const BatchOptions&,    \
                                         const BatchControl&);                        \
  template std::size_t areOccluded(const TreeView<T>&, std::span<const Ray<T>>,       \
                                   std::span<std::uint8_t>, const BatchOptions&,      \
                                   const BatchControl&);                              \
  template std::size_t areOccluded(const TreeView<T>&, const RayArrays<T>&,           \
                                   std::span<std::uint8_t>, const BatchOptions&,      \
                                   const BatchControl&);
PLANETREE_INSTANTIATE(float)
PLANETREE_INSTANTIATE(double)
#undef PLANETREE_INSTANTIATE

}  // namespace planetree
