#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace planetree {

/// Checks the form of a tree from whatever source: the bounds are finite, or the default-made box;
/// every offset stays inside the arrays; every node is reached exactly once; planes are finite and
/// lie in their cells; no path is longer than `kMaxTreeDepth`; the leaves share out all references
/// in their order, and those of each leaf rise and stay below `objectCount`. Returns nothing if all
/// holds, else the first thing that does not, in words. Linear in nodes and references; safe for
/// arbitrary bytes. Throws nothing but std::bad_alloc.
[[nodiscard]] std::optional<std::string> validateTree(std::span<const Node> nodes,
                                                      std::span<const std::uint32_t> references,
                                                      const Box3& bounds,
                                                      std::uint64_t objectCount);

}  // namespace planetree
