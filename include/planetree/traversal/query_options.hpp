#pragma once

#include <planetree/hit/hit.hpp>

#include <cstdint>

namespace planetree {

/// One object of a tree, named as in `Hit`. A default-made one names nothing.
struct PrimitiveId {
  std::uint32_t geometry = kNoId;
  std::uint32_t primitive = kNoId;

  friend constexpr bool operator==(const PrimitiveId&, const PrimitiveId&) noexcept = default;
};

/// Whether a query goes on without a hit that it found: a plain function, and a pointer that is
/// handed to it. A default-made filter accepts every hit and costs nothing.
///
/// The function is shown the whole hit (t, u, v, normal, ids and part). It must give the same
/// answer for the same hit, and if queries are made from several threads it is called from them
/// all. In which order hits are shown is not said: they need not come front to back, one hit may be
/// shown more than once, and hits that cannot be the answer may not be shown at all.
class HitFilter {
 public:
  HitFilter() = default;
  /// `function` must not be null. A filter is for one precision: to rays of the other it accepts
  /// nothing.
  HitFilter(bool (*function)(const Hitf& hit, void* context) noexcept,
            void* context = nullptr) noexcept
      : acceptsFloat_(function), context_(context) {}
  HitFilter(bool (*function)(const Hitd& hit, void* context) noexcept,
            void* context = nullptr) noexcept
      : acceptsDouble_(function), context_(context) {}

  [[nodiscard]] bool acceptsAll() const noexcept {
    return acceptsFloat_ == nullptr && acceptsDouble_ == nullptr;
  }
  [[nodiscard]] bool accepts(const Hitf& hit) const noexcept {
    return acceptsAll() || (acceptsFloat_ != nullptr && acceptsFloat_(hit, context_));
  }
  [[nodiscard]] bool accepts(const Hitd& hit) const noexcept {
    return acceptsAll() || (acceptsDouble_ != nullptr && acceptsDouble_(hit, context_));
  }

 private:
  bool (*acceptsFloat_)(const Hitf&, void*) noexcept = nullptr;
  bool (*acceptsDouble_)(const Hitd&, void*) noexcept = nullptr;
  void* context_ = nullptr;
};

/// Choices for one query. Every query honours all of them, and those that are off cost nothing.
///
/// They work together as if in this order: `mask` and `skip` say which objects there are;
/// `crossings` says where the ray hits a triangle; of these hits `cullsBackFaces` takes some away;
/// the `filter` is shown what is left in the ray's interval. A hit that is rejected is as if it
/// were not there: it hides nothing behind it, and the search goes on with the next hit of the same
/// object, then with all others. The query answers from what remains: the nearest, whether there is
/// one, or all.
struct QueryOptions {
  /// Only geometries whose own mask shares a bit with this one are seen.
  std::uint32_t mask = 0xFFFF'FFFFu;

  /// Leaves out hits from behind: those where `dot(hit.normal, ray.direction)` is not negative. A
  /// triangle without area faces every ray. Within rounding of edge-on either answer is possible;
  /// together with `crossings` it is the one of the exact rule told there.
  bool cullsBackFaces = false;

  /// Counts where the ray passes through a surface, instead of what it touches. Usually a ray
  /// through an edge or a vertex hits every triangle there, so that it never slips through; with
  /// this, of the triangles around it just those that a ray an infinitesimal step aside would hit,
  /// the step being the same for all triangles and rays of one direction (docs/numerics.md). So
  ///  - of two triangles with a common edge, a ray through the edge hits one, if it passes from
  ///    side to side; if it merely touches a ridge, both or none;
  ///  - over a closed mesh the hits from the front and those from behind are equally many on any
  ///    ray from outside to outside. On a ray from a point to infinity, hits from behind less hits
  ///    from the front is how often the mesh winds around the point: 0 outside, 1 inside. Corners
  ///    must be the same bits in all triangles that share them, and the point not within rounding
  ///    of the surface;
  ///  - the side is told by the sign of `dot(hit.normal, ray.direction)`, never zero: the normal of
  ///    a triangle so nearly edge-on that rounding hides its side is replaced by one along the ray.
  /// Everything else of a hit is as usual. For other shapes it changes nothing, unless they have an
  /// `intersectCrossing` of their own (object.hpp). Not for rays that must not leak: a ray that
  /// touches the outline of a mesh may pass.
  bool crossings = false;

  /// An object that is not seen, such as the one that the ray starts on.
  PrimitiveId skip = {};

  HitFilter filter = {};
};

}  // namespace planetree
