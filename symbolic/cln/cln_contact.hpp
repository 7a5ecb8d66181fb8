#pragma once
// One contact component whose traction is known in closed form, in CLN:
//
//   t(x) = cos(pi alpha(x)) prod_j |x - e_j|^{p_j} N(x),   e_j: the contact's ends and the friction jumps inside it,
//
// with a polynomial N. For sources of this layer only. Not thread-safe, because CLN is not.

#include <vector>

#include "model/contact_problem.hpp"
#include "model/direction.hpp"
#include "symbolic/cln/cln_number.hpp"
#include "symbolic/cln/decimal.hpp"

namespace steadyslide::symbolic {

struct ClnContact {
  /// x = exact + rest. If `is_datum` is true, x is exact and the rest is 0.
  struct ClnPoint {
    Rational exact;
    cln::cl_F rest;
    cln::cl_F power;
    bool is_datum;
  };

  ContactProblem problem;
  int digits;  ///< served
  cln::float_format_t format;
  Rational origin;         ///< origin of the lengths in N
  std::size_t first_jump;  ///< inside the contact are the jumps first_jump <= index < last_jump
  std::size_t last_jump;
  std::vector<ClnPoint> places = {};   ///< left end, jumps inside, right end
  std::vector<cln::cl_F> factor = {};  ///< N, by coefficients

  cln::cl_F number(const Rational& value) const { return to_cln(value, format); }
  const ClnPoint& place(End end) const { return end == End::left ? places.front() : places.back(); }
  Decimal end(End which) const { return rounded(place(which).exact + from_cln(place(which).rest), digits); }
  /// Returns N at this length from the origin.
  cln::cl_F factor_at(const cln::cl_F& length) const;
  /// True if the free ends lie inside the support, with these jumps between them and no others. A jump inside must lie
  /// strictly inside; a jump outside may coincide with an end. So one choice of jumps fits, not two.
  bool free_ends_fit() const;
  /// Returns t(x); 0 outside the contact. Throws std::domain_error if x is an end, a friction jump inside the contact,
  /// or so close to a free end that the working precision cannot distinguish them.
  Decimal traction(const Rational& x) const;
};

}  // namespace steadyslide::symbolic
