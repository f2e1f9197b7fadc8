# Runs `program`, which was made from the first block of C++ in the README that contains `word`, and
# compares what it prints with the block of text that contains `printed_word`.
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/readme_block.cmake)

readme_block(example cpp "${word}")
string(REGEX REPLACE "[^\n]" "" newlines "${example}")
string(LENGTH "${newlines}" line_count)
if(line_count GREATER 15)
  message(FATAL_ERROR "the README's example has ${line_count} lines, more than fit a first look: 15")
endif()

readme_block(expected text "${printed_word}")
execute_process(COMMAND ${program} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "the example prints\n${printed}but the README says\n${expected}")
endif()
