#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::vi_energy_identity {
namespace {

/// The formula factor_log sum_{i<j} J_i J_j r^2 log r + factor_jump sum_k (s_k - s_{k-1}) T(c_k)^2. J_i are the jumps
/// of t at the ends of cells, r their distances.
struct EnergyFormula {
  Real50 factor_log = 1 / numeric::pi<Real50>();
  Real50 factor_jump = Real50(1) / 2;
  enum class At { jump, cell_end } at = At::jump;  ///< the point at which T is evaluated
  bool modulus = false;                            ///< use |s_k - s_{k-1}|
};

/// Forces q_i = t_i h_i on cells with sum q = 0.
struct CellForces {
  CellFrictionSteps steps;
  ContactProblem problem;
  CellMesh mesh;
  std::vector<Real50> q;
  /// The sum of the absolute values of the energy's terms. Energies are divided by it.
  double scale = 0;
};

std::string text_of(const CellForces& c) {
  return text_of(c.steps) + ", " + std::to_string(c.mesh.size()) + (c.mesh.is_uniform() ? " equal cells" : " cells");
}

/// Returns -(1/pi) <t * log|x|, t>, up to the factor. log r is the fourth derivative of r^2 log r/2 plus a polynomial.
/// The polynomial contributes nothing, because sum J = 0 and sum J x = 0.
Real50 logarithmic_sum(const CellForces& c) {
  const std::vector<double>& x = c.mesh.edges();
  std::vector<Real50> jump(x.size(), Real50(0));
  for (std::size_t i = 0; i < c.q.size(); ++i) {
    const Real50 t = c.q[i] / (Real50(x[i + 1]) - Real50(x[i]));
    jump[i] += t;
    jump[i + 1] -= t;
  }
  Real50 sum = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const Real50 r = Real50(x[j]) - Real50(x[i]);
      sum += jump[i] * jump[j] * r * r * log(r);
    }
  }
  return sum;
}

/// Returns T at xi, or at the left end of its cell.
Real50 force_before(const CellForces& c, double xi, EnergyFormula::At at) {
  const std::size_t cell = c.mesh.cell_at(xi);
  Real50 sum = 0;
  for (std::size_t i = 0; i < cell; ++i) sum += c.q[i];
  if (at == EnergyFormula::At::cell_end) return sum;
  const Real50 left = c.mesh.left(cell);
  return sum + c.q[cell] * (xi - left) / (c.mesh.right(cell) - left);
}

/// Returns the logarithmic term and one term for each jump.
std::vector<Real50> energy_terms(const CellForces& c, const EnergyFormula& formula) {
  std::vector<Real50> terms{formula.factor_log * logarithmic_sum(c)};
  const auto& [s, jumps] = c.steps;
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    const Rational step = s[k + 1] - s[k];
    const Real50 t = force_before(c, c.mesh.place(jumps[k]), formula.at);
    const Real50 term = formula.factor_jump * to_real<Real50>(step) * t * t;
    terms.push_back(formula.modulus ? abs(term) : term);
  }
  return terms;
}

CellForces random_forces(Random& random, std::size_t k) {
  constexpr std::array<Cells, 3> kinds{Cells::equal, Cells::unequal, Cells::graded};
  CellFrictionSteps steps = random_steps(random, k % 2 == 1 ? Trend::falling : Trend::any, 2, 3);
  // Every other jump lies between two cells.
  const std::size_t cells = 8 * (1 + random.below(2));
  if (k % 2 == 0)
    steps = {{steps.s[0], steps.s[1]}, {Rational(static_cast<long>(1 + random.below(5)), 4) - Rational(3, 4)}};
  if (random.below(2) == 0) steps = mirrored(steps);
  const ContactProblem problem = cell_problem(steps);
  CellForces c{steps, problem, random_cells(random, problem, kinds[k % 3], cells), {}};
  Real50 sum = 0;
  for (std::size_t i = 0; i < c.mesh.size(); ++i) {
    c.q.push_back(to_real<Real50>(random.between(-1, 1)));
    sum += c.q.back();
  }
  for (Real50& force : c.q) force -= sum / static_cast<int>(c.mesh.size());
  for (const Real50& term : energy_terms(c, {})) c.scale += std::abs(static_cast<double>(term));
  return c;
}

CaseList<CellForces> forces(const Context& context) {
  return random_cases(context, "vi-energy-identity", 60, 6, "random meshes, frictions of both signs and tractions",
                      random_forces);
}

/// Returns q.(B t), summed over the entries.
double by_entries(const CellForces& c, const GalerkinOperator& b) {
  Real50 sum = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) sum += c.q[i] * Real50(b.entry(i, j) / c.mesh.length(j)) * c.q[j];
  }
  return static_cast<double>(sum);
}

double by_products(const CellForces& c, const GalerkinOperator& b) {
  std::vector<double> t;
  for (std::size_t i = 0; i < b.size(); ++i) t.push_back(static_cast<double>(c.q[i]) / c.mesh.length(i));
  std::vector<double> product(b.size());
  b.multiply(t, product);
  double sum = 0;
  for (std::size_t i = 0; i < b.size(); ++i) sum += static_cast<double>(c.q[i]) * product[i];
  return sum;
}

/// Returns the energy on equal cells: (1/pi) int_0^oo |t^(k)|^2/k dk with t^ = sum J e^(-ikx)/(ik). Hurwitz' zeta
/// function gives the sum over the periods of the numerator.
double by_fourier(const CellForces& c) {
  const double h = c.mesh.length(0);
  std::vector<double> jump(c.q.size() + 1, 0);
  for (std::size_t i = 0; i < c.q.size(); ++i) {
    jump[i] += static_cast<double>(c.q[i]) / h;
    jump[i + 1] -= static_cast<double>(c.q[i]) / h;
  }
  constexpr double turn = 2 * std::numbers::pi;
  const auto density = [&](double angle) {
    std::complex<double> sum = 0;
    for (std::size_t m = 0; m < jump.size(); ++m) sum += jump[m] * std::polar(1.0, -angle * static_cast<double>(m));
    return std::norm(sum) * -boost::math::polygamma(2, angle / turn) / (2 * std::pow(turn, 3));
  };
  double integral = 0;
  constexpr int panels = 4;
  for (int k = 0; k < panels; ++k) {
    integral +=
        boost::math::quadrature::gauss<double, 20>::integrate(density, turn * k / panels, turn * (k + 1) / panels);
  }
  return h * h / std::numbers::pi * integral;
}

Values measured(const CellForces& c) {
  const GalerkinOperator b(c.mesh, numeric::variational::cell_friction(c.problem, c.mesh));
  Values values{{"entries", by_entries(c, b) / c.scale}, {"products", by_products(c, b) / c.scale}};
  if (c.mesh.is_uniform()) values.add({"logarithm", by_fourier(c)});
  return values;
}

Values predicted(const CellForces& c, const EnergyFormula& formula) {
  const std::vector<Real50> terms = energy_terms(c, formula);
  Real50 sum = 0;
  for (const Real50& term : terms) sum += term;
  const Real50 energy = sum / c.scale;
  Values values{{"entries", energy}, {"products", energy}};
  if (c.mesh.is_uniform()) values.add({"logarithm", terms.front()});
  return values;
}

auto with(const EnergyFormula& formula) {
  return [formula](Values& p, const CellForces& c) { p = predicted(c, formula); };
}

}  // namespace

Claim claim() {
  const auto pi = numeric::pi<Real50>();
  return compared<CellForces>("vi-energy-identity")
      .cases(forces)
      .precision(Precision::in_double)
      .measured(measured)
      .predicted([](const CellForces& c) { return predicted(c, {}); })
      .wrong("the jumps without the factor 1/2", with({.factor_jump = 1}))
      .wrong("`s_{k-1} - s_k` instead of `s_k - s_{k-1}`", with({.factor_jump = -Real50(1) / 2}))
      .wrong("`|s_k - s_{k-1}|` instead of `s_k - s_{k-1}`", with({.modulus = true}))
      .wrong("`T` taken at the end of the jump's cell", with({.at = EnergyFormula::At::cell_end}))
      .wrong("`1/(2 pi)` instead of `1/pi` before the logarithmic term", with({.factor_log = 1 / (2 * pi)}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::vi_energy_identity
