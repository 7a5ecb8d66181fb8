#include "proofs_checks/instruments/tractions/constant_punch.hpp"

namespace steadyslide::proofs_checks::eq_04_flat_punch {

Claim claim() { return constant_punch_claim("eq-04-flat-punch", PunchLoad::given); }

}  // namespace steadyslide::proofs_checks::eq_04_flat_punch
