#include "proofs_checks/instruments/operators/displacement_problem.hpp"

#include <algorithm>
#include <cmath>

#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/instruments/cells/interior_point.hpp"

namespace steadyslide::proofs_checks {
namespace {

using Index = Eigen::Index;

/// Returns the nodes at which a gap is negative or a force pulls, by more than rounding.
std::vector<std::size_t> wrong_nodes(const DisplacementProblem::State& state, const std::vector<char>& contact,
                                     double gap_scale, double force_scale) {
  constexpr double rounding = 1e-13;
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    const auto k = static_cast<Index>(i);
    const bool holds =
        contact[i] != 0 ? state.force(k) >= -rounding * force_scale : state.gap(k) >= -rounding * gap_scale;
    if (!holds) wrong.push_back(i);
  }
  return wrong;
}

}  // namespace

DisplacementProblem::DisplacementProblem(const Rational& s, int n, const std::function<double(double)>& profile,
                                         double load, const DisplacementFormula& formula)
    : operator_(s, n, formula.inverse),
      force_(matrix_of(size(), size(), [&](std::size_t i, std::size_t j) { return operator_.force(i, j); })),
      tau_(vector_of(size(), [&](std::size_t i) { return operator_.tau(i); })),
      profile_(formula.profile * vector_of(size(), [&](std::size_t i) { return profile(x(i)); })),
      load_(formula.load * load) {
  if (!formula.other_angle) return;
  // The weights of -alpha: those of alpha times ((1+x)/(1-x))^{2 alpha}, scaled to the sum 1.
  const double twice = 2 * to_real<double>(Exponent::angle(s));
  tau_ = vector_of(size(), [&](std::size_t i) {
    const auto& node = operator_.node(i);
    return operator_.tau(i) * std::pow(node.from_left / node.from_right, twice);
  });
  tau_ /= tau_.sum();
}

DisplacementProblem::State DisplacementProblem::state_of(const std::vector<char>& contact) const {
  std::vector<Index> open;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (contact[i] == 0) open.push_back(static_cast<Index>(i));
  }
  const Eigen::VectorXd flush = load_ * tau_ - force_ * profile_;
  State state{Eigen::VectorXd::Zero(tau_.size()), {}, 0};
  if (!open.empty()) {
    const Eigen::VectorXd solved = linear_solution(force_(open, open), -flush(open));
    state.gap(open) = solved;
  }
  state.force = flush + force_ * state.gap;
  for (const Index i : open) state.force(i) = 0;
  return state;
}

std::optional<DisplacementProblem::State> DisplacementProblem::by_active_sets(std::vector<char> contact) const {
  const double gap_scale = load_ + profile_.cwiseAbs().maxCoeff();
  for (int step = 1; step <= 60; ++step) {
    State state = state_of(contact);
    const auto wrong = wrong_nodes(state, contact, gap_scale, load_);
    state.steps = step;
    if (wrong.empty()) return state;
    for (const std::size_t i : wrong) contact[i] = contact[i] == 0 ? 1 : 0;
    // At least one node must stay in contact: the last one that was released.
    if (std::ranges::none_of(contact, [](char c) { return c != 0; })) contact[wrong.back()] = 1;
  }
  return std::nullopt;
}

std::optional<DisplacementProblem::State> DisplacementProblem::by_interior_points() const {
  const Eigen::VectorXd flush = load_ * tau_ - force_ * profile_;
  const auto found = proofs_checks::by_interior_points(force_, flush, std::nullopt);
  if (!found) return std::nullopt;
  return State{found->x, found->y, 0};
}

double DisplacementProblem::phi(const Eigen::VectorXd& w) const { return load_ * (w.maxCoeff() - tau_.dot(w)); }

double DisplacementProblem::inequality(const State& state, const Eigen::VectorXd& w) const {
  return (w + state.gap).dot(force_ * (profile_ - state.gap)) + phi(w) - phi(-state.gap);
}

std::vector<double> DisplacementProblem::moments(const State& state, std::size_t count) const {
  std::vector<double> result(count + 1, 0);
  for (std::size_t i = 0; i < size(); ++i) {
    const double angle = std::acos(x(i));
    for (std::size_t k = 0; k <= count; ++k)
      result[k] -= state.force(static_cast<Index>(i)) * std::cos(static_cast<double>(k) * angle);
  }
  return result;
}

}  // namespace steadyslide::proofs_checks
