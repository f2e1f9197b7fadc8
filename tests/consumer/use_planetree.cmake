# Makes a project in `work` that uses planetree in one `way`, builds it and runs its program:
#   installed         find_package, after the build in `planetree_build` was installed and moved
#   installed_shared  the same with shared libraries, which are built here
#   subdirectory      add_subdirectory, the sources standing inside the project
cmake_minimum_required(VERSION 3.22)
include(${planetree}/tests/docs/readme_block.cmake)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# configure_and_build(<source> <build> <option>...)
function(configure_and_build source build)
  run(${CMAKE_COMMAND} -S ${source} -B ${build} -G ${generator} -D CMAKE_BUILD_TYPE=${build_type}
      -D CMAKE_CXX_COMPILER=${compiler} ${ARGN})
  run(${CMAKE_COMMAND} --build ${build} --parallel 2)
endfunction()

# The installed tool finds the program that reads other formats than its own.
function(run_installed_tool)
  if(EXISTS ${work}/moved/bin/planetree)
    file(WRITE ${work}/triangle.raw "0 0 0 1 0 0 0 1 0\n")
    run(${work}/moved/bin/planetree render ${work}/triangle.raw --size 16x16
        -o ${work}/triangle.png)
  endif()
endfunction()

# Installs a build and moves what was installed: nothing may remember the first place.
function(install_and_move build)
  run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/installed)
  file(RENAME ${work}/installed ${work}/moved)
endfunction()

file(REMOVE_RECURSE ${work})
file(COPY ${planetree}/tests/consumer/project DESTINATION ${work})
if(way STREQUAL "subdirectory")
  readme_block(lines cmake "add_subdirectory")
  file(MAKE_DIRECTORY ${work}/project/third_party)
  file(CREATE_LINK ${planetree} ${work}/project/third_party/planetree SYMBOLIC)
else()
  readme_block(lines cmake "find_package")
  if(way STREQUAL "installed_shared")
    configure_and_build(${planetree} ${work}/planetree -D BUILD_SHARED_LIBS=ON
      -D PLANETREE_BUILD_TOOL=OFF -D PLANETREE_BUILD_TESTS=OFF -D PLANETREE_BUILD_EXAMPLES=OFF
      -D PLANETREE_BUILD_BENCHMARKS=OFF)
    install_and_move(${work}/planetree)
  else()
    install_and_move(${planetree_build})
    foreach(file share/man/man1/planetree.1 share/bash-completion/completions/planetree
                 share/zsh/site-functions/_planetree share/fish/vendor_completions.d/planetree.fish)
      if(NOT EXISTS ${work}/moved/${file})
        message(FATAL_ERROR "${file} was not installed")
      endif()
    endforeach()
    run_installed_tool()
  endif()
endif()
file(WRITE ${work}/project/use_planetree.cmake "${lines}")

configure_and_build(${work}/project ${work}/build -D CMAKE_PREFIX_PATH=${work}/moved)
run(${work}/build/app)
