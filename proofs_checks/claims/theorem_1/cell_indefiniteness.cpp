// How the symmetric part of the operator on cells ceases to be positive definite on tractions of zero mean, where
// friction falls.

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/cell_law.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::variational::CellMesh;

double smallest_eigenvalue(const Eigen::MatrixXd& form) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(form, Eigen::EigenvaluesOnly).eigenvalues()(0);
}

/// A law for sup T(c)^2/E on equal cells: see PointValueLaw.
struct LostSaid {
  PointValueLaw law;
  int sign = 1;  ///< -1: the jump the other way round
};

/// At the centre, c = 0, where two of N = 2^k cells meet: the law's error falls with the cells' length.
ConvergenceRate check_rate(Findings& findings, const PointValueLaw& law, int last) {
  double before = 0;
  double rate = 0;
  double rate_before = 0;
  const CellFrictionSteps none{{0, 0}, {0}};
  for (int k = 4; k <= last; ++k) {
    const std::size_t n = std::size_t{1} << static_cast<unsigned>(k);
    const CellMesh mesh(cell_problem(none), n);
    const Eigen::MatrixXd logarithm = symmetric_part(mesh, operator_of(none, mesh), false);
    const double error =
        std::abs(largest_point_value(logarithm, weights_of(mesh, 0), true) - law(static_cast<double>(n), 0));
    findings.begin_case(std::to_string(n) + " equal cells, jump in the middle");
    if (k > 4) {
      rate_before = rate;
      rate = std::log2(before / error);
      findings.require(std::abs(rate - 1) <= 0.15, "the error of sup T(c)^2/E falls with the power " +
                                                       short_text(rate) + " of the cells' length, not with the first");
    }
    before = error;
  }
  return {"distance of sup(T(c)^2/E) on N equal cells from its law, as a power of 1/N",
          rate,
          std::abs(rate - rate_before),
          1,
          0.1,
          "N = 16 to " + std::to_string(1 << last) + ", doubled; the last rate, and how far the one before is off it"};
}

void check_sign(Findings& findings, const LostSaid& said, const Rational& step, const Rational& c, std::size_t n) {
  static const std::string statement = "the law foretells whether the symmetric part is positive definite";
  const CellFrictionSteps steps = said.sign > 0 ? CellFrictionSteps{{step, 0}, {c}} : CellFrictionSteps{{0, step}, {c}};
  const CellMesh mesh(cell_problem(steps), n);
  const bool definite = smallest_eigenvalue(on_zero_mean(symmetric_part(mesh, operator_of(steps, mesh), true))) > 0;
  const double limit = 2 / numeric::to_real<double>(step);
  const double value = said.law(static_cast<double>(n), numeric::to_real<double>(c));
  findings.begin_case("s falls by " + to_string(step) + " at " + to_string(c) + ", " + std::to_string(n) +
                      " equal cells");
  findings.require(definite == (value < limit), std::string("the smallest eigenvalue is ") +
                                                    (definite ? "positive" : "negative") + "; " + statement);
  findings.compare(
      {"sign of the smallest eigenvalue", {"eigenvalues of the matrix of entries", "the law for sup(T(c)^2/E)"}, 0.5},
      0);
}

std::vector<Evidence> check_lost(const Context& context, const LostSaid& said) {
  return gather([&] {
    Random random(context.seed, "vi-definiteness-lost");
    Findings findings;
    const auto both_sides = [&](const Rational& step, const Rational& c) {
      const double limit = 2 / numeric::to_real<double>(step);
      const double n = LostSaid().law.cells(limit, numeric::to_real<double>(c));
      for (const double factor : {0.9, 1.1}) {
        const auto cells = 2 * static_cast<std::size_t>(std::lround(factor * n / 2));
        // A jump inside a cell is felt less than one between two: the law says how much less.
        const double value = PointValueLaw()(static_cast<double>(cells), numeric::to_real<double>(c));
        if (std::abs(value - limit) > 0.02) check_sign(findings, said, step, c, cells);
      }
    };
    both_sides(1, 0);
    const ConvergenceRate rate = check_rate(findings, said.law, context.quick ? 7 : 10);
    if (!context.quick) both_sides(Rational(7, 10), 0);
    for (std::size_t k = 0; k < (context.quick ? 4U : 20U); ++k) {
      both_sides(random.between(Rational(9, 10), Rational(5, 4)), random.between(Rational(-1, 2), Rational(1, 2)));
    }
    std::vector<Evidence> all =
        findings.evidence("falling jumps, N 10 % on either side, seed " + std::to_string(context.seed));
    all.emplace_back(rate);
    return all;
  });
}

/// sup T(0)^2/E = slope log(1/d) + constant, d the smallest cell over the support's length.
struct GradedSaid {
  double slope = 1 / std::numbers::pi;
  bool constant = true;  ///< as measured at two larger d
  double moved = 0;
  int sign = 1;
};

CellMesh graded_cells(double smallest) {
  return {cell_problem({{0, 0}, {0}}), Rational(0),
          numeric::variational::graded_edges(-0.5, 0.5, smallest, 2, 0.03125)};
}

double point_value(double smallest) {
  const CellMesh mesh = graded_cells(smallest);
  return largest_point_value(symmetric_part(mesh, operator_of({{0, 0}, {0}}, mesh), false), weights_of(mesh, 0), true);
}

std::vector<Evidence> check_graded(const Context& context, const GradedSaid& said) {
  return gather([&] {
    Random random(context.seed, "vi-definiteness-lost-graded");
    Findings findings;
    // Extrapolated: both sizes are at least a thousand times as large as those foretold.
    double constant = 0;
    for (const double d : {1e-3, 1e-4}) constant += (point_value(d) + said.slope * std::log(d)) / 2;
    for (std::size_t k = 0; k < (context.quick ? 3U : 12U); ++k) {
      const Rational step = k == 0 ? Rational(3, 10) : random.between(Rational(1, 4), Rational(9, 25));
      const double limit = 2 / numeric::to_real<double>(step);
      const double foretold = std::exp(((said.constant ? constant : 0) + said.moved - limit) / said.slope);
      for (const double factor : {1.1, 1 / 1.1}) {
        findings.begin_case("s falls by " + to_string(step) + ", smallest cell " + short_text(factor * foretold));
        // Beyond the smallest numbers there are no cells.
        findings.require(factor * foretold > 1e-200 && factor * foretold < 1, "no such cells");
        const CellMesh mesh = graded_cells(factor * foretold);
        const CellFrictionSteps steps =
            said.sign > 0 ? CellFrictionSteps{{step, 0}, {0}} : CellFrictionSteps{{0, step}, {0}};
        const double least = smallest_eigenvalue(on_zero_mean(symmetric_part(mesh, operator_of(steps, mesh), true)));
        findings.require((least > 0) == (factor > 1),
                         "the smallest eigenvalue, " + short_text(least) + ", has the other sign");
        findings.compare({"sign of the smallest eigenvalue",
                          {"eigenvalues of the matrix of entries", "the law for sup(T(c)^2/E)"},
                          0.5},
                         0);
      }
    }
    return findings.evidence("smallest cell 10 % on either side, ratio 2, seed " + std::to_string(context.seed));
  });
}

}  // namespace

std::vector<Claim> cell_indefiniteness_claims() {
  using L = LostSaid;
  using G = GradedSaid;
  std::vector<Claim> claims;
  claims.push_back(
      make_claim(claim_text("vi-definiteness-lost"), check_lost, L(),
                 std::vector<Wrong<L>>{
                     {"half the slope: log(N)/(2 pi)", changed<L>([](L& said) { said.law.slope /= 2; })},
                     {"the logarithm alone, no constant", changed<L>([](L& said) { said.law.constant = false; })},
                     {"s rising instead of falling", changed<L>([](L& said) { said.sign = -1; })},
                     {"Lambda = phi, as without cells", changed<L>([](L& said) { said.law.cells_form = false; })},
                     {"near miss: the constant moved by 1/1000", changed<L>([](L& said) { said.law.moved = 1e-3; })}}));
  claims.push_back(
      make_claim(claim_text("vi-definiteness-lost-graded"), check_graded, G(),
                 std::vector<Wrong<G>>{
                     {"half the slope: log(1/h)/(2 pi)", changed<G>([](G& said) { said.slope /= 2; })},
                     {"the logarithm alone, no constant", changed<G>([](G& said) { said.constant = false; })},
                     {"s rising instead of falling", changed<G>([](G& said) { said.sign = -1; })},
                     {"near miss: h foretold a sixth too large", changed<G>([](G& said) { said.moved = 0.05; })},
                     {"near miss: h foretold a sixth too small", changed<G>([](G& said) { said.moved = -0.05; })}}));
  return claims;
}

}  // namespace steadyslide::proofs_checks
