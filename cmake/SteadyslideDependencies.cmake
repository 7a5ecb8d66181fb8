# The libraries that steadyslide links. Included by the build and by the installed package's config file, so that both
# look for the same things. GMP, MPFR, CLN and GiNaC ship pkg-config files only.

include(CMakeFindDependencyMacro)

find_dependency(PkgConfig)
find_dependency(Boost 1.74)
find_dependency(GSL)
foreach(library IN ITEMS gmp mpfr cln ginac)
  if(NOT TARGET PkgConfig::${library})
    pkg_check_modules(${library} REQUIRED IMPORTED_TARGET ${library})
  endif()
endforeach()
