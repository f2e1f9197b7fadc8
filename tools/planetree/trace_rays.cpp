#include "trace_rays.hpp"

#include "ray_files/hit_table.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <array>
#include <atomic>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace planetree::tool {

namespace {

/// Blocks between reading and writing, for each thread: enough that none waits for its turn to
/// write.
constexpr std::size_t kBlocksPerThread = 4;

/// Origin and direction, and nothing besides.
constexpr std::size_t kColumnsWithoutLimits = 6;

/// How many hits of a ray are asked for at once. Few rays have more, and those that do are asked
/// again.
constexpr std::size_t kHitsAtOnce = 64;

/// A block on its way from the rays to the hits.
template <class T>
struct Parcel {
  RayBlock block;
  std::vector<Ray<T>> rays;
  std::uint64_t firstRay = 0;  ///< number of the first of them
  std::string rows;
  TraceReport report;
  /// A fault is kept until all blocks before it are written: which one is told, and what is written
  /// before, must not depend on the threads.
  std::exception_ptr fault;
};

template <class T>
bool isValid(const Ray<T>& ray) noexcept {
  return isFinite(ray.origin) && isFinite(ray.direction) && ray.direction != Vec3<T>{} &&
         !std::isnan(ray.tMin) && !std::isnan(ray.tMax);
}

template <class T>
std::vector<Ray<T>> decode(const RayReader& reader, const RayBlock& block) {
  if constexpr (std::same_as<T, float>) {
    return reader.decodeFloat(block);
  } else {
    return reader.decodeDouble(block);
  }
}

template <class T>
void setLimits(std::vector<Ray<T>>& rays, const RayLimits& limits) {
  for (Ray<T>& ray : rays) {
    ray.tMin = static_cast<T>(limits.tMin);
    ray.tMax = static_cast<T>(limits.tMax);
  }
}

// Each of these appends the answers to the rays of a block, the first of which has this number, and
// returns how many of them hit anything. Other threads have blocks of their own.

template <class T>
std::size_t answer(const KdTree<Face<T>>& tree, std::span<const Ray<T>> rays,
                   std::uint64_t /*firstRay*/, const QueryOptions& options,
                   std::vector<Hit<T>>& answers) {
  answers.resize(rays.size());
  return tree.findIntersections(rays, answers, {.query = options, .threadCount = 1});
}

template <class T>
std::size_t answer(const KdTree<Face<T>>& tree, std::span<const Ray<T>> rays,
                   std::uint64_t /*firstRay*/, const QueryOptions& options,
                   std::vector<Occlusion>& answers) {
  std::vector<std::uint8_t> flags(rays.size());
  const std::size_t hitCount = tree.areOccluded(rays, flags, {.query = options, .threadCount = 1});
  for (const std::uint8_t flag : flags)
    answers.push_back({.isHit = flag != 0});
  return hitCount;
}

template <class T>
std::size_t answer(const KdTree<Face<T>>& tree, std::span<const Ray<T>> rays,
                   std::uint64_t firstRay, const QueryOptions& options,
                   std::vector<NumberedHit<T>>& answers) {
  std::size_t hitCount = 0;
  std::array<Hit<T>, kHitsAtOnce> hits;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    FoundHits found = tree.findIntersections(rays[i], hits, options);
    hitCount += found.count > 0 ? 1u : 0u;
    while (true) {
      for (std::size_t k = 0; k < found.count; ++k)
        answers.push_back({.ray = firstRay + i, .hit = hits[k]});
      if (!found.hasMore)
        break;
      found = tree.findNextIntersections(rays[i], hits.back(), hits, options);
    }
  }
  return hitCount;
}

/// The stages of a block, and the table that comes out.
template <class T, class Answer>
class Tracing {
  using ParcelPointer = std::shared_ptr<Parcel<T>>;

 public:
  Tracing(const KdTree<Face<T>>& tree, RayReader& rays, OutputFile& hits,
          const TraceSettings& settings)
      : tree_(tree), rays_(rays), hits_(hits), settings_(settings) {}

  TraceReport run(std::size_t mostBlocks) {
    using tbb::filter_mode;
    const auto reading = tbb::make_filter<void, ParcelPointer>(filter_mode::serial_in_order,
                                                               [this](tbb::flow_control& control) {
                                                                 ParcelPointer parcel = read();
                                                                 if (!parcel)
                                                                   control.stop();
                                                                 return parcel;
                                                               });
    const auto decoding = tbb::make_filter<ParcelPointer, ParcelPointer>(
        filter_mode::parallel, [this](ParcelPointer parcel) {
          decodeRays(*parcel);
          return parcel;
        });
    const auto numbering = tbb::make_filter<ParcelPointer, ParcelPointer>(
        filter_mode::serial_in_order, [this](ParcelPointer parcel) {
          parcel->firstRay = numberedCount_;
          numberedCount_ += parcel->rays.size();
          return parcel;
        });
    const auto tracing = tbb::make_filter<ParcelPointer, ParcelPointer>(
        filter_mode::parallel, [this](ParcelPointer parcel) {
          trace(*parcel);
          return parcel;
        });
    const auto writing = tbb::make_filter<ParcelPointer, void>(
        filter_mode::serial_in_order, [this](const ParcelPointer& parcel) { write(*parcel); });

    beginTable();
    tbb::parallel_pipeline(mostBlocks, reading & decoding & numbering & tracing & writing);
    if (fault_)
      std::rethrow_exception(fault_);
    endTable();
    return report_;
  }

 private:
  void beginTable() {
    // One row for each ray, unless every hit has one.
    const auto count = settings_.query == RayQuery::AllHits ? std::nullopt : rays_.rayCount();
    std::string header = tableHeader<Answer>(settings_.format, count.value_or(0));
    isCountMissing_ = settings_.format == TableFormat::Npy && !count;
    // Until the count is known the table must not pass for one.
    if (isCountMissing_)
      header.assign(header.size(), ' ');
    append(header);
  }

  void endTable() {
    if (!isCountMissing_)
      return;
    const std::string header = tableHeader<Answer>(settings_.format, report_.rowCount);
    hits_.overwriteStart(std::as_bytes(std::span(header)));
  }

  // No stage throws: oneTBB would forget the blocks on their way without freeing them.

  /// The next block; nothing at the end, or after a fault.
  ParcelPointer read() {
    if (isAtEnd_ || isStopped_)
      return nullptr;
    // Rays that are slow to come must not keep a fault from being told.
    const auto keepsGoing = [this] { return !isStopped_; };
    auto parcel = std::make_shared<Parcel<T>>();
    try {
      isAtEnd_ = !rays_.next(parcel->block, keepsGoing);
      if (isAtEnd_)
        return nullptr;
      if (const auto progress = rays_.progress(); progress && settings_.reportProgress)
        settings_.reportProgress(*progress);
    } catch (...) {
      isAtEnd_ = true;
      parcel->fault = std::current_exception();
    }
    return parcel;
  }

  /// Any number of blocks at once.
  void decodeRays(Parcel<T>& parcel) const noexcept {
    if (parcel.fault)
      return;
    try {
      parcel.rays = decode<T>(rays_, parcel.block);
      if (parcel.block.columnCount == kColumnsWithoutLimits)
        setLimits(parcel.rays, settings_.limits);
    } catch (...) {
      parcel.fault = std::current_exception();
    }
  }

  /// Any number of blocks at once.
  void trace(Parcel<T>& parcel) const noexcept {
    if (parcel.fault)
      return;
    try {
      std::vector<Answer> answers;
      answers.reserve(parcel.rays.size());
      parcel.report.hitCount =
          answer<T>(tree_, parcel.rays, parcel.firstRay, settings_.options, answers);
      for (const Ray<T>& ray : parcel.rays)
        parcel.report.invalidRayCount += isValid(ray) ? 0u : 1u;
      parcel.report.rayCount = parcel.rays.size();
      parcel.report.rowCount = answers.size();
      appendRows<Answer>(parcel.rows, settings_.format, answers);
    } catch (...) {
      parcel.fault = std::current_exception();
    }
  }

  void write(const Parcel<T>& parcel) noexcept {
    if (isStopped_)
      return;
    try {
      if (parcel.fault)
        std::rethrow_exception(parcel.fault);
      append(parcel.rows);
    } catch (...) {
      fault_ = std::current_exception();
      isStopped_ = true;
    }
    report_.rayCount += parcel.report.rayCount;
    report_.hitCount += parcel.report.hitCount;
    report_.rowCount += parcel.report.rowCount;
    report_.invalidRayCount += parcel.report.invalidRayCount;
  }

  void append(const std::string& bytes) {
    hits_.write(std::as_bytes(std::span(bytes)));
    report_.byteCount += bytes.size();
  }

  const KdTree<Face<T>>& tree_;
  RayReader& rays_;
  OutputFile& hits_;
  const TraceSettings& settings_;
  TraceReport report_;
  std::uint64_t numberedCount_ = 0;  ///< rays that have got a number
  bool isAtEnd_ = false;
  bool isCountMissing_ = false;
  std::exception_ptr fault_;  ///< the first one
  /// There was a fault, and nothing more is to be written.
  std::atomic<bool> isStopped_ = false;
};

}  // namespace

template <std::floating_point T>
TraceReport traceRays(const KdTree<Face<T>>& tree, RayReader& rays, OutputFile& hits,
                      const TraceSettings& settings) {
  const int threadCount = settings.threadCount == 0 ? tbb::info::default_concurrency()
                                                    : static_cast<int>(settings.threadCount);
  const auto mostThreads = static_cast<std::size_t>(threadCount);
  // Without it oneTBB never runs more threads than the machine has.
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, mostThreads);
  tbb::task_arena arena(threadCount);
  const std::size_t mostBlocks = kBlocksPerThread * mostThreads;
  return arena.execute([&] {
    switch (settings.query) {
      case RayQuery::AnyHit:
        return Tracing<T, Occlusion>(tree, rays, hits, settings).run(mostBlocks);
      case RayQuery::AllHits:
        return Tracing<T, NumberedHit<T>>(tree, rays, hits, settings).run(mostBlocks);
      default:
        return Tracing<T, Hit<T>>(tree, rays, hits, settings).run(mostBlocks);
    }
  });
}

template TraceReport traceRays<float>(const KdTree<Face<float>>&, RayReader&, OutputFile&,
                                      const TraceSettings&);
template TraceReport traceRays<double>(const KdTree<Face<double>>&, RayReader&, OutputFile&,
                                       const TraceSettings&);

}  // namespace planetree::tool
