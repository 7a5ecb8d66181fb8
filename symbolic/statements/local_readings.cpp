#include "symbolic/statements/statements.hpp"

#include <algorithm>

#include "symbolic/local/local_form.hpp"
#include "symbolic/statements/local_form_check.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

std::string outcome(const std::string& mismatch) { return mismatch.empty() ? "holds" : "leaves " + mismatch; }

/// Both candidates in the local equation.
LocalReading compared(std::string id, const LocalCandidate& printed, const LocalCandidate& derived) {
  const std::string p = first_mismatch(printed);
  const std::string d = first_mismatch(derived);
  return {std::move(id),
          "In the local equation the printed form " + outcome(p) + "; the derived form " + outcome(d) + ".", p.empty(),
          d.empty()};
}

/// t = -theta d^lambda on one side of a friction jump, with a slope outside where one is given.
class End {
 public:
  explicit End(Side contact)
      : contact_(contact),
        place_{contact == Side::right ? ContactSide::right : ContactSide::left, {s_l_}, {s_r_}},
        frame_(place_) {}

  LocalCandidate candidate(int halves, int left, int right) const {
    return {place_, frame_, local_exponent(halves, left, right), {{{contact_, true, 0, 0}, -theta_}}};
  }
  LocalCandidate with_slope(LocalCandidate form, const ex& coefficient) const {
    form.outside = coefficient * theta_;
    return form;
  }
  ex r(Side side) const { return frame_.friction(side).r; }

 private:
  symbol s_l_{"s_l"};
  symbol s_r_{"s_r"};
  symbol theta_{"theta"};
  Side contact_;
  LocalPlace place_;
  LocalFrame frame_;
};

void add_ends(std::vector<LocalReading>& readings) {
  const End rear(Side::right);
  const End front(Side::left);
  const LocalCandidate edge = front.candidate(-1, 1, 0);
  const LocalCandidate with_its_slope = front.with_slope(edge, front.r(Side::left));
  readings.push_back(compared("thm-03-angle-rear", rear.candidate(-1, -1, 0), rear.candidate(-1, 0, -1)));
  readings.push_back(compared("theorem-3-free-rear", rear.candidate(1, -1, 0), rear.candidate(1, 0, -1)));
  readings.push_back(compared("thm-03-angle-front", front.candidate(-1, 0, 1), edge));
  readings.push_back(compared("theorem-3-free-front", front.candidate(1, 0, 1), front.candidate(1, 1, 0)));
  readings.push_back(
      compared("theorem-3-slope-factor-front", front.with_slope(edge, front.r(Side::right)), with_its_slope));
  // The slope on the contact side is H t + s t there, and that has no such power.
  const std::vector<LocalEquation> inside =
      local_equations(edge.place, edge.frame.constants(*edge.exponent), edge.density);
  readings.push_back({"thm-03-front-limit",
                      "On the left of `c` there is contact and `u_bar' = psi_bar'` is bounded: the coefficient of the "
                      "power in `H t + s t` there is " +
                          edge.frame.text(inside.front().lhs).text + "; beyond the end it is `sqrt(1 + s^2) theta`.",
                      !edge.frame.field().is_identically_zero(inside.front().lhs).holds,
                      first_mismatch(with_its_slope).empty()});
  // The weight (1+x)^{1/2} at the rear end.
  for (const char* id : {"eq-04-exponent", "eq-05-exponent", "eq-08-exponent", "eq-10-exponents"}) {
    readings.push_back(compared(id, rear.candidate(-1, 0, 0), rear.candidate(-1, 0, -1)));
  }
}

void add_wedge(std::vector<LocalReading>& readings) {
  const symbol s("s");
  const symbol d("D");
  const LocalPlace place{ContactSide::both, {s, {0, 0, 0}}, {s, {d, 0, 0}}};
  const LocalFrame frame(place);
  const auto wedge = [&](const ex& one) -> LocalCandidate {
    return {place,
            frame,
            std::nullopt,
            {{{Side::left, false, 0, 1}, d / one / frame.pi()},
             {{Side::right, false, 0, 1}, d / one / frame.pi()},
             {{Side::right, false, 0, 0}, s * d / one}}};
  };
  readings.push_back(compared("theorem-2-square", wedge(1 + 2 * s), wedge(1 + s * s)));
}

/// Do the signs admit contact on both sides? Decided for numbers.
bool admitted(const ex& left, const ex& right, const ex& slope_jump) {
  const LocalForm form = derive_local_form({ContactSide::both, {left, {0, 0, 0}}, {right, {slope_jump, 0, 0}}});
  return std::ranges::none_of(form.conditions, [](const LocalCondition& c) { return c.holds == Truth::no; });
}

void add_words(std::vector<LocalReading>& readings) {
  const ex low = GiNaC::numeric(1, 10);
  const ex high = GiNaC::numeric(3, 5);
  readings.push_back({"theorem-2-words-re-entrant", "", !admitted(low, high, -1),
                      !admitted(low, low, -1) && !admitted(high, low, -1) && admitted(low, high, -1)});
  readings.push_back(
      {"theorem-2-words-limit", "", admitted(high, low, -1), admitted(high, low, 1) && !admitted(high, low, -1)});
  const LocalForm form =
      derive_local_form({ContactSide::both, {symbol("s_l")}, {symbol("s_r")}, Beyond::indenter, true});
  const bool free_amplitude = !form.terms.front().forced && form.terms.front().left.has(form.theta);
  readings.push_back({"theorem-2-words-infinity", "", !free_amplitude, free_amplitude});
}

}  // namespace

std::vector<LocalReading> local_readings() {
  std::vector<LocalReading> readings;
  add_ends(readings);
  add_wedge(readings);
  add_words(readings);
  return readings;
}

}  // namespace steadyslide::symbolic
