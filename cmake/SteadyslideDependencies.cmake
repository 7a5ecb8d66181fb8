# The libraries that steadyslide's own libraries link. Included by the build and by the installed package's config file,
# so that both look for the same things. GMP, MPFR, FFTW, CLN and GiNaC ship pkg-config files only, Arb nothing.

# find_package() REQUIRED in a config file would make an optional find_package(steadyslide) fatal, and find_dependency()
# outside a config file leaves in silence.
if(CMAKE_FIND_PACKAGE_NAME STREQUAL "steadyslide")
  include(CMakeFindDependencyMacro)
  find_dependency(PkgConfig)
  find_dependency(Boost 1.74)
  find_dependency(GSL)
  find_dependency(Eigen3 3.4)
else()
  # A project that takes steadyslide by add_subdirectory links these targets from a directory above this one.
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)
  find_package(PkgConfig REQUIRED)
  find_package(Boost 1.74 REQUIRED)
  find_package(GSL REQUIRED)
  find_package(Eigen3 3.4 REQUIRED)
endif()

foreach(library IN ITEMS gmp mpfr fftw3 cln ginac)
  if(NOT TARGET PkgConfig::${library})
    pkg_check_modules(${library} IMPORTED_TARGET GLOBAL ${library})
  endif()
  if(NOT TARGET PkgConfig::${library})
    set(steadyslide_NOT_FOUND_MESSAGE "pkg-config does not know ${library}.")
    if(NOT CMAKE_FIND_PACKAGE_NAME STREQUAL "steadyslide")
      message(FATAL_ERROR "${steadyslide_NOT_FOUND_MESSAGE}")
    endif()
    set(steadyslide_FOUND FALSE)
    return()
  endif()
endforeach()

# FindArb.cmake stands beside this file, here and in the installed package.
list(PREPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
if(CMAKE_FIND_PACKAGE_NAME STREQUAL "steadyslide")
  find_dependency(Arb)
else()
  find_package(Arb REQUIRED)
endif()
list(POP_FRONT CMAKE_MODULE_PATH)
