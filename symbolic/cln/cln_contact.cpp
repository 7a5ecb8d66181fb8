#include "symbolic/cln/cln_contact.hpp"

#include <stdexcept>

namespace steadyslide::symbolic {

using cln::cl_F;

cl_F ClnContact::factor_at(const cl_F& length) const {
  cl_F value = number(0);
  for (std::size_t k = factor.size(); k-- > 0;) value = value * length + factor[k];
  return value;
}

bool ClnContact::free_ends_fit() const {
  const ClnPoint& left = places.front();
  const ClnPoint& right = places.back();
  const std::vector<Rational>& jumps = problem.friction().jumps();
  // Returns the signed length from a place of the data to an end. The error of an end is below `touch`.
  const auto beyond = [&](const ClnPoint& end, const Rational& x) {
    return end.rest - number(Rational(x - end.exact));
  };
  const cl_F touch =
      (beyond(right, origin) - beyond(left, origin)) * power_of_ten(-digits - cln_guard_digits / 2, format);
  const auto after = [&](const ClnPoint& end, const Rational& x) { return beyond(end, x) > touch; };
  const auto before = [&](const ClnPoint& end, const Rational& x) { return -beyond(end, x) > touch; };
  const bool has_jumps = first_jump < last_jump;
  if (!left.is_datum) {
    if (!after(left, problem.indenter().left()) || (has_jumps && !before(left, jumps[first_jump]))) return false;
    if (first_jump > 0 && before(left, jumps[first_jump - 1])) return false;
  }
  if (!right.is_datum) {
    if (!before(right, problem.indenter().right()) || (has_jumps && !after(right, jumps[last_jump - 1]))) return false;
    if (last_jump < jumps.size() && after(right, jumps[last_jump])) return false;
  }
  return true;
}

Decimal ClnContact::traction(const Rational& x) const {
  const auto refuse = [&](const std::string& why) {
    throw std::domain_error("derived traction: " + why + "; x = " + to_string(x));
  };
  const auto from = [&](const ClnPoint& place) { return number(Rational(x - place.exact)) - place.rest; };
  const cl_F from_left = from(places.front());
  const cl_F from_right = from(places.back());
  const cl_F blur = (from_left - from_right) * power_of_ten(-cln_guard_digits, format);
  for (const ClnPoint* end : {&places.front(), &places.back()}) {
    const cl_F distance = cln::abs(from(*end));
    if (cln::zerop(distance)) refuse("x is an end of the contact");
    if (!end->is_datum && distance < blur) refuse("x is too near a free end for the digits carried");
  }
  if (cln::minusp(from_left) || cln::plusp(from_right)) return {0, "0"};

  cl_F product = factor_at(number(Rational(x - origin)));
  for (const ClnPoint& place : places) {
    if (cln::zerop(place.power)) continue;
    const cl_F distance = cln::abs(from(place));
    if (cln::zerop(distance)) refuse("x is a friction jump inside the contact");
    product = product * power(distance, place.power);
  }
  const std::size_t piece = problem.friction().piece(x, Side::left);
  product = product * cos_pi_alpha(problem.coupled_friction(piece), format);
  return rounded(from_cln(product), digits);
}

}  // namespace steadyslide::symbolic
