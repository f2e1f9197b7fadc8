# Builds for AArch64 on another Debian machine and runs what is built under qemu-user: see
# scripts/test_aarch64.sh, which also makes the folder of the libraries that are linked to.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
# Silent about how std::pair is passed, which GCC 10 has changed.
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)

# oneTBB, Highway and GoogleTest for AArch64; the C and C++ libraries come with the compiler.
get_filename_component(planetree_sysroot
                       ${CMAKE_CURRENT_LIST_DIR}/../build/aarch64-sysroot ABSOLUTE)
set(CMAKE_FIND_ROOT_PATH ${planetree_sysroot})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# CMake and CTest start programs through it.
set(CMAKE_CROSSCOMPILING_EMULATOR
    qemu-aarch64 -L /usr/aarch64-linux-gnu
    -E LD_LIBRARY_PATH=${planetree_sysroot}/usr/lib/aarch64-linux-gnu)
