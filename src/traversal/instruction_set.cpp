#include <planetree/traversal/instruction_set.hpp>

#include "isa/kernels.hpp"
#include "support/assert.hpp"

#include <array>
#include <cstddef>
#include <cstdlib>

namespace planetree {

namespace {

struct Names {
  std::array<std::string_view, 8> names = {};
  std::size_t count = 0;

  Names() noexcept {
    for (const detail::Kernels& kernels : detail::supportedKernels()) {
      PLANETREE_ASSERT(count < names.size());
      names[count++] = kernels.name;
    }
  }
};

}  // namespace

std::string_view activeInstructionSet() noexcept {
  return detail::activeKernels().name;
}

std::span<const std::string_view> supportedInstructionSets() noexcept {
  static const Names supported;
  return {supported.names.data(), supported.count};
}

std::string_view requestedInstructionSet() noexcept {
  const char* const name = std::getenv("PLANETREE_ISA");
  return name != nullptr ? name : std::string_view();
}

}  // namespace planetree
