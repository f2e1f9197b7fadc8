#pragma once

#include <planetree/detail/hit_sink.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/traversal/query_options.hpp>

#include <cstddef>
#include <limits>
#include <span>

namespace planetree::detail {

/// Whether the options ask for more than a mask: then hits are offered to a sink one by one. Every
/// query asks this, hence no branches.
[[nodiscard]] inline bool hasChoices(const QueryOptions& options) noexcept {
  const bool skips = options.skip.geometry != kNoId;
  const bool filters = !options.filter.acceptsAll();
  const int count = static_cast<int>(options.cullsBackFaces) + static_cast<int>(options.crossings) +
                    static_cast<int>(skips) + static_cast<int>(filters);
  return count != 0;
}

/// Which of the hits that the ray finds count. The mask is not asked here, but once for each run of
/// objects.
template <class T>
struct HitChoices {
  const QueryOptions& options;
  Vec3<T> direction;  ///< of the ray
  Hit<T> after = {.t = -std::numeric_limits<T>::infinity(), .geometry = 0, .primitive = 0};

  /// The filter comes last, so that it is shown only what the rest accepts.
  [[nodiscard]] bool accepts(const Hit<T>& hit) const noexcept {
    if (PrimitiveId{hit.geometry, hit.primitive} == options.skip)
      return false;
    if (options.cullsBackFaces && !(dot(hit.normal, direction) < T(0)))
      return false;
    return isBefore(after, hit) && options.filter.accepts(hit);
  }
};

/// Keeps the nearest hit.
template <class T>
class NearestSink final : public HitSink<T> {
 public:
  NearestSink(const HitChoices<T>& choices, T end, Hit<T>& best) noexcept
      : HitSink<T>(end, choices.options.crossings), choices_(choices), best_(best) {}

  bool offer(const Hit<T>& hit) noexcept override {
    if (!isBefore(hit, best_) || !choices_.accepts(hit))
      return false;
    best_ = hit;
    this->tMax = hit.t;
    return true;
  }

 private:
  const HitChoices<T>& choices_;
  Hit<T>& best_;
};

/// Is content with the first hit that counts.
template <class T>
class AnySink final : public HitSink<T> {
 public:
  AnySink(const HitChoices<T>& choices, T end) noexcept
      : HitSink<T>(end, choices.options.crossings), choices_(choices) {}

  bool offer(const Hit<T>& hit) noexcept override {
    if (!choices_.accepts(hit))
      return false;
    this->tMax = -std::numeric_limits<T>::infinity();
    return true;
  }

 private:
  const HitChoices<T>& choices_;
};

/// Keeps the first hits in the order of `isBefore`, each once, as many as there is room for.
template <class T>
class ListSink final : public HitSink<T> {
 public:
  ListSink(const HitChoices<T>& choices, T end, std::span<Hit<T>> room) noexcept
      : HitSink<T>(end, choices.options.crossings), choices_(choices), room_(room) {}

  /// Inserts from the back: hits come nearly in order.
  bool offer(const Hit<T>& hit) noexcept override {
    std::size_t at = count_;
    while (at > 0 && isBefore(hit, room_[at - 1]))
      --at;
    // An object is met again in every cell that it reaches into.
    const bool isKnown = at > 0 && !isBefore(room_[at - 1], hit);
    if (isKnown || (hasMore_ && at == room_.size()) || !choices_.accepts(hit))
      return false;
    hasMore_ |= count_ == room_.size();
    if (at < room_.size()) {
      count_ += count_ < room_.size() ? 1u : 0u;
      for (std::size_t i = count_ - 1; i > at; --i)
        room_[i] = room_[i - 1];
      room_[at] = hit;
    }
    // Only now: until it is known that there are more, the hits beyond matter.
    if (hasMore_)
      this->tMax = count_ > 0 ? room_[count_ - 1].t : -std::numeric_limits<T>::infinity();
    return true;
  }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  [[nodiscard]] bool hasMore() const noexcept { return hasMore_; }

 private:
  const HitChoices<T>& choices_;
  std::span<Hit<T>> room_;
  std::size_t count_ = 0;
  bool hasMore_ = false;
};

}  // namespace planetree::detail
