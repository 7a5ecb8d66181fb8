// Solutions of the problem on cells: that there is one, and where there is no other.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/variational/active_set.hpp"
#include "numeric/variational/certificate.hpp"
#include "numeric/variational/lemke.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/interior_point.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::variational::ActiveSetResult;
using numeric::variational::CellMesh;
using numeric::variational::CellSet;
using numeric::variational::DiscreteProblem;
using numeric::variational::DiscreteState;
using numeric::variational::GalerkinOperator;
using numeric::variational::LemkeResult;

constexpr std::array<Cells, 3> kinds{Cells::equal, Cells::unequal, Cells::graded};

/// A problem on cells under its load, and under twice the load.
struct Pair {
  DiscreteProblem problem;
  DiscreteProblem doubled;
};

Pair random_pair(Random& random, std::size_t k, Trend trend, const Rational& largest, bool may_tilt) {
  CellFrictionSteps steps = random_steps(random, trend, largest, 4);
  if (random.below(2) == 0) steps = mirrored(steps);
  const Rational load = random.between(Rational(1, 5), 4);
  std::optional<Rational> load_at;
  if (may_tilt && random.below(4) == 0) load_at = random.between(Rational(-1, 2), Rational(1, 2));
  const Polynomial profile = random_profile(random, k % 2 == 0);
  const ContactProblem problem = cell_problem(steps, profile, load, load_at);
  const CellMesh mesh = random_cells(random, problem, kinds[k % 3], 16 + random.below(24));
  return {{problem, mesh}, {cell_problem(steps, profile, 2 * load, load_at), mesh}};
}

/// Where short cells meet strong friction the paths turn back again and again: of 1800 random problems 30 take more
/// than 100 n pivots, the longest 168 000 with 30 cells. A path that is not followed to its end says nothing.
int most_pivots(const DiscreteProblem& problem) { return 2000 * static_cast<int>(problem.size()); }

std::string text_of(const DiscreteProblem& problem, std::size_t k) {
  return "problem " + std::to_string(k) + ", " + std::to_string(problem.size()) + " cells" +
         (problem.load_at() ? ", tilting" : "");
}

/// B as it is said to be, and what the certificate is shown.
struct ExistenceSaid {
  int logarithm = 1;
  bool from_left = false;  ///< int s p from the left end whatever the sign of s
  double unit = 1;         ///< of lengths, over the support's
  double moved = 0;        ///< the pressures, in units of what the certificate allows
};

std::vector<Evidence> check_existence(const Context& context, const ExistenceSaid& said) {
  const Quantity entries{
      "size of negative entries of the operator, over the largest entry", {"its entries", "none"}, tolerance<double>()};
  const Quantity residual{"residuals of the state found, in units of what the certificate allows",
                          {"Lemke's method", "the certificate, from the state alone"},
                          1,
                          0.75};
  return gather([&] {
    Random random(context.seed, "vi-discrete-existence");
    Findings findings;
    const std::size_t count = context.quick ? 12 : 300;
    for (std::size_t k = 0; k < count; ++k) {
      // Weak and strong friction: the largest s is 1/5 to 20.
      const Rational largest = k % 2 == 0 ? random.between(Rational(1, 5), 2) : random.between(2, 20);
      const DiscreteProblem problem = random_pair(random, k, Trend::any, largest, true).problem;
      findings.begin_case(text_of(problem, k));
      const GalerkinOperator& b = problem.influence();
      double least = 0;
      double most = 0;
      double diagonal = HUGE_VAL;
      for (std::size_t i = 0; i < b.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
          double slip = b.slip(i, j);
          if (said.from_left && b.friction().sign < 0) {
            slip = j < i ? b.friction().whole[j] : i == j ? b.friction().whole[i] + b.friction().own[i] : 0;
          }
          const double shift = problem.mesh().length(j) * std::log(said.unit) / std::numbers::pi;
          const double entry = said.logarithm * b.logarithm(i, j) + shift + slip;
          least = std::min(least, entry);
          most = std::max(most, entry);
          if (i == j) diagonal = std::min(diagonal, entry);
        }
      }
      findings.compare(entries, -least / most);
      findings.require(diagonal > 0, "an entry of the diagonal is not positive");

      const LemkeResult found = numeric::variational::lemke(problem, most_pivots(problem));
      if (!found.reached) {
        findings.skip(residual);
        continue;
      }
      const double allowed = certify(problem, found.state).allowed;
      DiscreteState state = found.state;
      for (double& p : state.pressure) p *= 1 + said.moved * allowed;
      const auto certificate = certify(problem, state);
      findings.compare(residual, std::max({certificate.natural, certificate.equation, certificate.load,
                                           certificate.moment, certificate.product}) /
                                     allowed);
    }
    return findings.evidence("random meshes, frictions up to s = 20, profiles and loads, one in four tilting, seed " +
                             std::to_string(context.seed));
  });
}

CellSet random_set(Random& random, std::size_t cells) {
  CellSet set(cells, 0);
  for (char& cell : set) cell = random.below(2) == 0;
  set[random.below(cells)] = 1;
  return set;
}

/// The solutions that active sets find from these sets, where they do.
std::vector<DiscreteState> solutions(const DiscreteProblem& problem, const std::vector<CellSet>& starts) {
  std::vector<DiscreteState> result;
  for (const CellSet& start : starts) {
    const ActiveSetResult found =
        active_set(problem, start, {std::vector<double>(problem.size(), 0)}, numeric::variational::ActiveSetOptions{});
    if (found.outcome == ActiveSetResult::Outcome::solved) result.push_back(found.state);
  }
  return result;
}

struct UniquenessSaid {
  bool rising = true;    ///< else a fall of s under a parabola on eight cells, from every contact set
  bool doubled = false;  ///< the load, for interior points
  double moved = 0;
};

/// s falls by 5: complementary are the contacts of the first cell, of the first and the fifth, and of these and the
/// fourth.
Pair falling_pair() {
  const auto under = [](const Rational& load) {
    const ContactProblem problem = cell_problem({{5, 0}, {0}}, Polynomial({0, 0, 1}), load);
    return DiscreteProblem(problem, CellMesh(problem, 8));
  };
  return {under(Rational(1, 2)), under(1)};
}

std::vector<Evidence> check_uniqueness(const Context& context, const UniquenessSaid& said) {
  const Quantity forces{
      "forces on all cells", {"active sets, from random sets of cells", "interior points"}, tolerance<double>(), 0.5};
  return gather([&] {
    Random random(context.seed, "thm-01-uniqueness-on-cells");
    Findings findings;
    const std::size_t count = context.quick ? 10 : 200;
    for (std::size_t k = 0; k < count; ++k) {
      const Rational largest = random.between(Rational(1, 5), 3);
      const Pair pair = said.rising ? random_pair(random, k, Trend::rising, largest, false) : falling_pair();
      const DiscreteProblem& problem = pair.problem;
      std::vector<CellSet> starts;
      for (unsigned bits = 1; bits < 256 && !said.rising; ++bits) {
        starts.emplace_back(8, 0);
        for (unsigned i = 0; i < 8; ++i) starts.back()[i] = static_cast<char>(bits >> i & 1U);
      }
      for (int i = 0; i < 4 && said.rising; ++i) starts.push_back(random_set(random, problem.size()));
      const std::vector<DiscreteState> found = solutions(problem, starts);
      findings.begin_case(text_of(problem, k), found.size() > 1);
      auto other = forces_by_interior_points(said.doubled ? pair.doubled : problem);
      if (found.empty() || !other) {
        findings.skip(forces);
        continue;
      }
      *other *= 1 + said.moved;
      for (const DiscreteState& state : found) findings.compare(forces, difference(forces_of(problem, state), *other));
    }
    return findings.evidence("random meshes, rising frictions, profiles and loads, four sets each, seed " +
                             std::to_string(context.seed));
  });
}

}  // namespace

std::vector<Claim> cell_solution_claims() {
  using E = ExistenceSaid;
  using U = UniquenessSaid;
  std::vector<Claim> claims;
  claims.push_back(
      make_claim(claim_text("vi-discrete-existence"), check_existence, E(),
                 std::vector<Wrong<E>>{
                     {"the logarithm with the other sign", changed<E>([](E& said) { said.logarithm = -1; })},
                     {"negative s integrated from the left end", changed<E>([](E& said) { said.from_left = true; })},
                     {"lengths in units of half the support's", changed<E>([](E& said) { said.unit = 0.5; })},
                     {"near miss: pressures moved by ten times what the certificate allows",
                      changed<E>([](E& said) { said.moved = 10; })}}));
  claims.push_back(make_claim(
      claim_text("thm-01-uniqueness-on-cells"), check_uniqueness, U(),
      std::vector<Wrong<U>>{
          {"s falling by 5: a problem with three solutions", changed<U>([](U& said) { said.rising = false; })},
          {"twice the load for one of the methods", changed<U>([](U& said) { said.doubled = true; })},
          {"near miss: forces moved by ten times the tolerance",
           changed<U>([](U& said) { said.moved = near_miss<double>(); })}}));
  return claims;
}

}  // namespace steadyslide::proofs_checks
