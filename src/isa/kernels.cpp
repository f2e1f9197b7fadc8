#include "isa/kernels.hpp"

// Of what Highway can compile for, the sets that differ enough to matter.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
// All others on every machine, plain code too where the compiler could take something better for
// granted.
#define HWY_COMPILE_ALL_ATTAINABLE

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "isa/kernels.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h, which compiles what follows once for each set.
#include <hwy/highway.h>

#include "isa/count_ends-inl.hpp"
#include "isa/packet_traversal-inl.hpp"
#include "isa/wide_traversal-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

constexpr Kernels kernelsNamed(std::string_view name) {
  return {.name = name,
          .findNearest = search<Nearest>,
          .findAny = search<Any>,
          .handOverForNearest = search<NearestHandedOver>,
          .handOverForAny = search<AnyHandedOver>,
          .countNearest = count<NearestCounted>,
          .countAny = count<AnyCounted>,
          .findNearestOfPackets = searchPackets<Nearest>,
          .findAnyOfPackets = searchPackets<Any>,
          .countEnds = countEnds};
}

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <planetree/traversal/instruction_set.hpp>

#include <array>

namespace planetree::detail {
namespace {

struct Target {
  std::int64_t bit;
  Kernels kernels;
};

constexpr std::array kTargets = {
#if HWY_TARGETS & HWY_AVX3
    Target{HWY_AVX3, N_AVX3::kernelsNamed("avx512")},
#endif
#if HWY_TARGETS & HWY_AVX2
    Target{HWY_AVX2, N_AVX2::kernelsNamed("avx2")},
#endif
#if HWY_TARGETS & HWY_SSE4
    Target{HWY_SSE4, N_SSE4::kernelsNamed("sse4")},
#endif
#if HWY_TARGETS & HWY_NEON
    Target{HWY_NEON, N_NEON::kernelsNamed("neon")},
#endif
// Plain code: which name it has depends on the compiler.
#if HWY_TARGETS & HWY_EMU128
    Target{HWY_EMU128, N_EMU128::kernelsNamed("scalar")},
#elif HWY_TARGETS & HWY_SCALAR
    Target{HWY_SCALAR, N_SCALAR::kernelsNamed("scalar")},
#endif
};

struct SupportedKernels {
  std::array<Kernels, kTargets.size()> kernels = {};
  std::size_t count = 0;

  SupportedKernels() noexcept {
    const std::int64_t supported = hwy::SupportedTargets();
    for (const Target& target : kTargets) {
      // Highway does not name what runs everywhere.
      const bool isPlain = (target.bit & (HWY_EMU128 | HWY_SCALAR)) != 0;
      if (isPlain || (supported & target.bit) != 0 || target.bit == HWY_STATIC_TARGET)
        kernels[count++] = target.kernels;
    }
  }
};

}  // namespace

std::span<const Kernels> supportedKernels() noexcept {
  static const SupportedKernels supported;
  return {supported.kernels.data(), supported.count};
}

const Kernels& chooseKernels() noexcept {
  const std::string_view wanted = requestedInstructionSet();
  for (const Kernels& kernels : supportedKernels()) {
    if (kernels.name == wanted)
      return kernels;
  }
  return supportedKernels().front();
}

}  // namespace planetree::detail
#endif  // HWY_ONCE
