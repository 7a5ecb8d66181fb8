#pragma once
// One contact whose traction is known in closed form, in CLN:
//
//   t(x) = cos(pi alpha(x)) prod_j |x - e_j|^{p_j} N(x),   e_j: the contact's ends and the friction jumps inside it,
//
// with a polynomial N. For sources of this layer only. Not thread-safe, as CLN is not.

#include <string>
#include <vector>

#include "model/contact_problem.hpp"
#include "model/direction.hpp"
#include "symbolic/cln/cln_number.hpp"
#include "symbolic/cln/decimal.hpp"

namespace steadyslide::symbolic {

struct ClnContact {
  /// x = exact + rest; `is_datum`: known exactly, without a rest.
  struct Place {
    Rational exact;
    cln::cl_F rest;
    cln::cl_F power;
    bool is_datum;
  };

  std::string name;  ///< of the traction, in messages
  ContactProblem problem;
  int digits;  ///< served
  cln::float_format_t format;
  Rational origin;         ///< of the lengths in N
  std::size_t first_jump;  ///< inside the contact are the jumps first_jump <= index < last_jump
  std::size_t last_jump;
  std::vector<Place> places = {};      ///< left end, jumps inside, right end
  std::vector<cln::cl_F> factor = {};  ///< N, by coefficients

  cln::cl_F number(const Rational& value) const { return to_cln(value, format); }
  const Place& place(End end) const { return end == End::left ? places.front() : places.back(); }
  Decimal end(End which) const { return rounded(place(which).exact + from_cln(place(which).rest), digits); }
  /// N at this length from the origin.
  cln::cl_F factor_at(const cln::cl_F& length) const;
  /// Do the free ends lie inside the support, with these jumps between them and no others? A jump inside is strictly inside,
  /// one outside may touch: then one choice of jumps fits, not two.
  bool free_ends_fit() const;
  /// 0 outside of the contact. Throws std::domain_error at an end, at a friction jump inside the contact, and where x is
  /// so near a free end that the digits carried do not tell them apart.
  Decimal traction(const Rational& x) const;
};

/// The profile of the support. Throws std::domain_error, which begins with `what`, where it has several pieces, and where
/// the indenter may tilt.
const Polynomial& one_profile(const ContactProblem& problem, const std::string& what);

/// The format in which `digits` digits are computed. Throws std::domain_error, which begins with `what`, for digits < 1.
cln::float_format_t format_for(int digits, const std::string& what);

}  // namespace steadyslide::symbolic
