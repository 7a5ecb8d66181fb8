# The double-only part (STEADYSLIDE_DOUBLE_ONLY). It uses none of GMP, MPFR, Arb, FFTW and GSL. Emscripten compiles it for
# the Explorer, and the ordinary compiler for the tests (tests/explorer). It contains model/, numeric/ and the reader of
# problem files, except the files below. The files in double_only/ replace them:
#
#   mpfr_real, elementary         numbers with 50 and 100 digits; pi, and doubles of rationals, without MPFR
#   double_exponential_grid       residuals above double
#   gsl_quadrature                a third route, for tests: refused
#   fourier                       the same transforms by Eigen's FFT; no solution here is large enough to need one
#   rear_share                    needed by other commands than `solve`; Arb
#   power_product_avx*            other processors' instructions
#   friction_table, profile_trace, symbol_table   files beside a problem: refused (tables.cpp)
set(double_only_folder "${CMAKE_CURRENT_LIST_DIR}")

# steadyslide_double_only(<library>): makes the library of all layers; the caller sets the options of its sources.
function(steadyslide_double_only name)
  get_filename_component(root "${double_only_folder}/../.." ABSOLUTE)
  set(only_model "${root}")
  set(not_model "^$")
  set(only_numeric "${root}")
  set(not_numeric "numeric/(number/mpfr_real|number/elementary|number/power_product_avx|quadrature/double_exponential_grid|\
quadrature/gsl_quadrature|variational/fourier|flat_punch/rear_share)")
  set(only_library "library/(problem_file/|text/one_line|text/utf8)")
  set(not_library "library/problem_file/(friction_table|profile_trace|smoothing|surface_files|symbol_table|table_reader)")

  # Only the headers of Debian's packages; never /usr/include itself, which has the C library of another machine.
  set(headers "${CMAKE_CURRENT_BINARY_DIR}/include")
  file(MAKE_DIRECTORY "${headers}")
  foreach(package IN ITEMS boost fmt toml++)
    if(NOT EXISTS "/usr/include/${package}")
      message(FATAL_ERROR "/usr/include/${package} is missing: its -dev package is in cmake/packages.txt.")
    endif()
    file(CREATE_LINK "/usr/include/${package}" "${headers}/${package}" SYMBOLIC)
  endforeach()

  # One target for each layer, so that the same sources are compiled together as elsewhere (STEADYSLIDE_UNITY_BUILD).
  add_library(${name} INTERFACE)
  foreach(layer IN ITEMS model numeric library)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${root}/${layer}/*.cpp")
    list(FILTER sources INCLUDE REGEX "${only_${layer}}")
    list(FILTER sources EXCLUDE REGEX "${not_${layer}}")
    file(GLOB instead CONFIGURE_DEPENDS "${double_only_folder}/double_only/${layer}/*.cpp")
    add_library(${name}_${layer} STATIC ${sources} ${instead})
    steadyslide_compile_options(${name}_${layer})
    target_include_directories(${name}_${layer} PUBLIC "${root}")
    target_include_directories(${name}_${layer} SYSTEM PUBLIC "${headers}" /usr/include/eigen3)
    target_compile_definitions(${name}_${layer} PUBLIC STEADYSLIDE_DOUBLE_ONLY FMT_HEADER_ONLY EIGEN_NO_IO)
    target_link_libraries(${name} INTERFACE ${name}_${layer})
  endforeach()
  set(one_by_one "${root}/numeric/number/power_product.cpp")
  # Some classes have their members in several sources. clang needs to compile these sources one by one.
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    file(GLOB parts "${root}/numeric/riemann_hilbert/riemann_hilbert*.cpp" "${root}/numeric/closed_form/closed_form*.cpp")
    list(APPEND one_by_one ${parts})
  endif()
  set_source_files_properties(${one_by_one} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
