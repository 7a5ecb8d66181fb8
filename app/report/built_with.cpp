// The compiler and the libraries of this build, as text.

#include <arb.h>
#include <cln/version.h>
#include <fmt/core.h>
#include <ginac/version.h>
#include <gmp.h>
#include <gsl/gsl_version.h>
#include <mpfr.h>

#include <boost/version.hpp>

#include "app/report/sections.hpp"

namespace steadyslide::app {

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

std::string libraries() {
  return fmt::format("GMP {}.{}.{}, MPFR {}, Arb {}, CLN {}.{}.{}, GiNaC {}.{}.{}, GSL {}, Boost {}.{}",
                     __GNU_MP_VERSION, __GNU_MP_VERSION_MINOR, __GNU_MP_VERSION_PATCHLEVEL, MPFR_VERSION_STRING,
                     ARB_VERSION, CL_VERSION_MAJOR, CL_VERSION_MINOR, CL_VERSION_PATCHLEVEL, GINACLIB_MAJOR_VERSION,
                     GINACLIB_MINOR_VERSION, GINACLIB_MICRO_VERSION, GSL_VERSION, BOOST_VERSION / 100000,
                     BOOST_VERSION / 100 % 1000);
}

}  // namespace steadyslide::app
