# cmake -D KIND=installed|subdirectory -D SOURCE= -D BINARY= -D WORK= -D GENERATOR= -D CXX= [-D SANITIZE=]
#       -P consumer_test.cmake: a project outside the checkout configures, builds and runs with steadyslide.

cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${WORK}")
file(COPY "${SOURCE}/tests/project/consumer" DESTINATION "${WORK}")

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nfailed (${status}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(options -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${CXX}" -DCMAKE_BUILD_TYPE=Release
            -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
set(programs edge_powers)
if(KIND STREQUAL "installed")
  run("${CMAKE_COMMAND}" --install "${BINARY}" --prefix "${WORK}/prefix with a space")
  list(APPEND options "-DCMAKE_PREFIX_PATH=${WORK}/prefix with a space" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
  if(SANITIZE)
    # The installed archives are instrumented, and so must be the templates that both sides instantiate.
    list(APPEND options "-DCMAKE_CXX_FLAGS=-fsanitize=${SANITIZE}")
  endif()
  list(APPEND programs flat_punch facade)
else()
  # The programs compiled here run only for a moment. Compiling sources together is the quickest; the test
  # project_single_files compiles each by itself.
  list(APPEND options "-DSTEADYSLIDE_SOURCES=${SOURCE}" -DCMAKE_BUILD_TYPE=Debug -DSTEADYSLIDE_UNITY_BUILD=ON)
endif()

run("${CMAKE_COMMAND}" -S "${WORK}/consumer" -B "${WORK}/build" ${options})
run("${CMAKE_COMMAND}" --build "${WORK}/build" --target ${programs})

# Warnings are the consumer's choice: our options change neither its files nor, in its build, our own files.
if(KIND STREQUAL "subdirectory")
  file(READ "${WORK}/build/compile_commands.json" commands)
  if(commands MATCHES " -W[a-z]+")
    message(FATAL_ERROR "a warning option reached the consumer's build: ${CMAKE_MATCH_0}")
  endif()
endif()

set(expected_edge_powers "-1/2 - arctan(3/35)/pi\n-1/2 + arctan(3/35)/pi\n")
set(expected_flat_punch "load 1\n")
set(expected_facade "effective friction 0.2\nhalf_space: missing; the table is required; absent\n")
foreach(program IN LISTS programs)
  run("${WORK}/build/${program}")
  if(NOT output STREQUAL "${expected_${program}}")
    message(FATAL_ERROR "${program} printed:\n${output}\nexpected:\n${expected_${program}}")
  endif()
endforeach()

if(KIND STREQUAL "installed")
  run("${WORK}/prefix with a space/bin/steadyslide" --version)

  # Without CMake: pkg-config describes the tree at any place.
  file(GLOB_RECURSE pc "${WORK}/prefix with a space/*/steadyslide.pc")
  cmake_path(GET pc PARENT_PATH pc)
  file(WRITE "${WORK}/compile" "set -e
export PKG_CONFIG_PATH=\"${pc}\"
eval \"'${CXX}' -std=c++20 '${WORK}/consumer/facade.cpp' $(pkg-config --cflags --libs steadyslide) -o '${WORK}/facade'\"
LD_LIBRARY_PATH=\"${pc}/..\" \"${WORK}/facade\"
")
  if(NOT SANITIZE)
    run(sh "${WORK}/compile")
    if(NOT output STREQUAL expected_facade)
      message(FATAL_ERROR "with pkg-config:\n${output}")
    endif()
  endif()

  set(python "${WORK}/prefix with a space/lib/python3/dist-packages")
  if(EXISTS "${python}/steadyslide")
    run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${python}" PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c
        "import steadyslide as ss\nprint(ss.Problem(load=1, poisson=0.3, friction=[0.2], profile=0).solve().solved)")
    if(NOT output STREQUAL "True\n")
      message(FATAL_ERROR "the installed Python module says:\n${output}")
    endif()
  endif()
endif()
