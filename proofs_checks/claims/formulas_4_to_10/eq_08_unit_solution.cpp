#include "proofs_checks/instruments/tractions/constant_punch.hpp"

namespace steadyslide::proofs_checks::eq_08_unit_solution {

Claim claim() { return constant_punch_claim("eq-08-unit-solution", PunchLoad::minus_one); }

}  // namespace steadyslide::proofs_checks::eq_08_unit_solution
