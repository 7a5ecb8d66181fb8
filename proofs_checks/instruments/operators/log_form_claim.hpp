#pragma once
// Claims about the form -<<t_1 * log|x|, t_2>> of t dx = sum_k c_k cos(k theta) dtheta on intervals of a length L:
//
//   pi^2 log(critical/L) c_0 d_0 + sum_k>=1 first pi^2/k^power c_k d_k,
//
// positive definite where L < critical, and on zero mean for every L. Its coefficients are found by quadrature in both
// angles; whether it is positive, and its least value for int t = 1, on cells. [Bal16, section 3.1]

#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

struct Length {
  Rational value;
  bool is_first;  ///< of the claim: the least value on cells does not depend on it
};

std::string text_of(const Length& length);

/// The formula's constants; a claim's wrong variants have other ones.
struct LogForm {
  Rational critical = 4;
  Rational first{1, 2};
  int power = 1;
};

/// What it predicts for a length.
Values predicted_by(const LogForm& form, const Length& length);
/// A wrong variant, for ComparedClaim::wrong.
inline auto predicts(const LogForm& form) {
  return [form](Values& p, const Length& length) { p = predicted_by(form, length); };
}

/// With near misses, without wrong variants.
ComparedClaim<Length> log_form_claim(std::string id, std::vector<Rational> lengths);

}  // namespace steadyslide::proofs_checks
