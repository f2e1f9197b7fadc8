#pragma once

#include <cstdint>

namespace planetree {

/// Choices for one query.
struct QueryOptions {
  /// Only geometries whose own mask shares a bit with this one are seen.
  std::uint32_t mask = 0xFFFF'FFFFu;
};

}  // namespace planetree
