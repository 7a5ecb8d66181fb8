// The contact on cells as the load grows.
//
// While the set K of cells in contact stays, a growing load adds the punch of K: pressures x with B_KK x = 1, up to a
// factor. If x > 0 for every K, and nothing off K penetrates a level punch, (B x)_i < 1 there, then cells are only ever
// taken in, no pressure falls, and there is one solution for every load: followed back to no load, all of them shrink
// to the lowest cell. On the continuum this is Galin's t0, of one sign for any number of contact components and
// friction jumps: |Y| times a polynomial that has its zeros in the gaps, one in each. On cells it has to be examined.
// It holds on equal cells for s up to 1/2. It fails where s falls by 3/5, and on cells of alternating lengths even
// without friction. Where the indenter tilts, contact may be lost as the load grows.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "numeric/variational/lemke.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::variational::CellMesh;
using numeric::variational::DiscreteProblem;
using numeric::variational::GalerkinOperator;

struct LoadingSaid {
  Rational largest{1, 2};  ///< s
  Cells cells = Cells::equal;
  Rational larger_load = 0;  ///< the second load over the first one; 0: a random one
  bool tilts = false;
};

/// The punch of a random set: t0 of one sign, and no penetration.
void check_punch(Findings& findings, Random& random, const LoadingSaid& said) {
  const Quantity pressure{"tension under the punch of a random contact set, over its largest pressure",
                          {"linear system of the entries", "none: t_0 is of one sign"},
                          tolerance<double>()};
  const Quantity gap{"penetration of the punch on the other cells, over its depth",
                     {"linear system of the entries", "none: the punch is level"},
                     tolerance<double>()};
  CellFrictionSteps steps = random_steps(random, Trend::any, said.largest, 3);
  if (random.below(2) == 0) steps = mirrored(steps);
  const ContactProblem problem = cell_problem(steps);
  const CellMesh mesh = random_cells(random, problem, said.cells, 8 + random.below(32));
  const GalerkinOperator b(mesh, numeric::variational::cell_friction(problem, mesh));
  const std::size_t share = 1 + random.below(4);
  std::vector<std::size_t> contact;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < b.size(); ++i) (random.below(4) < share ? contact : others).push_back(i);
  if (contact.empty()) contact.push_back(others.back());
  const auto block = [&](const std::vector<std::size_t>& rows) {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(contact.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < contact.size(); ++j)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = b.entry(rows[i], contact[j]);
    }
    return result;
  };
  const Eigen::VectorXd level = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(contact.size()));
  const Eigen::VectorXd x = block(contact).partialPivLu().solve(level);
  findings.begin_case(text_of(steps) + ", " + std::to_string(contact.size()) + " of " + std::to_string(b.size()) +
                      " cells");
  findings.compare(pressure, std::max(0.0, -x.minCoeff() / x.cwiseAbs().maxCoeff()));
  if (!others.empty()) findings.compare(gap, std::max(0.0, (block(others) * x).maxCoeff() - 1));
}

/// The contact under a load, and under a larger one.
void check_loads(Findings& findings, Random& random, const LoadingSaid& said, bool convex) {
  const Quantity pressure{"fall of a pressure as the load grows, over the largest one",
                          {"Lemke's method", "Lemke's method under the larger load"},
                          tolerance<double>()};
  CellFrictionSteps steps = random_steps(random, Trend::any, said.largest, 3);
  if (random.below(2) == 0) steps = mirrored(steps);
  Polynomial profile = random_profile(random, convex);
  Rational load = random.between(Rational(1, 50), 3);
  Rational growth = said.larger_load == 0 ? 1 + random.between(Rational(1, 50), 2) : said.larger_load;
  std::optional<Rational> load_at;
  if (said.tilts) {
    // Two bumps, the load near the right one: some cells of the left one lose contact.
    steps = {{0, 0}, {0}};
    profile = Polynomial({0, 0, Rational(-9, 10), 0, 1});
    load = Rational(13, 10);
    growth = 3;
    load_at = Rational(5, 8);
  }
  const std::size_t cells = said.tilts ? 32 : 16 + random.below(32);
  const auto solved = [&](const Rational& p) {
    const ContactProblem problem = cell_problem(steps, profile, p, load_at);
    const DiscreteProblem discrete(problem, CellMesh(problem, cells));
    auto result = lemke(discrete, 100 * static_cast<int>(cells));
    findings.require(result.reached, "Lemke's path does not reach the load");
    for (double& value : result.state.pressure) value *= numeric::to_real<double>(p);
    return result;
  };
  findings.begin_case(text_of(steps) + ", " + std::to_string(cells) + " cells, loads " + to_string(load) + " and " +
                      to_string(Rational(load * growth)));
  const auto small = solved(load);
  const auto large = solved(load * growth);
  const double scale = *std::ranges::max_element(small.state.pressure);
  double falls = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const double p = small.state.pressure[i];
    falls = std::max(falls, (p - large.state.pressure[i]) / scale);
    // A cell on the verge of contact is in contact or not, as rounding decides.
    findings.require(!small.contact[i] || large.contact[i] || p <= tolerance<double>() * scale,
                     "cell " + std::to_string(i) + " is in contact under the smaller load only");
  }
  findings.compare(pressure, falls);
}

std::vector<Evidence> check(const Context& context, const LoadingSaid& said) {
  return gather([&] {
    Random random(context.seed, "vi-monotone-contact");
    Findings findings;
    for (std::size_t k = 0; k < (context.quick ? 15U : 400U); ++k) {
      check_loads(findings, random, said, k % 2 == 0);
      if (!said.tilts) check_punch(findings, random, said);
    }
    return findings.evidence("random frictions, contact sets, profiles and loads, seed " +
                             std::to_string(context.seed));
  });
}

}  // namespace

std::vector<Claim> cell_loading_claims() {
  return {make_claim(
      claim_text("vi-monotone-contact"), check, LoadingSaid{},
      std::vector<Wrong<LoadingSaid>>{
          {"the smaller load taken for the larger one",
           changed<LoadingSaid>([](LoadingSaid& said) { said.larger_load = Rational(1, 2); })},
          {"friction up to s = 5", changed<LoadingSaid>([](LoadingSaid& said) { said.largest = 5; })},
          {"cells of alternating lengths",
           changed<LoadingSaid>([](LoadingSaid& said) { said.cells = Cells::alternating; })},
          {"an indenter that may tilt", changed<LoadingSaid>([](LoadingSaid& said) { said.tilts = true; })},
          {"near miss: the larger load less by ten times the tolerance",
           changed<LoadingSaid>([](LoadingSaid& said) { said.larger_load = 1 - Rational(1, 100'000'000'000); })}})};
}

}  // namespace steadyslide::proofs_checks
