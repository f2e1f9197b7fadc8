#pragma once

#include <planetree/hit/hit.hpp>

#include <ostream>

namespace planetree {

/// Shown by GoogleTest when a comparison fails.
template <class T>
void PrintTo(const Hit<T>& hit, std::ostream* out) {
  *out << "t " << hit.t << " geometry " << hit.geometry << " primitive " << hit.primitive
       << " part " << hit.part << " u " << hit.u << " v " << hit.v << " normal (" << hit.normal.x
       << ", " << hit.normal.y << ", " << hit.normal.z << ")";
}

}  // namespace planetree
