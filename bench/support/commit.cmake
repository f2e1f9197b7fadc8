# Writes the header OUTPUT with the commit of the checkout SOURCE: at every build, since commits do
# not make CMake run again, but only if it has changed, since what includes it is then compiled anew.
find_package(Git QUIET)
set(commit unknown)
if(GIT_FOUND)
  # The checkout may belong to another user than the one who builds.
  set(git ${GIT_EXECUTABLE} -c safe.directory=${SOURCE} -C ${SOURCE})
  execute_process(COMMAND ${git} rev-parse --short=10 HEAD
    OUTPUT_VARIABLE head RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(commit ${head})
    execute_process(COMMAND ${git} diff --quiet HEAD -- include src bench RESULT_VARIABLE is_dirty
      ERROR_QUIET)
    if(is_dirty)
      string(APPEND commit -dirty)
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once

namespace planetree::bench {

inline constexpr const char* kCommit = \"${commit}\";

}  // namespace planetree::bench
")
