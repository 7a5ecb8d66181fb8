#include "symbolic/riemann_hilbert/closed_form_derivation.hpp"
#include "support/test.hpp"

using namespace steadyslide::symbolic;

namespace {

void check_says(const Derivation& derivation, std::initializer_list<const char*> parts) {
  for (const char* part : parts) CHECK_MESSAGE(holds(to_text(derivation), part), part);
}

}  // namespace

TEST_CASE("every closed form is derived with up to four jumps, in the same words every time") {
  using enum ClosedFormKind;
  for (const ClosedFormKind kind : {flat_punch, tilted_punch, lifted_punch, parabola, parabola_left_edge,
                                    parabola_right_edge, parabola_two_edges, quartic}) {
    for (int jumps = 0; jumps <= 4; ++jumps) {
      const Derivation derivation = closed_form_derivation(kind, jumps);
      const auto results =
          std::count_if(derivation.steps.begin(), derivation.steps.end(),
                        [](const DerivationStep& step) { return step.kind == DerivationStep::Kind::result; });
      CHECK(results >= 2 * jumps + 8);
      CHECK(to_text(derivation) == to_text(closed_form_derivation(kind, jumps)));
      CHECK(to_latex(derivation) == to_latex(closed_form_derivation(kind, jumps)));
    }
  }
  CHECK_THROWS_AS(closed_form_derivation(-1), std::domain_error);
}

TEST_CASE("the flat punch with one jump, as it reads") {
  const Derivation d = closed_form_derivation(1);
  CHECK(d.title == "Flat punch, 1 friction jump");
  check_says(d, {"p_0 = -1/2 - alpha_0", "p_1 = alpha_0 - alpha_1", "p_2 = -1/2 + alpha_1", "S = -1", "N = -P/pi",
                 "(s+i) Y+ = |Y|/cos(pi alpha)"});
}

TEST_CASE("the parabola and the quartic: factor and conditions") {
  check_says(closed_form_derivation(ClosedFormKind::parabola, 2),
             {"N = 1/R", "(s+i) Y+ = -|Y|/cos(pi alpha)", "S = 1"});
  check_says(closed_form_derivation(ClosedFormKind::quartic, 0), {"N = kappa*x^2 + kappa*sigma_1*x"});
}

TEST_CASE("a problem's own derivation has its numbers") {
  const ContactProblem problem(Elasticity::reduced(0.5_r), FrictionProfile({0.2_r, 1.2_r}, {0}),
                               Indenter(-1, {{1, Polynomial({0, 0, 2.5_r})}}), 1);
  const std::vector<Derivation> all = riemann_hilbert_derivations(problem);
  REQUIRE(all.size() == 1);
  check_says(all[0], {"s_0 = 1/10", "s_1 = 3/5", "-0.40030177520230828358748137134", "0.2789364365421476101051427811",
                      "N = 5"});
}
