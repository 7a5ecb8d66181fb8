#include "app/report/sections.hpp"

namespace steadyslide::app {
namespace {

std::string meaning(const std::string& verdict, const std::string& text) {
  return element("dt", element("span", verdict, {{"class", "badge " + verdict}})) + element("dd", text) + "\n";
}

}  // namespace

Section guide_section() {
  const std::string verdicts =
      meaning("proved",
              "Exact identities establish the statement for all parameters that its hypotheses allow: as rational "
              "functions of independent symbols, or by exact arithmetic.") +
      meaning("supported",
              "Unrelated routes to the same number agree at every case examined, or identities cover a part of the "
              "statement. Evidence, and no proof.") +
      meaning("undecided",
              "The evidence does not suffice, or no calculation can decide the statement: it is then marked as beyond "
              "calculation, with what follows from it and can be calculated.") +
      meaning("refuted", "A counterexample was found.");
  return {
      "guide", "How to read this",
      element("p",
              "Every statement is examined on its own, by calculation. What the calculation finds makes the "
              "verdict; nobody writes it down.") +
          "\n" + element("dl", "\n" + verdicts, {{"class", "meanings"}}) + "\n" +
          element("p",
                  "A check could also be blind. Every statement that can be calculated therefore comes with "
                  "<em>controls</em>, deliberately wrong variants of its formula (a sign, a factor, an exchanged "
                  "side, a number moved by ten times the tolerance), and the same check has to refute each of them. "
                  "Where a control survives, the statement counts as undecided, whatever else was found.") +
          "\n" +
          element("p",
                  "Formulas in plain letters, in quantities, controls and counterexamples, are written as in a "
                  "terminal: <code>A t</code> is the operator on the left-hand side of (3), applied to the traction, "
                  "<code>u'/c</code> the slope of the surface over the compliance, <code>psi</code> the profile. A "
                  "case is <em>effective</em> where the statement says something of its own and every route gives a "
                  "value; where friction jumps by zero, for example, it does not.") +
          "\n"};
}

}  // namespace steadyslide::app
