#pragma once

#include <cstdint>

namespace planetree::tool {

/// The formats of tables of rays and of hits.
enum class TableFormat : std::uint8_t {
  Csv,
  Npy,  ///< NumPy's
};

}  // namespace planetree::tool
