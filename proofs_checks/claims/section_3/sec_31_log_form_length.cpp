#include "proofs_checks/instruments/operators/log_form_claim.hpp"

namespace steadyslide::proofs_checks::sec_31_log_form_length {

Claim claim() {
  return log_form_claim("sec-31-log-form-length", {5, Rational(7, 2), Rational(1, 2), Rational(9, 2), 20})
      .wrong("positive up to length 8", predicts({.critical = 8}))
      .wrong("positive up to length 2", predicts({.critical = 2}))
      .wrong("beyond length 4 on all tractions",
             replaced({{"positive on all meshes", true}, {"positive on some mesh", true}}))
      .wrong("`pi^2/k`", predicts({.first = 1}));
}

}  // namespace steadyslide::proofs_checks::sec_31_log_form_length
