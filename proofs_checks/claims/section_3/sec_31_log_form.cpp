#include "proofs_checks/instruments/operators/log_form_claim.hpp"

namespace steadyslide::proofs_checks::sec_31_log_form {

Claim claim() {
  return log_form_claim("sec-31-log-form", {2})
      .wrong("log 2 missing", predicts({.critical = 2}))
      .wrong("`pi^2/k`", predicts({.first = 1}))
      .wrong("`pi^2/2` for all `k`", predicts({.power = 0}))
      .wrong("the other sign", predicts({.first = Rational(-1, 2)}));
}

}  // namespace steadyslide::proofs_checks::sec_31_log_form
