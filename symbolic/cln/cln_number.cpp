#include "symbolic/cln/cln_number.hpp"

#include <cln/integer_io.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace steadyslide::symbolic {
namespace {

cln::cl_I integer_to_cln(const Integer& value) { return cln::cl_I(value.str().c_str()); }

Integer integer_from_cln(const cln::cl_I& value) {
  std::ostringstream text;
  text << value;
  return Integer(text.str());
}

/// Sums the terms in the given order. Sets `largest` to the binary exponent of the largest term.
cln::cl_F sum_of_terms(const Exponent& exponent, cln::float_format_t format, sintE& largest) {
  const cln::cl_F pi = cln::pi(format);
  cln::cl_F sum = to_cln(exponent.offset(), format);
  largest = cln::zerop(sum) ? -1 : cln::float_exponent(sum);
  for (const Exponent::Angle& angle : exponent.angles()) {
    const cln::cl_F slope = to_cln(angle.slope, format);
    const cln::cl_F term = cln::cl_float(cln::cl_I(angle.times), format) * (cln::the<cln::cl_F>(cln::atan(slope)) / pi);
    largest = std::max(largest, cln::float_exponent(term));
    sum = sum + term;
  }
  return sum;
}

}  // namespace

cln::float_format_t cln_format(int digits) { return cln::float_format(static_cast<uintE>(digits)); }

cln::cl_F power_of_ten(int exponent, cln::float_format_t format) {
  return cln::cl_float(cln::expt(cln::cl_RA(10), exponent), format);
}

cln::cl_RA to_cln(const Rational& value) {
  return integer_to_cln(boost::multiprecision::numerator(value)) /
         integer_to_cln(boost::multiprecision::denominator(value));
}

cln::cl_F to_cln(const Rational& value, cln::float_format_t format) { return cln::cl_float(to_cln(value), format); }

Rational from_cln(const cln::cl_F& value) {
  const cln::cl_RA exact = cln::rational(value);
  return Rational(integer_from_cln(cln::numerator(exact)), integer_from_cln(cln::denominator(exact)));
}

cln::cl_F to_cln(const Exponent& exponent, int digits) {
  const int wanted = digits + cln_guard_digits;
  if (exponent.sign() == 0) return cln::cl_float(cln::cl_I(0), cln_format(wanted));
  // The doubling of the digits ends, because the exact value is not zero.
  for (int carried = wanted;; carried *= 2) {
    sintE largest = 0;
    const cln::cl_F sum = sum_of_terms(exponent, cln_format(carried), largest);
    if (cln::zerop(sum)) continue;
    const auto lost_digits = static_cast<double>(largest - cln::float_exponent(sum)) * 0.302;
    if (lost_digits + digits + cln_guard_digits / 2 <= carried) return cln::cl_float(sum, cln_format(wanted));
  }
}

cln::cl_F power(const cln::cl_F& distance, const cln::cl_F& exponent) {
  if (!cln::plusp(distance)) throw std::domain_error("power of a distance: the distance is positive");
  return cln::exp(exponent * cln::ln(distance));
}

cln::cl_F cos_pi_alpha(const Rational& s, cln::float_format_t format) {
  return cln::cl_float(cln::cl_I(1), format) / cln::sqrt(to_cln(Rational(1 + s * s), format));
}

}  // namespace steadyslide::symbolic
