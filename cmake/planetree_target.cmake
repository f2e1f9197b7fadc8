# Settings shared by every target of the project.

function(planetree_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden
                                             VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE
      -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wsign-conversion -Wold-style-cast
      -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align
      # Contraction to FMA makes shared edges leak: see docs/numerics.md.
      -ffp-contract=off
      $<$<BOOL:${PLANETREE_WARNINGS_AS_ERRORS}>:-Werror>)
  if(PLANETREE_ASSERTIONS)
    target_compile_definitions(${target} PRIVATE PLANETREE_ASSERTIONS _GLIBCXX_ASSERTIONS)
  endif()
  if(PLANETREE_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=${PLANETREE_SANITIZE}
                                            -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${PLANETREE_SANITIZE})
  endif()
endfunction()
