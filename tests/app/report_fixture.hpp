#pragma once
// A ledger that no calculation made, with every kind of evidence and verdict, for tests of the report.

#include "app/report/report_page.hpp"

namespace steadyslide::testing {

inline app::VerifyResult fabricated_result() {
  using namespace proofs_checks;
  app::VerifyResult result;
  result.context.digits = numeric::Digits::fifty;
  result.context.seed = 7;
  result.context.quick = true;
  result.reports.push_back(
      {{"eq-04-flat-punch", "[Bal16, (4)]: flat punch, constant friction",
        "`t = -(P cos(pi alpha)/pi) (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}`, `alpha = arctan(gamma f)/pi`, solves "
        "`A t = 0` on `]-1, 1[` with load `P`",
        "plane strain, rigid flat punch, `-1 < nu < 1/2`, `f >= 0` constant, `P > 0`",
        "With `Phi(z) = (1/(2 pi i)) int t(x')/(x'-z) dx'` Plemelj's formulas turn `A t = 0` into `Phi^+ = G Phi^-`, "
        "`G = (s-i)/(s+i) = -e^{2 pi i alpha}` [Mus53]. Powers `p_1 = -(1/2+alpha)` and `p_2 = -(1/2-alpha)` at the "
        "ends solve it, and their sum is `-1`: `Phi` falls off as `P/(2 pi i z)`, which is the load."},
       Verdict::supported,
       {Agreement{"A t_0 over the largest term",
                  {"trapezoidal rule after `x = tanh(tau/2)`", "closed form of the integral"},
                  "3.1e-52",
                  "1e-45",
                  24,
                  24,
                  12,
                  "24 random cases, seed 7"},
        Agreement{"load", {"tanh-sinh rule", "`P`"}, "2.2e-50", "1e-45", 24, 20, 12, "24 random cases, seed 7"}},
       "",
       {{"the sign of `alpha` exchanged", true, "A t_0: difference 0.31 at nu = 1/3, f = 2"},
        {"near miss: the power moved by ten times the tolerance", true, "load: difference 1.0e-44 at nu = 1/3, f = 2"}},
       0.21});
  result.reports.push_back(
      {{"energy-identity", "[Bal16, sections 3.1 and 4]: the energy of a traction of zero mean",
        "`b(t,t) = -(1/pi) <<t * log|x|, t>> + (1/2) sum_k (s_k - s_{k-1}) T(c_k)^2`", "tractions of zero mean",
        "Integrate `s T T'` by parts on every piece, with `T(x) = int_{-1}^x t`."},
       Verdict::proved,
       {ExactIdentity{"for independent symbols `s_k`",
                      {"`int s T T' = -(1/2) sum_k (s_k - s_{k-1}) T(c_k)^2`", "the logarithm's part is symmetric"},
                      ExactIdentity::Covers::claim}},
       "",
       {{"the factor 1/2 missing", true, "difference 3/8"}},
       0.03});
  result.reports.push_back(
      {{"vi-rate", "[Bal16, section 3.1], two methods", "errors fall as `1/N`", "edges", ""},
       Verdict::supported,
       {ConvergenceRate{"the load's share", 0.98, 0.02, 1, 0.1, "levels `N = 2^k`, k = 8, ..., 14"}},
       "",
       {{"an order too high", true, "rate 0.98 where 2 is expected"}},
       4.5});
  result.reports.push_back({{"thm-16-existence", "[Bal16, theorem 16]", "a solution exists", "`s` nondecreasing", ""},
                            Verdict::undecided,
                            {BeyondCalculation{"an abstract proof of existence", {"eq-04-flat-punch", "not-here"}}},
                            "",
                            {},
                            0});
  result.reports.push_back(
      {{"bad-claim", "[Bal16, (1)] <script>alert(1)</script>", "x < 2 & `1 < %` \"y\"", "never", ""},
       Verdict::refuted,
       {Counterexample{"`nu = 0`", "1 is not 2"}},
       "a control survives: the swap",
       {{"swap", false, "nothing found"}},
       1.5});
  result.notes.push_back({"eq-04-exponent", "[Bal16, (4)]", "`(1+x)^{1/2}`", "`(1+x)^{1/2+alpha}`",
                          "claim eq-04-flat-punch is supported as derived", "eq-04-flat-punch"});
  return result;
}

inline app::Supplement fabricated_supplement() {
  const std::string svg =
      "<?xml version=\"1.0\"?>\n<svg width=\"600\" height=\"300\" viewBox=\"0 0 600 300\" "
      "xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"><title>Gnuplot</title>"
      "<defs><circle id='dot' r='4'/></defs><use xlink:href='#dot' x='50' y='60'/><path d='M0 0L600 300' "
      "stroke='black'/></svg>\n";
  return {{{"flat_punch", "Flat punch.", "Pressure for `f = 1/2`.", "steadyslide figures --figure flat_punch", svg},
           {"parabola", "Parabola.", "Ends at `-(1+2alpha)a`.", "steadyslide figures --figure parabola", svg}},
          "",
          {{"Powers at a jump",
            "`beta = alpha_- - alpha_+`",
            {"`nu`", "`f_-`", "`f_+`", "`beta`"},
            {{"0", "1/10", "3/5", "-0.0768"}, {"1/4", "3/5", "1/10", "0.0523"}},
            {"[Bal16, (7)]"}}},
          {{"m-01", "numeric/a.cpp", "a < b becomes a <= b", "test_numeric", "assertion failed"}}};
}

}  // namespace steadyslide::testing
