#include "symbolic/statements/statements.hpp"

#include "symbolic/statements/local_form_check.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

std::string outcome(const std::string& mismatch) { return mismatch.empty() ? "holds" : "leaves " + mismatch; }

/// Compares both candidates by the local equation.
LocalReading compared(std::string id, const LocalCandidate& printed, const LocalCandidate& derived) {
  const std::string p = first_mismatch(printed);
  const std::string d = first_mismatch(derived);
  return {std::move(id),
          "In the local equation the printed form " + outcome(p) + "; the derived form " + outcome(d) + ".", p.empty(),
          d.empty()};
}

}  // namespace

std::vector<LocalReading> local_readings() {
  std::vector<LocalReading> readings;
  const LocalEnd rear(Side::right);
  const LocalEnd front(Side::left);
  const auto compare = [&](const char* id, const LocalEnd& end, const AngleForm& printed, const AngleForm& derived) {
    readings.push_back(compared(id, end.candidate(printed), end.candidate(derived)));
  };
  const AngleForm edge = local_exponent(-1, 1, 0);
  const LocalCandidate with_its_slope = front.candidate(edge, front.r(Side::left));
  compare("thm-03-angle-rear", rear, local_exponent(-1, -1, 0), local_exponent(-1, 0, -1));
  compare("theorem-3-free-rear", rear, local_exponent(1, -1, 0), local_exponent(1, 0, -1));
  compare("thm-03-angle-front", front, local_exponent(-1, 0, 1), edge);
  compare("theorem-3-free-front", front, local_exponent(1, 0, 1), local_exponent(1, 1, 0));
  readings.push_back(
      compared("theorem-3-slope-factor-front", front.candidate(edge, front.r(Side::right)), with_its_slope));
  // The slope on the contact side is H t + s t, which does not contain this power.
  const ex inside = local_equations(with_its_slope.place, front.frame().constants(edge), with_its_slope.density)[0].lhs;
  readings.push_back({"thm-03-front-limit",
                      "On the left of `c` there is contact and `u_bar' = psi_bar'` is bounded: the coefficient of the "
                      "power in `H t + s t` there is " +
                          front.frame().text(inside).text + "; beyond the end it is `sqrt(1 + s^2) theta`.",
                      !front.frame().field().is_identically_zero(inside).holds,
                      first_mismatch(with_its_slope).empty()});
  // The weight (1+x)^{1/2} at the rear end.
  for (const char* id : {"eq-04-exponent", "eq-05-exponent", "eq-08-exponent", "eq-10-exponents"}) {
    compare(id, rear, local_exponent(-1, 0, 0), local_exponent(-1, 0, -1));
  }
  return readings;
}

}  // namespace steadyslide::symbolic
