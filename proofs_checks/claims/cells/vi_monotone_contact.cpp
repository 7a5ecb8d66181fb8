// While the set K of cells in contact stays the same, a growing load adds the punch of K: pressures x with B_KK x = 1,
// up to a factor. Suppose that x > 0 for every K, and that no cell outside of K penetrates a level punch, (B x)_i < 1
// there. Then cells only join the contact, no pressure falls, and there is one solution for every load: followed back
// to load zero, all solutions shrink to the lowest cell. On the continuum this punch is Galin's t0. It has one sign for
// any number of contact components and friction jumps: |Y| times a polynomial with one zero in each gap. On cells the
// two conditions must be examined. They hold on equal cells for s up to 1/2. They fail if s falls by 3/5, and on cells
// of alternating lengths even without friction. If the indenter may tilt, contact may be lost as the load grows.

#include <algorithm>
#include <cmath>

#include "numeric/variational/lemke.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::vi_monotone_contact {
namespace {

using numeric::variational::LemkeResult;

/// The punch of some cells, or a profile under two loads, the second `growth` times as large as the first.
struct OnCells {
  CellFrictionSteps steps;
  CellMesh mesh;
  std::vector<std::size_t> contact = {};  ///< cells of the punch
  std::vector<std::size_t> others = {};
  Polynomial profile = Polynomial();
  Rational load = 0;
  Rational growth = 1;
  std::optional<Rational> load_at = {};
};

std::string text_of(const OnCells& c) {
  const std::string cells = std::to_string(c.mesh.size()) + " cells";
  if (c.load == 0) return text_of(c.steps) + ", " + std::to_string(c.contact.size()) + " of " + cells;
  return text_of(c.steps) + ", " + cells + ", loads " + to_string(c.load) + " and " +
         to_string(Rational(c.load * c.growth));
}

/// The range of the cases.
struct DataRange {
  Rational largest{1, 2};  ///< largest s
  Cells cells = Cells::equal;
  std::optional<Rational> growth = {};  ///< if absent, random from 1 to 3
};

CellFrictionSteps random_friction(Random& random, const DataRange& range) {
  const CellFrictionSteps steps = random_steps(random, Trend::any, range.largest, 3);
  return random.below(2) == 0 ? mirrored(steps) : steps;
}

OnCells random_loads(Random& random, const DataRange& range, bool convex) {
  const CellFrictionSteps steps = random_friction(random, range);
  const Polynomial profile = random_profile(random, convex);
  const Rational load = random.between(Rational(1, 50), 3);
  const Rational growth = range.growth ? *range.growth : 1 + random.between(Rational(1, 50), 2);
  return {steps, CellMesh(cell_problem(steps), 16 + random.below(32)), {}, {}, profile, load, growth};
}

OnCells random_punch_of_cells(Random& random, const DataRange& range) {
  const CellFrictionSteps steps = random_friction(random, range);
  OnCells c{steps, random_cells(random, cell_problem(steps), range.cells, 8 + random.below(32))};
  const std::size_t share = 1 + random.below(4);
  for (std::size_t i = 0; i < c.mesh.size(); ++i) (random.below(4) < share ? c.contact : c.others).push_back(i);
  if (c.contact.empty()) c.contact.push_back(c.others.back());
  return c;
}

auto within(const DataRange& range) {
  return [range](const Context& context) {
    Random random(context.seed, "vi-monotone-contact");
    CaseList<OnCells> list{{},
                           "random frictions, contact sets, profiles and loads, seed " + std::to_string(context.seed)};
    for (std::size_t k = 0; k < (context.quick ? 15U : 400U); ++k) {
      list.cases.push_back(random_loads(random, range, k % 2 == 0));
      list.cases.push_back(random_punch_of_cells(random, range));
    }
    return list;
  };
}

/// Returns a profile with two bumps; the load acts close to the right one, so that some cells of the left one lose
/// contact.
CaseList<OnCells> tilting(const Context&) {
  const CellFrictionSteps none{{0, 0}, {0}};
  OnCells c{none, CellMesh(cell_problem(none), 32)};
  c.profile = Polynomial({0, 0, Rational(-9, 10), 0, 1});
  c.load = Rational(13, 10);
  c.growth = 3;
  c.load_at = Rational(5, 8);
  return {{c}, "two bumps"};
}

/// Returns the tension and the penetration of the punch, both zero if t0 has one sign and nothing penetrates.
Values punch_of_cells(const OnCells& c) {
  const auto b = operator_of(c.steps, c.mesh);
  const auto block = [&](const std::vector<std::size_t>& rows) {
    return matrix_of(rows.size(), c.contact.size(),
                     [&](std::size_t i, std::size_t j) { return b.entry(rows[i], c.contact[j]); });
  };
  const Eigen::MatrixXd among = block(c.contact);
  const Eigen::VectorXd x = linear_solution(among, Eigen::VectorXd::Ones(among.rows()));
  Values values{{"tension", std::max(-x.minCoeff() / x.cwiseAbs().maxCoeff(), 0.0)}};
  if (!c.others.empty()) values.add({"penetration", std::max((block(c.others) * x).maxCoeff() - 1, 0.0)});
  return values;
}

LemkeResult solved(const OnCells& c, const Rational& load) {
  const ContactProblem problem = cell_problem(c.steps, c.profile, load, c.load_at);
  LemkeResult result = lemke(DiscreteProblem(problem, c.mesh), 100 * static_cast<int>(c.mesh.size()));
  if (!result.reached) throw Refutation{{text_of(c), "Lemke's path does not reach the load " + to_string(load)}};
  for (double& value : result.state.pressure) value *= to_real<double>(load);
  return result;
}

/// Returns the largest fall of a pressure, and the largest pressure in a cell that loses contact. For a cell with
/// almost no pressure, rounding decides if it is in contact.
Values under_both_loads(const OnCells& c) {
  const LemkeResult small = solved(c, c.load);
  const LemkeResult large = solved(c, c.load * c.growth);
  const double scale = *std::ranges::max_element(small.state.pressure);
  double falls = 0;
  double lost = 0;
  for (std::size_t i = 0; i < c.mesh.size(); ++i) {
    const double p = small.state.pressure[i];
    falls = std::max(falls, (p - large.state.pressure[i]) / scale);
    if (small.contact[i] && !large.contact[i]) lost = std::max(lost, p / scale);
  }
  return {{"fall", falls}, {"lost", lost}};
}

}  // namespace

Claim claim() {
  return compared<OnCells>("vi-monotone-contact")
      .cases(within({}))
      .precision(Precision::in_double)
      .measured([](const OnCells& c) { return c.load == 0 ? punch_of_cells(c) : under_both_loads(c); })
      .predicted([](const OnCells& c) -> Values {
        if (c.load != 0) return {{"fall", 0.0}, {"lost", 0.0}};
        Values values{{"tension", 0.0}};
        if (!c.others.empty()) values.add({"penetration", 0.0});
        return values;
      })
      .wrong_beyond("the smaller load taken for the larger one", within({.growth = Rational(1, 2)}))
      .wrong_beyond("friction up to `s = 5`", within({.largest = 5}))
      .wrong_beyond("cells of alternating lengths", within({.cells = Cells::alternating}))
      .wrong_beyond("an indenter that may tilt", tilting)
      .wrong_beyond("near miss: the larger load less by ten times the tolerance",
                    within({.growth = 1 - Rational(1, 100'000'000'000)}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::vi_monotone_contact
