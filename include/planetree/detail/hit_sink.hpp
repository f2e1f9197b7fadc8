#pragma once

#include <planetree/geometry/rounding.hpp>
#include <planetree/hit/hit.hpp>

#include <limits>

namespace planetree::detail {

/// Takes the hits of objects one by one, for queries that have choices to make about them.
template <class T>
struct HitSink {
  HitSink(T end, bool seesCrossings) noexcept : tMax(end), crossings(seesCrossings) {}

  /// Returns whether the hit is kept. May lower `tMax`.
  virtual bool offer(const Hit<T>& hit) noexcept = 0;

  T tMax;                ///< hits beyond are of no interest
  const bool crossings;  ///< of triangles, by the half-open edge rule

 protected:
  HitSink(const HitSink&) = default;
  HitSink& operator=(const HitSink&) = delete;
  ~HitSink() = default;
};

/// Keeps the first hit that comes.
template <class T>
struct FirstHitSink final : HitSink<T> {
  using HitSink<T>::HitSink;

  bool offer(const Hit<T>& offered) noexcept override {
    hit = offered;
    this->tMax = -std::numeric_limits<T>::infinity();
    return true;
  }

  Hit<T> hit;
};

/// Where to ask an object for its next hit. As `nextUp`, but also right where denormals count as
/// zero: there the number behind zero is the smallest normal one.
template <class T>
[[nodiscard]] T justBehind(T t) noexcept {
  const T next = nextUp(t);
  return next > t ? next : std::numeric_limits<T>::min();
}

}  // namespace planetree::detail
