#pragma once
// Claims about the form -<<t_1 * log|x|, t_2>> of t dx = sum_k c_k cos(k theta) dtheta on intervals of a length L:
//
//   pi^2 log(critical/L) c_0 d_0 + sum_k>=1 first pi^2/k^power c_k d_k,
//
// It is positive definite if L < critical, and on zero mean for every L. The coefficients are measured by quadrature in
// both angles. The signs, and the least value for int t = 1, are measured on cells. [Bal16, section 3.1]

#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

struct Length {
  Rational value;
  /// True for the claim's first length. The least value on cells does not depend on the length and is measured there
  /// only.
  bool is_first;
};

std::string text_of(const Length& length);

/// The constants of the formula. Wrong variants of a claim have other values.
struct LogForm {
  Rational critical = 4;
  Rational first{1, 2};
  int power = 1;
};

/// Returns the prediction of the formula for a length.
Values predicted_by(const LogForm& form, const Length& length);
/// Returns a wrong variant, for ComparedClaim::wrong.
inline auto predicts(const LogForm& form) {
  return [form](Values& p, const Length& length) { p = predicted_by(form, length); };
}

/// Returns the claim with its near misses, without wrong variants.
ComparedClaim<Length> log_form_claim(std::string id, std::vector<Rational> lengths);

}  // namespace steadyslide::proofs_checks
