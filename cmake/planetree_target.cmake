# Settings shared by every target of the project.

# A static library shows its symbols to the program it becomes a part of, and to nobody beyond. A
# shared one exports all of them, so that the headers need no export macros; promising that nobody
# replaces a function at run time lets the compiler inline as it does in the static one.
function(planetree_visibility target)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  else()
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden
                                               VISIBILITY_INLINES_HIDDEN ON)
  endif()
endfunction()

function(planetree_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE
      -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wsign-conversion -Wold-style-cast
      -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align
      # Contraction to FMA makes shared edges leak: see docs/numerics.md.
      -ffp-contract=off
      $<$<BOOL:${PLANETREE_WARNINGS_AS_ERRORS}>:-Werror>)
  planetree_visibility(${target})
  # Sanitizers have checks of their own, which these would hide.
  if(PLANETREE_HARDENING AND NOT PLANETREE_SANITIZE)
    planetree_harden(${target})
  endif()
  if(PLANETREE_ASSERTIONS)
    target_compile_definitions(${target} PRIVATE PLANETREE_ASSERTIONS _GLIBCXX_ASSERTIONS)
  endif()
  if(PLANETREE_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=${PLANETREE_SANITIZE}
                                            -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${PLANETREE_SANITIZE})
  endif()
endfunction()
