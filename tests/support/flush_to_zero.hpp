#pragma once

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace planetree::test {

/// Switches the flushing of denormal numbers to zero on for as long as it lives; some hosts of the
/// library run with it. Does nothing on machines without SSE.
class FlushToZero {
 public:
  explicit FlushToZero([[maybe_unused]] bool on) {
#if defined(__SSE2__)
    constexpr unsigned kFlushZero = _MM_FLUSH_ZERO_ON;
    constexpr unsigned kDenormalsAreZero = _MM_DENORMALS_ZERO_ON;
    before_ = _mm_getcsr();
    if (on)
      _mm_setcsr(before_ | kFlushZero | kDenormalsAreZero);
#endif
  }
  ~FlushToZero() {
#if defined(__SSE2__)
    _mm_setcsr(before_);
#endif
  }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  [[maybe_unused]] unsigned before_ = 0;
};

}  // namespace planetree::test
