# steadyslide_sources(<variable>)
# steadyslide_embed(<variable> <namespace> <name> <files>...)
# steadyslide_library(<layer> SOURCES ... [PUBLIC libs...] [PRIVATE libs...])
# steadyslide_executable(<name> SOURCES ... LIBRARIES ...)
# steadyslide_compile_quickly(<target>)
# steadyslide_precompile(<target> HEADERS ...), steadyslide_precompile(<target> LIKE <other target>)
# Every target of the project is made here, so that warnings and sanitizers are said once and reach no consumer.

include(GNUInstallDirs)

function(steadyslide_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Compiles several sources in one translation unit: their common template instances are compiled once, which halves
  # the time. Names in unnamed namespaces then meet those of the target's other sources, so each name must be unique
  # within a target.
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${STEADYSLIDE_UNITY_BUILD})
  if(STEADYSLIDE_WARNINGS)
    # -Wrestrict of g++ 12 fires on every std::string assignment (GCC bug 105651).
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
    if(STEADYSLIDE_WARNINGS_AS_ERRORS)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
  # g++ collects garbage whenever its heap has grown by 128 MB, and finds little. Without that, a file that includes
  # Boost.Multiprecision takes a fifth less time.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE "SHELL:--param ggc-min-heapsize=524288")
  endif()
  if(STEADYSLIDE_SANITIZE)
    # With a sanitizer g++ 12 warns of an uninitialized state in libstdc++'s <regex>.
    target_compile_options(${target} PRIVATE -fsanitize=${STEADYSLIDE_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=undefined
                                             $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(${target} PUBLIC -fsanitize=${STEADYSLIDE_SANITIZE})
  endif()
endfunction()

# For code that spends its time in the code that it calls: the numeric layer's loops, GMP, Arb, GiNaC.
function(steadyslide_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Reading Boost.Multiprecision alone takes two seconds a file. Headers of other projects are precompiled, never our own.
# LIKE uses the headers that another target has precompiled; both targets need the same compiler options. clang-tidy reads
# every file by itself: it finds a header that a file uses and does not include.
function(steadyslide_precompile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LIKE" "HEADERS")
  if(STEADYSLIDE_PRECOMPILED_HEADERS AND arg_LIKE)
    target_precompile_headers(${target} REUSE_FROM ${arg_LIKE})
    # A program is compiled with -fPIE, precompiled headers of a library with -fPIC. g++ refuses the mixture.
    get_target_property(type ${target} TYPE)
    if(type STREQUAL EXECUTABLE AND CMAKE_POSITION_INDEPENDENT_CODE)
      target_compile_options(${target} PRIVATE -fPIC)
    endif()
  elseif(STEADYSLIDE_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${arg_HEADERS})
  endif()
  if(STEADYSLIDE_PRECOMPILED_HEADERS AND STEADYSLIDE_WARNINGS AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # libstdc++ silences these three warnings inside <string> with pragmas. g++ 12 forgets the pragmas when the header
    # is precompiled.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()

# All sources below the current folder except programs (main.cpp, *_main.cpp). A new file needs no entry in a list.
function(steadyslide_sources variable)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "*.cpp")
  list(FILTER sources EXCLUDE REGEX "(^|/|_)main\\.cpp$")
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# Adds a source to the list in `variable`: it has the contents of the files, one after the other, as the text
# namespace::name.
function(steadyslide_embed variable namespace name)
  set(files "")
  foreach(file IN LISTS ARGN)
    get_filename_component(file "${file}" ABSOLUTE)
    list(APPEND files "${file}")
  endforeach()
  set(output "${CMAKE_CURRENT_BINARY_DIR}/embedded_${name}.cpp")
  set(script "${PROJECT_SOURCE_DIR}/cmake/embed.cmake")
  add_custom_command(OUTPUT "${output}"
    COMMAND ${CMAKE_COMMAND} -D "INPUT=${files}" -D NAMESPACE=${namespace} -D NAME=${name} -D "OUTPUT=${output}"
            -P "${script}"
    DEPENDS ${files} "${script}" VERBATIM)
  set(${variable} ${${variable}} "${output}" PARENT_SCOPE)
endfunction()

function(steadyslide_library layer)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;PUBLIC;PRIVATE")
  set(target steadyslide_${layer})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(steadyslide::${layer} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${layer})
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/steadyslide>")
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  steadyslide_compile_options(${target})
endfunction()

function(steadyslide_executable target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE ${arg_LIBRARIES})
  steadyslide_compile_options(${target})
endfunction()
