#include "symbolic/riemann_hilbert/closed_form_derivation.hpp"
#include "support/test.hpp"

using namespace steadyslide::symbolic;

namespace {

constexpr ClosedFormKind kinds[] = {
    ClosedFormKind::flat_punch,         ClosedFormKind::tilted_punch,
    ClosedFormKind::lifted_punch,       ClosedFormKind::parabola,
    ClosedFormKind::parabola_left_edge, ClosedFormKind::parabola_right_edge,
    ClosedFormKind::parabola_two_edges, ClosedFormKind::quartic,
};

bool says(const Derivation& derivation, const std::string& text) { return holds(to_text(derivation), text); }

}  // namespace

TEST_CASE("every closed form is derived with up to four jumps, in the same words every time") {
  for (const ClosedFormKind kind : kinds) {
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
  CHECK(says(d, "p_0 = -1/2 - alpha_0"));
  CHECK(says(d, "p_1 = alpha_0 - alpha_1"));
  CHECK(says(d, "p_2 = -1/2 + alpha_1"));
  CHECK(says(d, "S = -1"));
  CHECK(says(d, "N = -P/pi"));
  CHECK(says(d, "(s+i) Y+ = |Y|/cos(pi alpha)"));
}

TEST_CASE("the parabola and the quartic: factor and conditions") {
  const Derivation parabola = closed_form_derivation(ClosedFormKind::parabola, 2);
  CHECK(says(parabola, "N = 1/R"));
  CHECK(says(parabola, "(s+i) Y+ = -|Y|/cos(pi alpha)"));
  CHECK(says(parabola, "S = 1"));
  const Derivation quartic = closed_form_derivation(ClosedFormKind::quartic, 0);
  CHECK(says(quartic, "N = kappa*x^2 + kappa*sigma_1*x"));
}

TEST_CASE("a problem's own derivation has its numbers") {
  const ContactProblem problem(Elasticity::reduced(0.5_r), FrictionProfile({0.2_r, 1.2_r}, {0}),
                               Indenter(-1, {{1, Polynomial({0, 0, 2.5_r})}}), 1);
  const std::vector<Derivation> all = riemann_hilbert_derivations(problem);
  REQUIRE(all.size() == 1);
  CHECK(says(all[0], "s_0 = 1/10"));
  CHECK(says(all[0], "s_1 = 3/5"));
  CHECK(says(all[0], "-0.40030177520230828358748137134"));
  CHECK(says(all[0], "0.2789364365421476101051427811"));
  CHECK(says(all[0], "N = 5"));
}
