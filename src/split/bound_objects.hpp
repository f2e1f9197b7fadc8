#pragma once

#include <planetree/detail/geometry_entry.hpp>
#include <planetree/geometry/box3.hpp>
#include <planetree/split/build_report.hpp>
#include <planetree/split/reference.hpp>

#include "split/build_monitor.hpp"
#include "split/divide_references.hpp"

#include <span>

namespace planetree::detail {

/// What the builder starts from: one reference per object that can be hit, in rising order of the
/// object numbers.
struct BoundedObjects {
  CellReferences all;
  Box3 bounds;
};

/// Numbers the objects of all geometries one after the other (sets `firstObject`), bounds them, and
/// reports those that are left out. Runs in the current oneTBB arena. Throws `Error` with
/// `CapacityExceeded` for more objects than 32 bits can number.
template <class T>
[[nodiscard]] BoundedObjects boundObjects(std::span<GeometryEntry<T>> geometries,
                                          BuildReport& report, BuildMonitor& monitor);

}  // namespace planetree::detail
