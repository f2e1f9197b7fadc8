#include "instruments/print_page.hpp"

#include <planetree/error.hpp>

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace planetree::tool {

void printPage(const std::string& page) {
  const bool isPrinted =
      std::fwrite(page.data(), 1, page.size(), stdout) == page.size() && std::fflush(stdout) == 0;
  if (isPrinted || errno == EPIPE)
    return;
  throw Error(ErrorCode::FileNotWritable,
              fmt::format("cannot be written ({})", std::generic_category().message(errno)),
              "Free some space there, or redirect it elsewhere.", {.file = "standard output"});
}

}  // namespace planetree::tool
