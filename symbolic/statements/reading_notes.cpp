#include "symbolic/statements/reading_notes.hpp"

#include <algorithm>

#include "symbolic/local/local_form.hpp"
#include "symbolic/local/local_form_check.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

std::string outcome(const std::string& mismatch) { return mismatch.empty() ? "holds" : "leaves " + mismatch; }

/// Both candidates in the local equation, and who may be at fault.
ReadingNote compared(ReadingNote note, const LocalCandidate& printed, const LocalCandidate& derived) {
  const std::string p = first_mismatch(printed);
  const std::string d = first_mismatch(derived);
  note.printed_holds = p.empty();
  note.derived_holds = d.empty();
  note.evidence = "In the local equation the printed form " + outcome(p) + "; the derived form " + outcome(d) + ". " +
                  note.evidence;
  return note;
}

/// t = -theta d^lambda on one side of a friction jump, with a slope outside where one is given.
class End {
 public:
  explicit End(Side contact)
      : contact_(contact),
        place_{contact == Side::right ? ContactSide::right : ContactSide::left, {s_l_}, {s_r_}},
        frame_(place_) {}

  LocalCandidate candidate(int halves, int left, int right) const {
    return {place_, frame_, LocalExponent{halves, left, right}, {{{contact_, true, 0, 0}, -theta_}}};
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

void add_theorem_3(std::vector<ReadingNote>& notes) {
  const End rear(Side::right);
  const End front(Side::left);
  const std::string minus = "Extraction may have lost a superscript minus here. ";
  const std::string plus = "The superscript plus survives extraction, so that this may be the printed text. ";
  const std::string side = "The friction on the side without contact multiplies `t = 0`.";
  notes.push_back(
      compared({"theorem-3-angle-rear", "theorem 3, contact on the right of `c`, a step",
                "`t = -theta/|x-c|^{1/2+alpha}`, `alpha` by (5): the friction on the left of `c`",
                "`alpha` by the friction on the right of `c`, the side in contact", minus + side, false, false},
               rear.candidate(-1, -1, 0), rear.candidate(-1, 0, -1)));
  notes.push_back(compared({"theorem-3-free-rear", "theorem 3, contact on the right of `c`, `psi_bar` continuous",
                            "`t = -|c-x|^{1/2-alpha} theta`, `alpha` by (5): the friction on the left of `c`",
                            "`alpha` by the friction on the right of `c`", minus + side, false, false},
                           rear.candidate(1, -1, 0), rear.candidate(1, 0, -1)));
  notes.push_back(
      compared({"theorem-3-angle-front", "theorem 3, contact on the left of `c`, a step",
                "`t = -theta/|x-c|^{1/2-alpha_+}`, `alpha_+` by (6): the friction on the right of `c`",
                "`alpha` by the friction on the left of `c`, the side in contact", plus + side, false, false},
               front.candidate(-1, 0, 1), front.candidate(-1, 1, 0)));
  notes.push_back(compared({"theorem-3-free-front", "theorem 3, contact on the left of `c`, `psi_bar` continuous",
                            "`t = -|c-x|^{1/2+alpha_+} theta`, `alpha_+` by (6): the friction on the right of `c`",
                            "`alpha` by the friction on the left of `c`", plus + side, false, false},
                           front.candidate(1, 0, 1), front.candidate(1, 1, 0)));
  notes.push_back(compared({"theorem-3-slope-factor-front", "theorem 3, estimate of `u_bar'` beyond the front",
                            "`sqrt(1 + gamma^2 f_+^2)`, even with the right power",
                            "`sqrt(1 + s^2)` with the friction on the left of `c`", plus, false, false},
                           front.with_slope(front.candidate(-1, 1, 0), front.r(Side::right)),
                           front.with_slope(front.candidate(-1, 1, 0), front.r(Side::left))));

  // The slope on the contact side is H t + s t there, and that has no such power.
  const LocalCandidate form = front.candidate(-1, 1, 0);
  const std::vector<LocalEquation> inside =
      local_equations(form.place, form.frame.constants(*form.exponent), form.density);
  const bool bounded = form.frame.field().is_identically_zero(inside.front().lhs).holds;
  notes.push_back(
      {"theorem-3-limit-front", "theorem 3, estimate of `u_bar'` at the front", "as `x -> c-`", "as `x -> c+`",
       "On the left of `c` there is contact and `u_bar' = psi_bar'` is bounded: the coefficient of the power in "
       "`H t + s t` there is " +
           form.frame.text(inside.front().lhs).text +
           "; beyond the end it is `sqrt(1 + s^2) theta`. Theorem 10 has `x -> 1+` in the same place. Extraction loses "
           "signs and "
           "turns none into another: more likely the print's.",
       !bounded, first_mismatch(front.with_slope(form, front.r(Side::left))).empty()});
}

void add_lost_exponents(std::vector<ReadingNote>& notes) {
  const End rear(Side::right);
  for (const auto& [id, where] :
       {std::pair("formula-4-exponent", "(4)"), std::pair("formula-7-exponent", "above (5)-(7)"),
        std::pair("formula-8-exponent", "(8)"), std::pair("formula-10-exponent", "(10) and the formula before it")}) {
    notes.push_back(
        compared({id, where, "the weight `(1+x)^{1/2}` at the rear end", "`(1+x)^{1/2+alpha}`",
                  "Theorem 10 has `1/2+alpha` at the same end, and both exponents have to add up to `1` with the "
                  "front's `1/2-alpha` (where friction does not jump): extraction lost it.",
                  false, false},
                 rear.candidate(-1, 0, 0), rear.candidate(-1, 0, -1)));
  }
}

void add_theorem_2(std::vector<ReadingNote>& notes) {
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
  notes.push_back(
      compared({"theorem-2-square", "theorem 2, second case, the denominator", "1 + (gamma f(c)2: read `1 + 2 s`",
                "`1 + (gamma f(c))^2`",
                "Theorem 9 has the square: extraction lost the parenthesis and the superscript.", false, false},
               wedge(1 + 2 * s), wedge(1 + s * s)));
}

/// Do the signs admit contact on both sides? Decided for numbers.
bool admitted(const ex& left, const ex& right, const ex& slope_jump) {
  const LocalForm form = derive_local_form({ContactSide::both, {left, {0, 0, 0}}, {right, {slope_jump, 0, 0}}});
  return std::none_of(form.conditions.begin(), form.conditions.end(),
                      [](const LocalCondition& condition) { return condition.holds == Truth::no; });
}

void add_words(std::vector<ReadingNote>& notes) {
  const ex low = GiNaC::numeric(1, 10);
  const ex high = GiNaC::numeric(3, 5);
  notes.push_back(
      {"theorem-2-words-re-entrant", "the words after theorem 2, first item",
       "around a re-entrant wedge the vertex is never an interior point of the contact zone",
       "so it is where `s` does not jump or decreases to the right; where `s` increases a re-entrant wedge is "
       "admitted",
       "Where `s` increases both parts of the local form press: the forced constant `[psi_bar']/[s]` is negative, and "
       "so "
       "is the power's part. The words are said of the case without a jump; taken without it they fail. Words are not "
       "changed by extraction: the print's.",
       !admitted(low, high, -1), !admitted(low, low, -1) && !admitted(high, low, -1) && admitted(low, high, -1)});
  notes.push_back(
      {"theorem-2-words-limit", "the words after theorem 2, third item",
       "with a wedge, where `f` decreases the traction has a negative limit at `c`",
       "negative for `[psi_bar'] > 0`; with `[psi_bar'] < 0` the limit `[psi_bar']/[s]` would be positive: there is "
       "no contact around `c` then",
       "The constant leads where `s` decreases, and `t <= 0` decides its sign. Words are not changed by extraction: "
       "the "
       "print's.",
       admitted(high, low, -1), admitted(high, low, 1) && !admitted(high, low, -1)});
  const symbol s_l("s_l");
  const symbol s_r("s_r");
  const LocalForm form = derive_local_form({ContactSide::both, {s_l}, {s_r}, Beyond::indenter, true});
  const bool free_amplitude = !form.terms.front().forced && form.terms.front().left.has(form.theta);
  notes.push_back({"theorem-2-words-infinity", "the words after theorem 2, second item",
                   "where `f` increases the traction goes to infinity",
                   "so it does where its amplitude `theta(c)` is not zero; the local equation leaves `theta` free",
                   "The amplitude of the power is no datum of the place: the whole problem decides it. Words are not "
                   "changed by extraction: the print's.",
                   !free_amplitude, free_amplitude});
}

}  // namespace

std::vector<ReadingNote> reading_notes() {
  std::vector<ReadingNote> notes;
  add_theorem_3(notes);
  add_lost_exponents(notes);
  add_theorem_2(notes);
  add_words(notes);
  return notes;
}

}  // namespace steadyslide::symbolic
