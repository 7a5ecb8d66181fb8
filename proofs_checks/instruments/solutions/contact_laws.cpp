#include "proofs_checks/instruments/solutions/contact_laws.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "proofs_checks/instruments/solutions/falling_contacts.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Returns by how much a is not below b, in this unit.
double not_below(Method method, const Estimate<double>& a, const Estimate<double>& b, double unit) {
  const double error = a.error + b.error;
  return (a.value - b.value + (method == Method::riemann_hilbert ? error : -2 * error)) / unit;
}

double length_of_support(const ContactProblem& problem) {
  return to_real<double>(problem.indenter().right() - problem.indenter().left());
}

/// Returns the length of the second contact that is not in the first, as far as it exceeds the errors of the ends.
double lost_contact(const SolvedContact& larger, const SolvedContact& smaller) {
  double lost = 0;
  for (const auto& part : smaller.solution->contact()) {
    double rest = part.right.x.value - part.left.x.value - 2 * (part.left.x.error + part.right.x.error);
    for (const auto& other : larger.solution->contact()) {
      rest -= std::max(0.0, std::min(part.right.x.value, other.right.x.value) -
                                std::max(part.left.x.value, other.left.x.value)) +
              2 * (other.left.x.error + other.right.x.error);
    }
    lost += std::max(rest, 0.0);
  }
  return lost;
}

/// Returns int s p / P, with the friction of one contact and the pressure of another.
Estimate<double> mean_of_s(const ContactProblem& friction, const SolvedContact& pressed) {
  Estimate<double> mean;
  const std::vector<Estimate<double>> shares = pressed.solution->resultants().load_share;
  for (std::size_t k = 0; k < shares.size(); ++k) mean += to_real<double>(friction.coupled_friction(k)) * shares[k];
  return mean;
}

/// Returns by how much the centre of pressure of `left` is not left of that of `right`, over the support's length.
double centres_not_in_order(const SolvedContact& left, const SolvedContact& right) {
  return not_below(left.method, left.solution->resultants().centre_of_pressure,
                   right.solution->resultants().centre_of_pressure, length_of_support(left.problem));
}

}  // namespace

Values values_of(const Shortfalls& shortfalls) {
  Values values;
  for (const auto& [name, value] : shortfalls) values.add({name, value});
  return values;
}

Shortfalls load_law(const SolvedContact& larger, const SolvedContact& smaller) {
  const auto load = to_real<double>(larger.problem.load());
  const auto difference = to_real<double>(larger.problem.load() - smaller.problem.load());
  // In units of the relative difference of the loads.
  const double unit = std::abs(difference) / (2 * load - difference);
  double fall = -1 / unit, wider = -1;
  for (const PairOfSamples& s : samples(larger, smaller)) {
    fall = std::max(fall, relative_excess(pressure(s.other), pressure(s.one)).value_or(-1) / unit);
    if (s.one.gap && s.other.gap) wider = std::max(wider, relative_excess(*s.one.gap, *s.other.gap).value_or(-1));
  }
  double distance = -difference;
  const auto loads = cumulative_loads(larger, smaller);
  for (std::size_t k = 0; k + 1 < loads.size(); ++k) {
    const Estimate<double> part = (loads[k + 1].first - loads[k].first) - (loads[k + 1].second - loads[k].second);
    distance += std::max(std::abs(part.value) - 2 * part.error - 1e-11 * load, 0.0);
  }
  const double lost = lost_contact(larger, smaller) / length_of_support(larger.problem);
  return {{"fall", fall}, {"lost", lost}, {"gap", wider}, {"distance", distance / load}};
}

Shortfalls crossing_law(const SolvedContact& one, const SolvedContact& other, int m) {
  const auto signs = static_cast<int>(signs_of_difference(one, other).size());
  return {{"crossings", std::max(signs - 1, 0) - m}};
}

Shortfalls attitude_law(const SolvedContact& larger, const SolvedContact& smaller) {
  const std::vector<int> signs = signs_of_difference(larger, smaller);
  // On cells a stretch may be lost in the errors.
  const bool in_order = larger.method == Method::riemann_hilbert ? signs == std::vector{1, -1}
                                                                 : std::ranges::is_sorted(signs, std::greater{});
  double falls = -1;
  for (const auto& [a, b] : cumulative_loads(larger, smaller)) {
    falls = std::max(falls, b.value - a.value - 2 * (a.error + b.error));
  }
  const auto load = to_real<double>(larger.problem.load());
  return {{"centre", centres_not_in_order(larger, smaller)},
          {"order", in_order ? 0 : 1},
          {"cumulative", falls / load - 1e-11}};
}

Shortfalls friction_law(const SolvedContact& larger, const SolvedContact& smaller) {
  const Method method = larger.method;
  const Estimate<double> mean = mean_of_s(smaller.problem, smaller);
  const double unit = std::abs(mean_of_s(larger.problem, smaller).value - mean.value);
  if (unit < 1e-9) return {};
  if (larger.problem.load_at()) {
    const auto slope = to_real<double>(usual_slope(larger.problem));
    return {{"tilt", not_below(method, *larger.solution->tilt(), *smaller.solution->tilt(), slope * unit)}};
  }
  Shortfalls all{{"centre", centres_not_in_order(larger, smaller) / unit},
                 {"mean", not_below(method, mean, mean_of_s(larger.problem, larger), unit)}};
  if (method == Method::riemann_hilbert) {
    const std::vector<int> signs = signs_of_difference(larger, smaller);
    all.emplace_back("ends", !signs.empty() && signs.front() > 0 && signs.back() < 0 ? 0 : 1);
  }
  return all;
}

int components_of(const SolvedContact& contact) {
  const auto zones = contact.solution->contact();
  int components = 1;
  for (std::size_t k = 0; k + 1 < zones.size(); ++k) {
    const auto& from = zones[k].right.x;
    const auto& to = zones[k + 1].left.x;
    components += to.value - from.value > from.error + to.error ? 1 : 0;
  }
  return components;
}

std::optional<double> tilt_by_bracketing(const ContactProblem& problem, Method method) {
  struct NotSolved {};
  const auto place = to_real<double>(*problem.load_at());
  const ContactProblem level = with_load_at(problem, std::nullopt);
  const auto centre_beyond = [&](double tilt) {
    const auto found = solved_contact(with_profile_plus(level, Polynomial({0, Rational(tilt)})), method);
    if (!found) throw NotSolved();
    return found->solution->resultants().centre_of_pressure.value - place;
  };
  try {
    const double beyond = centre_beyond(0);
    if (beyond == 0) return 0;
    double near = 0;
    double far = std::copysign(to_real<double>(usual_slope(problem)) / 4, beyond);
    for (int doublings = 0; std::signbit(centre_beyond(far)) == std::signbit(beyond); ++doublings) {
      if (doublings == 12) return std::nullopt;
      near = far;
      far *= 2;
    }
    std::uintmax_t steps = 60;
    const auto [low, high] = boost::math::tools::toms748_solve(centre_beyond, std::min(near, far), std::max(near, far),
                                                               boost::math::tools::eps_tolerance<double>(36), steps);
    return (low + high) / 2;
  } catch (const NotSolved&) {
    return std::nullopt;
  }
}

}  // namespace steadyslide::proofs_checks
