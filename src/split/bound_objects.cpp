#include "split/bound_objects.hpp"

#include <planetree/detail/bounding_table.hpp>
#include <planetree/error.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <limits>

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

template <class T>
std::vector<BoundedObject> boundGeometry(const GeometryEntry<T>& geometry) {
  std::vector<BoundedObject> objects(geometry.size);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, objects.size(), kBatchSize),
                    [&](const tbb::blocked_range<std::size_t>& batch) {
                      geometry.bounding->bound(
                          geometry.range, static_cast<std::uint32_t>(batch.begin()),
                          std::span(objects).subspan(batch.begin(), batch.size()));
                    });
  return objects;
}

}  // namespace

template <class T>
BoundedObjects boundObjects(std::span<GeometryEntry<T>> geometries, BuildReport& report) {
  numberObjects(geometries, report);
  BoundedObjects bounded;
  bounded.references.reserve(report.objectCount);
  for (std::size_t g = 0; g < geometries.size(); ++g) {
    const std::vector<BoundedObject> objects = boundGeometry(geometries[g]);
    for (std::size_t primitive = 0; primitive < objects.size(); ++primitive) {
      const BoundedObject& object = objects[primitive];
      if (object.skipReason) {
        ++report.skippedCount;
        if (report.skipped.size() < kReportedSkips) {
          report.skipped.push_back({static_cast<std::uint32_t>(g),
                                    static_cast<std::uint32_t>(primitive), *object.skipReason});
        }
        continue;
      }
      bounded.bounds.extend(object.reference.bounds);
      bounded.references.push_back(object.reference);
      bounded.references.back().object =
          geometries[g].firstObject + static_cast<std::uint32_t>(primitive);
    }
  }
  return bounded;
}

template BoundedObjects boundObjects(std::span<GeometryEntry<float>>, BuildReport&);
template BoundedObjects boundObjects(std::span<GeometryEntry<double>>, BuildReport&);

}  // namespace planetree::detail
