#include "proofs_checks/instruments/tractions/constant_punch.hpp"

namespace steadyslide::proofs_checks {

Claim eq_04_flat_punch() { return constant_punch_claim("eq-04-flat-punch", PunchLoad::given); }

}  // namespace steadyslide::proofs_checks
