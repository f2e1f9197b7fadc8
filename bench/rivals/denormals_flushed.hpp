#pragma once

#include <pmmintrin.h>
#include <xmmintrin.h>

namespace planetree::bench {

/// Sets flush-to-zero and denormals-are-zero for this thread, and puts back what there was.
class DenormalsFlushed {
 public:
  DenormalsFlushed() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | static_cast<unsigned>(_MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON));
  }
  ~DenormalsFlushed() { _mm_setcsr(before_); }
  DenormalsFlushed(const DenormalsFlushed&) = delete;
  DenormalsFlushed& operator=(const DenormalsFlushed&) = delete;

 private:
  unsigned before_;
};

}  // namespace planetree::bench
