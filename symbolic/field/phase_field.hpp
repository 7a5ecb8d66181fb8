#pragma once
// The field in which the exact statements about friction angles are decided:
//
//   Q(free symbols)(i, r_1, r_2, ...),   r_k^2 = 1 + s_k^2,   cos(pi alpha_k) = 1/r_k,   sin(pi alpha_k) = s_k/r_k,
//
// for frictions s_k = tan(pi alpha_k) that are symbols or rational numbers. Radicals of symbols are independent:
// 1 + s^2 = (s+i)(s-i) has no square factor. Radicals of numbers need not be (s = 3/4 has r = 5/4; s = 1 and s = 7 have
// r = sqrt 2 and 5 sqrt 2): they are written in square roots of pairwise coprime integers that are no squares, and
// those are independent over Q(i) of each other. So an element is zero if and only if all its coefficients are.

#include <ginac/ginac.h>

#include <set>
#include <string>
#include <vector>

#include "model/rational.hpp"
#include "symbolic/field/angle_form.hpp"

namespace steadyslide::symbolic {

class PhaseField {
 public:
  /// What the field knows of one friction: 0 < r, pi alpha in ]-pi/2, pi/2[.
  struct Friction {
    GiNaC::ex s;
    GiNaC::ex r;
    GiNaC::ex cos;  ///< cos(pi alpha) = 1/r
    GiNaC::ex sin;  ///< sin(pi alpha) = s/r
  };

  /// Each s a symbol, minus a symbol, or a rational number; repetitions are welcome. Throws std::domain_error.
  explicit PhaseField(const std::vector<GiNaC::ex>& frictions = {});

  const Friction& friction(std::size_t k) const { return frictions_.at(k); }
  std::size_t size() const { return frictions_.size(); }
  /// The imaginary unit, as a symbol; GiNaC::I in an expression is read as the same.
  const GiNaC::symbol& i() const { return i_; }

  /// exp(i pi times form)
  GiNaC::ex phase(const AngleForm& form, int times = 1) const;

  struct Decision {
    bool holds;
    /// Divisors as they were written, up to a factor: where one vanishes, nothing is said.
    std::set<std::string> nonvanishing;
  };
  /// Is the expression zero? Is lhs = rhs? Throws std::domain_error for an expression from outside the field (another
  /// function, a radical that is not the field's, a decimal number) and where it divides by a zero of the field.
  Decision is_identically_zero(const GiNaC::ex& expression) const;
  Decision are_equal(const GiNaC::ex& lhs, const GiNaC::ex& rhs) const;

  /// The element with a denominator free of radicals and of i, and at most first powers of them above: unique up to the
  /// common factors that normal() cancels. Throws as above.
  GiNaC::ex canonical(const GiNaC::ex& expression) const;
  /// Equal elements have equal texts, in every run.
  std::string text(const GiNaC::ex& expression) const;

  /// The symbols that are not free, with their squares: i, then the radicals. For printers and evaluators.
  struct Radical {
    GiNaC::symbol root;
    GiNaC::ex square;
  };
  const std::vector<Radical>& radicals() const { return radicals_; }

 private:
  GiNaC::ex admitted(const GiNaC::ex& expression) const;
  GiNaC::ex reduced(const GiNaC::ex& polynomial) const;
  void require_no_zero_divisor(const GiNaC::ex& expression) const;

  GiNaC::symbol i_;
  std::vector<Friction> frictions_;
  std::vector<Radical> radicals_;
};

/// Pairwise coprime integers > 1 of whose powers all the given integers >= 1 are products.
std::vector<Integer> coprime_base(const std::vector<Integer>& integers);

}  // namespace steadyslide::symbolic
