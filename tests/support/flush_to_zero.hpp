#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace planetree::test {

/// Switches the flushing of denormal numbers to zero on for as long as it lives; some hosts of the
/// library run with it. Does nothing on machines that are neither x86 nor AArch64.
class FlushToZero {
 public:
  explicit FlushToZero([[maybe_unused]] bool on) {
#if defined(__SSE2__)
    constexpr unsigned kFlushZero = _MM_FLUSH_ZERO_ON;
    constexpr unsigned kDenormalsAreZero = _MM_DENORMALS_ZERO_ON;
    before_ = _mm_getcsr();
    if (on)
      _mm_setcsr(before_ | kFlushZero | kDenormalsAreZero);
#elif defined(__aarch64__)
    constexpr std::uint64_t kFlushToZero = 1u << 24u;  // FPCR.FZ, for inputs and results
    before_ = control();
    if (on)
      setControl(before_ | kFlushToZero);
#endif
  }
  ~FlushToZero() {
#if defined(__SSE2__)
    _mm_setcsr(before_);
#elif defined(__aarch64__)
    setControl(before_);
#endif
  }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
#if defined(__aarch64__)
  static std::uint64_t control() {
    std::uint64_t word = 0;
    asm volatile("mrs %0, fpcr" : "=r"(word));
    return word;
  }
  static void setControl(std::uint64_t word) {
    asm volatile("msr fpcr, %0" : : "r"(word));
  }

  std::uint64_t before_ = 0;
#else
  [[maybe_unused]] unsigned before_ = 0;
#endif
};

}  // namespace planetree::test
