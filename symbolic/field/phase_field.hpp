#pragma once
// The field in which the exact statements about friction angles are decided:
//
//   Q(free symbols)(i, r_1, r_2, ...),   r_k^2 = 1 + s_k^2,   cos(pi alpha_k) = 1/r_k,   sin(pi alpha_k) = s_k/r_k,
//
// for frictions s_k = tan(pi alpha_k) that are symbols or rational numbers. Radicals of symbols are independent:
// 1 + s^2 = (s+i)(s-i) has no square factor. Radicals of numbers may be dependent (s = 3/4 has r = 5/4; s = 1 and s = 7
// have r = sqrt 2 and 5 sqrt 2). So they are written in terms of square roots of pairwise coprime integers that are not
// squares, which are independent over Q(i). Therefore an element is zero if and only if all its coefficients are zero.

#include <ginac/ginac.h>

#include <set>
#include <string>
#include <vector>

#include "model/rational.hpp"
#include "symbolic/field/angle_form.hpp"

namespace steadyslide::symbolic {

class PhaseField {
 public:
  /// One friction in the field: 0 < r, pi alpha in ]-pi/2, pi/2[.
  struct Friction {
    GiNaC::ex s;
    GiNaC::ex r;
    GiNaC::ex cos;  ///< cos(pi alpha) = 1/r
    GiNaC::ex sin;  ///< sin(pi alpha) = s/r
  };

  /// Takes frictions s; each is a symbol, minus a symbol, or a rational number, and may occur several times. Throws
  /// std::domain_error for any other expression.
  explicit PhaseField(const std::vector<GiNaC::ex>& frictions = {});

  const Friction& friction(std::size_t k) const { return frictions_.at(k); }
  std::size_t size() const { return frictions_.size(); }
  /// The imaginary unit, as a symbol. GiNaC::I in an expression has the same meaning.
  const GiNaC::symbol& i() const { return i_; }

  /// Returns exp(i pi times form).
  GiNaC::ex phase(const AngleForm& form, int times = 1) const;

  struct Decision {
    bool holds;
    /// Divisors as written, up to a factor. The decision does not apply where one of them vanishes.
    std::set<std::string> nonvanishing;
  };
  /// Decides if the expression is zero; the next function decides lhs = rhs. They throw std::domain_error if an
  /// expression is not in the field (another function, a radical that is not in the field, a decimal number) or divides
  /// by a zero of the field.
  Decision is_identically_zero(const GiNaC::ex& expression) const;
  Decision are_equal(const GiNaC::ex& lhs, const GiNaC::ex& rhs) const;

  /// Returns the element with a denominator without radicals and i, and a numerator with their first powers only. It is
  /// unique up to the common factors that normal() cancels. Throws as above.
  GiNaC::ex canonical(const GiNaC::ex& expression) const;
  /// Returns a text. Equal elements have equal texts, in every run.
  std::string text(const GiNaC::ex& expression) const;

  /// A symbol that is not free, with its square: i, or a radical. For printers and evaluators.
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

/// Returns pairwise coprime integers > 1. Every given integer >= 1 is a product of their powers.
std::vector<Integer> coprime_base(const std::vector<Integer>& integers);

}  // namespace steadyslide::symbolic
