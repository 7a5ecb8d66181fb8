// Problem I on polynomials has one solution. [Bal16, proposition 7]

#include <algorithm>
#include <cmath>

#include "proofs_checks/claims/section_3/dual_problem_parts.hpp"
#include "proofs_checks/instruments/dual_study.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using State = DisplacementProblem::State;

constexpr double allowed = 1e-10;

struct ProblemSaid {
  DisplacementSaid displacement;  ///< of the problem that interior points solve
  bool without_phi = false;       ///< in the inequality
  double moved = 0;               ///< the forces by interior points
};

std::vector<char> random_start(Random& random, std::size_t n) {
  std::vector<char> contact(n, 0);
  for (char& c : contact) c = random.below(2) == 0 ? 1 : 0;
  contact[random.below(n)] = 1;
  return contact;
}

/// The largest difference of forces, over the largest one.
double difference(const State& a, const State& b) {
  double most = 0;
  double scale = 0;
  for (std::size_t i = 0; i < a.force.size(); ++i) {
    most = std::max(most, std::abs(a.force[i] - b.force[i]));
    scale = std::max(scale, std::abs(a.force[i]));
  }
  return most / scale;
}

/// a(v - u, u) + phi(v) - phi(u) for random v, and for v the other solution.
void check_inequality(Findings& findings, Random& random, const DisplacementProblem& problem, const State& state,
                      const State& other, const ProblemSaid& said) {
  const Quantity inequality{"a(v-u, u) + phi(v) - phi(u), below zero", {"random v", "none"}, allowed};
  std::vector<double> u;
  for (const double gap : other.gap) u.push_back(-gap);
  const auto value = [&](const std::vector<double>& w) {
    const double whole = problem.inequality(other, w);
    return said.without_phi ? whole - problem.phi(w) + problem.phi(u) : whole;
  };
  std::vector<double> w;
  for (const double gap : state.gap) w.push_back(-gap);
  double scale = 1;
  for (const double gap : state.gap) scale = std::max(scale, gap);
  findings.compare(inequality, std::max(0.0, -value(w)) / scale);
  for (int k = 0; k < 6; ++k) {
    std::vector<double> v = u;
    for (double& at : v) {
      if (k % 2 == 0 || random.below(8) == 0) at += numeric::to_real<double>(random.between(-1, 1));
    }
    findings.compare(inequality, std::max(0.0, -value(v)) / scale);
  }
}

std::vector<Evidence> check(const Context& context, const ProblemSaid& said) {
  const Quantity forces{"contact forces", {"active sets from random sets", "interior points"}, allowed, 0.7};
  return gather([&] {
    Random random(context.seed, "prop-07-problem-I");
    Findings findings;
    const int count = context.quick ? 6 : 60;
    for (int k = 0; k < count; ++k) {
      const Rational s = random.between(Rational(1, 10), k % 3 == 0 ? 3 : 1) * (k % 2 == 0 ? 1 : -1);
      const DualCase c{"", s, random_profile(random, k % 2 == 0), random.between(Rational(1, 5), 4), 0};
      const int n = 8 + static_cast<int>(random.below(context.quick ? 12 : 32));
      const auto size = static_cast<std::size_t>(n);
      const auto load = numeric::to_real<double>(c.load);
      const DisplacementProblem right(s, n, c.height(), load);
      const DisplacementProblem examined(s, n, c.height(), load, said.displacement);
      std::vector<State> found;
      for (int start = 0; start < 3; ++start) {
        if (const auto state = right.by_active_sets(random_start(random, size))) found.push_back(*state);
      }
      auto other = examined.by_interior_points();
      findings.begin_case("s = " + to_string(s) + ", " + std::to_string(n) + " nodes, " + to_string(c.profile));
      if (!other || found.empty()) {
        findings.skip(forces);
        continue;
      }
      for (double& force : other->force) force *= 1 + said.moved;
      for (const State& state : found) findings.compare(forces, difference(state, *other));
      check_inequality(findings, random, right, found.front(), *other, said);
    }
    return findings.evidence(
        "random s of both signs, profiles and loads, 8 to 40 nodes, three random sets each, seed " +
        std::to_string(context.seed));
  });
}

}  // namespace

Claim problem_i_claim() {
  using S = ProblemSaid;
  return make_claim(
      claim_text("prop-07-problem-I"), check, S(),
      std::vector<Wrong<S>>{
          {"the friction's sign reversed in L", changed<S>([](S& said) { said.displacement.inverse.friction = -1; })},
          {"L with the printed (1+x)^{1/2}", changed<S>([](S& said) { said.displacement.inverse.printed = true; })},
          {"twice the load", changed<S>([](S& said) { said.displacement.load = 2; })},
          {"-psi instead of psi", changed<S>([](S& said) { said.displacement.profile = -1; })},
          {"the t_0 of -alpha in phi", changed<S>([](S& said) { said.displacement.other_angle = true; })},
          {"the inequality without phi", changed<S>([](S& said) { said.without_phi = true; })},
          {"near miss: forces moved by ten times the tolerance",
           changed<S>([](S& said) { said.moved = 10 * allowed; })}});
}

}  // namespace steadyslide::proofs_checks
