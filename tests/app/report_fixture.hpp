#pragma once
// A fabricated ledger with every kind of evidence and verdict, for tests of the report.

#include "app/report/report_page.hpp"
#include "proofs_checks/kit/proofs.hpp"
#include "support/test.hpp"

namespace steadyslide::testing {

inline app::VerifyResult fabricated_result() {
  using namespace proofs_checks;
  std::map<std::string, ClaimText> words;
  for (const auto& [id, text] : sections_of(STEADYSLIDE_TESTS "/app/report/claims.txt")) {
    words.emplace(id, parse_claim_text("# " + id + ": " + text));
  }
  const std::string drawn = "24 random cases, seed 7";
  app::VerifyResult result{{numeric::Digits::fifty, 7, true}, {}, {}};
  result.reports = {
      {words.at("eq-04-flat-punch"),
       Verdict::supported,
       {Agreement{"A t_0 over the largest term",
                  {"trapezoidal rule after `x = tanh(tau/2)`", "closed form of the integral"},
                  "3.1e-52",
                  "1e-45",
                  24,
                  24,
                  12,
                  drawn},
        Agreement{"load", {"tanh-sinh rule", "`P`"}, "2.2e-50", "1e-45", 24, 20, 12, drawn}},
       "",
       {{"the sign of `alpha` exchanged", true, "A t_0: difference 0.31 at nu = 1/3, f = 2"},
        {"near miss: the power moved by ten times the tolerance", true, "load: difference 1.0e-44 at nu = 1/3, f = 2"}},
       0.21},
      {words.at("energy-identity"),
       Verdict::proved,
       {*proof_of("gamma-range"),
        ExactIdentity{"for independent symbols `s_k`",
                      {"`int s T T' = -(1/2) sum_k (s_k - s_{k-1}) T(c_k)^2`", "the logarithm's part is symmetric"}}},
       "",
       {{"the factor 1/2 missing", true, "difference 3/8"}},
       0.03},
      {words.at("vi-rate"),
       Verdict::supported,
       {ConvergenceRate{"the load's share", 0.98, 0.02, 1, 0.1, "levels `N = 2^k`, k = 8, ..., 14"}},
       "",
       {{"an order too high", true, "rate 0.98 where 2 is expected"}},
       4.5},
      {words.at("thm-16-existence"),
       Verdict::undecided,
       {BeyondCalculation{"an abstract proof of existence", {"eq-04-flat-punch", "not-here"}}},
       "",
       {},
       0},
      {words.at("bad-claim"),
       Verdict::refuted,
       {Counterexample{"`nu = 0`", "1 is not 2"}},
       "a control survives: the swap",
       {{"swap", false, "nothing found"}},
       1.5}};
  result.notes.push_back({"eq-04-exponent", "[Bal16, (4)]", "`(1+x)^{1/2}`", "`(1+x)^{1/2+alpha}`",
                          "claim eq-04-flat-punch is supported as derived", "undecided", "eq-04-flat-punch"});
  return result;
}

inline app::Supplement fabricated_supplement() {
  const std::string svg = file_text(STEADYSLIDE_TESTS "/app/report/drawing.svg");
  return {{{"flat_punch", "Flat punch.", "Pressure for `f = 1/2`.", "steadyslide figures --figure flat_punch", svg},
           {"parabola", "Parabola", "Ends at `-(1+2alpha)a`.", "steadyslide figures --figure parabola", svg}},
          "",
          {{"Powers at a jump",
            "`beta = alpha_- - alpha_+`",
            {"`nu`", "`f_-`", "`f_+`", "`beta`"},
            {{"0", "1/10", "3/5", "-0.0768"}, {"1/4", "3/5", "1/10", "0.0523"}},
            {"[Bal16, (7)]"}}},
          {{"m-01", "numeric/a.cpp", "a < b becomes a <= b", "test_numeric", "assertion failed"}},
          {{"compiler", "one"}}};
}

}  // namespace steadyslide::testing
