#pragma once

/// PLANETREE_ASSERT(condition) stops the program where the library breaks its own promise. It is
/// checked in builds with the option PLANETREE_ASSERTIONS only; input is never judged by it.
#ifdef PLANETREE_ASSERTIONS
#include <cstdio>
#include <cstdlib>
#define PLANETREE_ASSERT(condition)                                                            \
  ((condition)                                                                                 \
       ? static_cast<void>(0)                                                                  \
       : (std::fprintf(stderr, "%s:%d: broken promise: %s\n", __FILE__, __LINE__, #condition), \
          std::abort()))
#else
#define PLANETREE_ASSERT(condition) static_cast<void>(0)
#endif
