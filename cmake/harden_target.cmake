# Flags with which a fault that was overlooked ends the program, rather than be of use to who sends it
# a file. docs/building.md says what they cost.
include(CheckCXXCompilerFlag)
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)

# Those that the compiler has for this machine: clang takes the others, too, with a warning.
set(planetree_hardening_flags)
set(planetree_required_flags "${CMAKE_REQUIRED_FLAGS}")
set(CMAKE_REQUIRED_FLAGS "${CMAKE_REQUIRED_FLAGS} -Werror")
foreach(flag fstack-protector-strong fstack-clash-protection fcf-protection
        mbranch-protection=standard)
  string(MAKE_C_IDENTIFIER "planetree_has_${flag}" known)
  check_cxx_compiler_flag(-${flag} ${known})
  if(${known})
    list(APPEND planetree_hardening_flags -${flag})
  endif()
endforeach()
set(CMAKE_REQUIRED_FLAGS "${planetree_required_flags}")

# Checks of sizes in the C library take an optimising compiler, and level 3 a new one: where it has
# less, glibc warns.
set(planetree_fortify_level 2)
if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12) OR
   (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 9))
  set(planetree_fortify_level 3)
endif()

function(planetree_harden target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE ${planetree_hardening_flags}
    $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-U_FORTIFY_SOURCE
                                                  -D_FORTIFY_SOURCE=${planetree_fortify_level}>)
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL "STATIC_LIBRARY")
    target_link_options(${target} PRIVATE -Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
  endif()
endfunction()
