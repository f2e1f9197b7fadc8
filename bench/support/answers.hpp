#pragma once

#include <planetree/hit/hit.hpp>

#include <cstdint>
#include <vector>

namespace planetree::bench {

/// What an engine says of the rays of a set. One of the two is filled, by the kind of the rays.
struct Answers {
  std::vector<Hitf> hits;
  std::vector<std::uint8_t> occluded;

  friend bool operator==(const Answers&, const Answers&) = default;
};

}  // namespace planetree::bench
