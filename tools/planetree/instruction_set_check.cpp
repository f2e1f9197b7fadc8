#include "instruction_set_check.hpp"

#include "usage_error.hpp"

#include <planetree/traversal/instruction_set.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

namespace planetree::tool {

void checkRequestedInstructionSet() {
  const std::string_view requested = requestedInstructionSet();
  const std::span<const std::string_view> supported = supportedInstructionSets();
  if (requested.empty() ||
      std::find(supported.begin(), supported.end(), requested) != supported.end())
    return;
  throw UsageError(
      fmt::format("PLANETREE_ISA={}: this machine runs no such instruction set", requested),
      fmt::format("Unset it, or choose one of {}.", fmt::join(supported, ", ")));
}

}  // namespace planetree::tool
