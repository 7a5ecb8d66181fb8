#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/instruments/operators/angle_forms.hpp"
#include "proofs_checks/instruments/tractions/friction_values.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::sec_31_coercive {
namespace {

/// A traction sum_k c_k T_k/sqrt(1-x^2), k >= 1, and cells.
struct Coercive {
  Rational s;
  std::vector<Rational> c;
  CellFrictionSteps steps;
  CellMesh mesh;
};

std::string text_of(const Coercive& c) { return "s = " + to_string(c.s); }

/// Returns the cases. With `falling` the friction on cells falls to zero at 1/7.
CaseList<Coercive> cases(const Context& context, bool falling) {
  const CaseList<FrictionValue> frictions = frictions_of_both_signs(context, "sec-31-coercive");
  Random random(context.seed, "sec-31-coercive-cells");
  CaseList<Coercive> list{{}, "`s` of both signs, random coefficients and cells, seed " + std::to_string(context.seed)};
  for (const auto& [s] : frictions.cases) {
    std::vector<Rational> c{0};
    for (int k = 1; k <= 4; ++k) c.push_back(random.between(-2, 2));
    // All values have the same sign.
    const CellFrictionSteps steps{{s, falling ? Rational(0) : s}, {Rational(1, 7)}};
    list.cases.push_back({s, c, steps, random_cells(random, cell_problem(steps), Cells::unequal, 24)});
  }
  return list;
}

/// Returns b(t, t).
template <Real R>
R energy(const Coercive& at) {
  std::vector<R> c;
  for (const Rational& coefficient : at.c) c.push_back(to_real<R>(coefficient));
  return value_of(log_form_by_quadrature<R>(R(2)), c, c) / numeric::pi<R>() +
         to_real<R>(at.s) / 2 * value_of(sign_form_by_quadrature<R>(), c, c);
}

/// Returns eigenvalues and norm of b on zero mean. The scalar product is b without friction.
Values on_cells(const Coercive& c) {
  const auto b = operator_of(c.steps, c.mesh);
  const Eigen::MatrixXd logarithm = on_zero_mean(symmetric_part(c.mesh, b, false));
  const Eigen::VectorXd values = eigenvalues(on_zero_mean(symmetric_part(c.mesh, b, true)), logarithm);
  return {{"least", values.minCoeff()},
          {"largest", values.maxCoeff()},
          {"norm", spectral_norm(in_metric(on_zero_mean(gap_of_forces(b, c.mesh)), logarithm))}};
}

Values predicted(const Coercive& at) {
  Number squares = 0;
  for (std::size_t k = 1; k < at.c.size(); ++k) squares += to_real<Number>(at.c[k] * at.c[k]) / (2 * k);
  return {{"energy", Number(numeric::pi<Number>() * squares)},
          {"least", Number(1)},
          {"largest", Number(1)},
          {"norm", Number(1 / cos_pi_alpha<Number>(at.s))}};
}

}  // namespace

Claim claim() {
  const std::vector<std::string> energies{"energy", "least", "largest"};
  return compared<Coercive>("sec-31-coercive")
      .cases([](const Context& context) { return cases(context, false); })
      .effective_where([](const Coercive& c) { return c.s != 0; })
      .measured([]<Real R>(const Coercive& c) {
        Values values = on_cells(c);
        values.add({"energy", energy<R>(c)});
        return values;
      })
      .predicted(predicted)
      .wrong("`sqrt(1+s^2)` in the energy",
             scaled(energies, [](const Coercive& c) { return 1 / cos_pi_alpha<Number>(c.s); }))
      .wrong("twice the energy", scaled(energies, 2))
      .wrong("the bound without friction", [](Values& p) { p["norm"] = 1; })
      .wrong_beyond("friction that jumps", [](const Context& context) { return cases(context, true); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::sec_31_coercive
