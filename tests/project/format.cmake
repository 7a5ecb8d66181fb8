# cmake -D SOURCE=<dir> -D CLANG_FORMAT=<program> [-D FIX=ON] -P format.cmake: checks that our sources have the layout
# of .clang-format. Needs clang-format 14; other versions differ in places.

cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND "${CLANG_FORMAT}" --version OUTPUT_VARIABLE version)
if(NOT version MATCHES "version 14\\.")
  message(STATUS "skipped: ${version}")
  return()
endif()

set(files "")
foreach(folder IN ITEMS model symbolic numeric enclosure library checker proofs_checks app bindings examples tests)
  file(GLOB_RECURSE found "${SOURCE}/${folder}/*.hpp" "${SOURCE}/${folder}/*.cpp")
  list(APPEND files ${found})
endforeach()
set(mode --dry-run --Werror)
if(FIX)
  set(mode -i)
endif()
execute_process(COMMAND "${CLANG_FORMAT}" ${mode} ${files} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "to put this right: cmake --build <build directory> --target format")
endif()
