#include "split/bound_objects.hpp"

#include <planetree/detail/bounding_table.hpp>
#include <planetree/error.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace planetree::detail {
namespace {

constexpr std::size_t kBatchSize = 1024;
constexpr std::size_t kReportedSkips = 16;

template <class T>
void numberObjects(std::span<GeometryEntry<T>> geometries, BuildReport& report) {
  std::uint64_t count = 0;
  for (GeometryEntry<T>& geometry : geometries) {
    geometry.firstObject = static_cast<std::uint32_t>(count);
    count += geometry.size;
    // The highest number is `kNoId`, which must stay free.
    if (count >= kNoId || geometry.size >= kNoId) {
      throw Error(ErrorCode::CapacityExceeded,
                  "the scene has more than " + std::to_string(kNoId - 1) + " objects",
                  "Divide it into several trees.");
    }
  }
  report.objectCount = count;
}

/// What one batch of objects comes to.
struct Batch {
  Box3 bounds;
  std::uint64_t skippedCount = 0;
  std::vector<SkippedObject> skipped;  ///< the first few of them
};

/// Bounds the primitives from `first` on, one for each of `references`. Those of skipped objects
/// get an empty box.
template <class T>
Batch boundBatch(const GeometryEntry<T>& geometry, std::uint32_t geometryIndex, std::uint32_t first,
                 std::span<Reference> references) {
  std::vector<BoundedObject> objects(references.size());
  geometry.bounding->bound(geometry.range, first, objects);
  Batch batch;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::uint32_t primitive = first + static_cast<std::uint32_t>(i);
    references[i] = objects[i].reference;
    references[i].object = geometry.firstObject + primitive;
    if (!objects[i].skipReason) {
      batch.bounds.extend(references[i].bounds);
      continue;
    }
    references[i].bounds = {};
    ++batch.skippedCount;
    if (batch.skipped.size() < kReportedSkips)
      batch.skipped.push_back({geometryIndex, primitive, *objects[i].skipReason});
  }
  return batch;
}

void report(const Batch& batch, BuildReport& report) {
  report.skippedCount += batch.skippedCount;
  for (const SkippedObject& skipped : batch.skipped) {
    if (report.skipped.size() < kReportedSkips)
      report.skipped.push_back(skipped);
  }
}

}  // namespace

template <class T>
BoundedObjects boundObjects(std::span<GeometryEntry<T>> geometries, BuildReport& buildReport,
                            BuildMonitor& monitor) {
  numberObjects(geometries, buildReport);
  BoundedObjects bounded;
  bounded.all = CellReferences(buildReport.objectCount, monitor.memory());
  for (std::size_t g = 0; g < geometries.size(); ++g) {
    const GeometryEntry<T>& geometry = geometries[g];
    const auto references = bounded.all.references.from(geometry.firstObject).first(geometry.size);
    std::vector<Batch> batches((geometry.size + kBatchSize - 1) / kBatchSize);
    tbb::parallel_for(std::size_t{0}, batches.size(), [&](std::size_t i) {
      const std::size_t first = i * kBatchSize;
      const std::size_t count = std::min<std::size_t>(kBatchSize, geometry.size - first);
      batches[i] = boundBatch(geometry, static_cast<std::uint32_t>(g),
                              static_cast<std::uint32_t>(first), references.subspan(first, count));
      monitor.advance(static_cast<double>(count) / static_cast<double>(buildReport.objectCount));
    });
    for (const Batch& batch : batches) {
      bounded.bounds.extend(batch.bounds);
      report(batch, buildReport);
    }
  }
  if (buildReport.skippedCount > 0) {
    const std::span<Reference> all = bounded.all.references.values();
    const auto end = std::remove_if(all.begin(), all.end(),
                                    [](const Reference& r) { return r.bounds.isEmpty(); });
    bounded.all.references.resize(static_cast<std::size_t>(end - all.begin()));
  }
  return bounded;
}

template BoundedObjects boundObjects(std::span<GeometryEntry<float>>, BuildReport&, BuildMonitor&);
template BoundedObjects boundObjects(std::span<GeometryEntry<double>>, BuildReport&, BuildMonitor&);

}  // namespace planetree::detail
