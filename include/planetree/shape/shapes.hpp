#pragma once

/// The shapes of the library. Each is a plain struct that meets the concept `Shape` (object.hpp)
/// and can be put into a tree by value, in a `std::variant`, behind a pointer, or as a `Geometry`.
///
/// Common to all:
///  - `bounds` holds the whole shape, rounded outward.
///  - `intersect` finds every crossing of the whole line first and then takes the nearest one
///    with t in [tMin, tMax]: asking again from `nextUp(hit.t)` finds the others, each once. A
///    tangent touches once. Two crossings whose t round to the same number are one hit, the one
///    that comes first.
///  - it is computed in double also where T is float, and t is rounded once at the end.
///  - a ray whose origin or direction is not finite, or whose direction is zero, misses.
#include <planetree/shape/box.hpp>
#include <planetree/shape/cone.hpp>
#include <planetree/shape/cylinder.hpp>
#include <planetree/shape/geometry.hpp>
#include <planetree/shape/sphere.hpp>
#include <planetree/shape/square.hpp>
#include <planetree/shape/triangle.hpp>
