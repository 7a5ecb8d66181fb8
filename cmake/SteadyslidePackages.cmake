# Debian packages of a release build: cpack -G DEB --config build/release/CPackConfig.cmake. Every installed file
# belongs to a component (SteadyslideInstall.cmake), and each component is a package:
#
#   program      steadyslide           the programs, their manual pages, completions, examples
#   library      libsteadyslide<major>  the shared library
#   development  libsteadyslide-dev    headers, archives, CMake's and pkg-config's files
#   python       python3-steadyslide   the module
#   sweep        steadyslide-sweep     sweeps in many processes, and as HDF5
#
# A component that was not built makes no package. dpkg-shlibdeps finds the dependencies on libraries.

find_program(STEADYSLIDE_SHLIBDEPS dpkg-shlibdeps)
find_program(STEADYSLIDE_GZIP gzip)
if(NOT STEADYSLIDE_INSTALL OR NOT TARGET steadyslide OR NOT STEADYSLIDE_SHLIBDEPS OR NOT STEADYSLIDE_GZIP)
  return()
endif()

set(components program development)
set(program_package steadyslide)
set(development_package libsteadyslide-dev)
if(TARGET steadyslide_shared)
  list(APPEND components library)
  set(library_package libsteadyslide${PROJECT_VERSION_MAJOR})
endif()
if(TARGET steadyslide_python)
  list(APPEND components python)
  set(python_package python3-steadyslide)
endif()
if(TARGET steadyslide-sweep)
  list(APPEND components sweep)
  set(sweep_package steadyslide-sweep)
endif()

# Files of every package: copyright and changelog.
execute_process(COMMAND date --utc --rfc-email "--date=${STEADYSLIDE_DATE}" OUTPUT_VARIABLE changed
                OUTPUT_STRIP_TRAILING_WHITESPACE)
set(CPACK_PACKAGE_CONTACT "The steadyslide contributors <contributors@steadyslide.invalid>")
file(WRITE "${PROJECT_BINARY_DIR}/debian/changelog" "steadyslide (${PROJECT_VERSION}) unstable; urgency=medium

  * What changed is in CHANGELOG.md of the sources.

 -- ${CPACK_PACKAGE_CONTACT}  ${changed}
")
execute_process(COMMAND ${STEADYSLIDE_GZIP} -9nf "${PROJECT_BINARY_DIR}/debian/changelog")
foreach(component IN LISTS components)
  set(folder "${CMAKE_INSTALL_DATAROOTDIR}/doc/${${component}_package}")
  install(FILES "${PROJECT_BINARY_DIR}/debian/changelog.gz" "${PROJECT_SOURCE_DIR}/cmake/debian/copyright"
          DESTINATION "${folder}" COMPONENT ${component})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME steadyslide)
set(CPACK_PACKAGE_VENDOR steadyslide)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/library")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(same "(= ${PROJECT_VERSION})")

# Descriptions: one line, then paragraphs. CPack would put the project's own description before each.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(summary "steady sliding contact with discontinuous friction")
set(subject "Steady sliding contact of an indenter on an elastic half-plane whose
friction coefficient changes from place to place: contact zones, pressures
to many digits, exponents of the stress singularities, effective friction.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ${program_package})
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "${summary}
${subject}

The commands solve problem files, draw and prove solutions, and check the
theory.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME "${library_package}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "${summary} (library)
${subject}

This is the shared library of C++ programs.")

set(CPACK_DEBIAN_SWEEP_PACKAGE_NAME steadyslide-sweep)
set(CPACK_DEBIAN_SWEEP_PACKAGE_DEPENDS openmpi-bin)
set(CPACK_DEBIAN_SWEEP_DESCRIPTION "${summary} (sweeps)
${subject}

This solves many problems by several processes, under mpirun, and writes
HDF5.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME ${development_package})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(development_depends libboost-dev libgmp-dev libmpfr-dev libeigen3-dev libfftw3-dev libgsl-dev libflint-arb-dev libcln-dev
    libginac-dev pkgconf)
if(library_package)
  list(PREPEND development_depends "${library_package} ${same}")
endif()
list(JOIN development_depends ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${summary} (C++ headers)
${subject}

Headers, archives, and the files by which CMake and pkg-config find them.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME "${python_package}")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if(python_package)
  # A module is for one minor version of Python.
  find_package(Python 3.11 REQUIRED COMPONENTS Interpreter)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "gnuplot-nox, python3-mpmath")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "${summary} (Python 3)
${subject}

The module solves problems, and gives tractions, stresses and nodal forces
as numpy's arrays.")

include(CPack)
