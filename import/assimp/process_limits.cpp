#include "import/assimp/process_limits.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__)
#define PLANETREE_HAS_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PLANETREE_HAS_ADDRESS_SANITIZER 1
#endif
#endif

#ifdef PLANETREE_HAS_ADDRESS_SANITIZER
// The shadow memory of the sanitizer is larger than any limit of the address space. It has limits
// of its own, which it takes from here; the names are its own, too.
extern "C" const char* __asan_default_options();  // NOLINT
extern "C" const char* __asan_default_options() {
  return "hard_rss_limit_mb=4096:max_allocation_size_mb=2048:allocator_may_return_null=1:"
         "detect_leaks=0";
}
#endif

namespace planetree::importing {
namespace {

/// A limit that is lower already stays.
void setLimit(decltype(RLIMIT_AS) resource, rlim_t most) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0)
    std::_Exit(EXIT_FAILURE);
  limit.rlim_max = std::min(limit.rlim_max, most);
  limit.rlim_cur = std::min(limit.rlim_cur, most);
  if (::setrlimit(resource, &limit) != 0)
    std::_Exit(EXIT_FAILURE);
}

}  // namespace

int takeStandardOutput() {
  const int output = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (output < 0 || nowhere < 0 || ::dup2(nowhere, STDOUT_FILENO) < 0)
    std::_Exit(EXIT_FAILURE);
  return output;
}

void limitProcess(std::uint64_t memory, long parent) {
  setLimit(RLIMIT_CORE, 0);
  setLimit(RLIMIT_FSIZE, 0);
#ifndef PLANETREE_HAS_ADDRESS_SANITIZER
  setLimit(RLIMIT_AS, memory);
#else
  static_cast<void>(memory);
#endif
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The parent may have gone before that.
  if (::getppid() != parent)
    std::_Exit(EXIT_FAILURE);
}

}  // namespace planetree::importing
