#pragma once

#include <planetree/object.hpp>
#include <planetree/split/build_report.hpp>
#include <planetree/split/reference.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace planetree::detail {

/// An object as the builder receives it.
struct BoundedObject {
  Reference reference;
  std::optional<SkipReason> skipReason;  ///< set if the object cannot enter the tree
};

/// How the builder reaches objects whose type it does not know: plain functions that take the
/// address of an object range. Called once per batch, so that the indirect call is shared by many
/// objects.
struct BoundingTable {
  /// Bounds the primitives `first`, `first + 1`, ...: one for each entry of `objects`. The object
  /// numbers are left unset.
  void (*bound)(const void* range, std::uint32_t first, std::span<BoundedObject> objects);

  /// Shrinks the box of each reference to what its object has inside the cell. `firstObject` is the
  /// tree's number of the range's primitive 0.
  void (*clip)(const void* range, std::uint32_t firstObject, const Box3& cell,
               std::span<Reference> references);
};

/// An object in the form the builder takes, or the reason why it cannot be taken.
template <Object O>
[[nodiscard]] BoundedObject boundObject(const O& object) {
  BoundedObject bounded;
  Reference& reference = bounded.reference;
  reference.bounds = objectBounds(object);
  for (const Axis axis : kAxes) {
    if (objectPlanarSide(object, axis) < 0) {
      reference.leftSides |= 1u << static_cast<unsigned>(axis);
    }
  }
  if (reference.bounds == Box3{}) {
    bounded.skipReason = SkipReason::Empty;
  } else if (!isFinite(reference.bounds.lower) || !isFinite(reference.bounds.upper)) {
    bounded.skipReason = SkipReason::NotFinite;
  } else if (reference.bounds.isEmpty()) {
    bounded.skipReason = SkipReason::Empty;
  }
  return bounded;
}

template <class Range>
void clipReferences(const void* range, std::uint32_t firstObject, const Box3& cell,
                    std::span<Reference> references) {
  const Range& shapes = *static_cast<const Range*>(range);
  for (Reference& reference : references) {
    const Box3 clipped = objectClippedBounds(shapes[reference.object - firstObject], cell);
    reference.bounds = intersection(reference.bounds, intersection(clipped, cell));
  }
}

/// The table for a range of objects: anything with `operator[]` that gives an `Object`.
template <class Range>
inline constexpr BoundingTable kBoundingTable = {
    .bound =
        [](const void* range, std::uint32_t first, std::span<BoundedObject> objects) {
          const Range& shapes = *static_cast<const Range*>(range);
          for (BoundedObject& object : objects)
            object = boundObject(shapes[first++]);
        },
    .clip = clipReferences<Range>,
};

}  // namespace planetree::detail
