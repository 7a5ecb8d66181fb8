#include "proofs_checks/instruments/solutions/compared_contacts.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"

namespace steadyslide::proofs_checks {
namespace {

constexpr std::size_t cells = 1024;

/// The values of both solutions at one place.
struct PairOfSamples {
  Rational x;
  numeric::Sample<double> one;
  numeric::Sample<double> other;
};

/// Returns the sign of a - b, or 0 if the errors may exceed it.
int sign_of_difference(const Estimate<double>& a, const Estimate<double>& b) {
  const double difference = a.value - b.value;
  const double error = 4 * (a.error + b.error) + 1e-12 * (std::abs(a.value) + std::abs(b.value));
  return difference > error ? 1 : difference < -error ? -1 : 0;
}

/// Returns (a - b)/(a + b), or nothing if the errors may exceed the difference.
std::optional<double> relative_excess(const Estimate<double>& a, const Estimate<double>& b) {
  if (sign_of_difference(a, b) == 0) return std::nullopt;
  return (a.value - b.value) / (a.value + b.value);
}

/// Returns -t; 0 where a solver that does not resolve a gap has tension.
Estimate<double> pressure(const numeric::Sample<double>& sample) {
  Estimate<double> p = -sample.traction.left;
  p.value = std::max(p.value, 0.0);
  return p;
}

/// Returns the ends of the support, the places of the data and the ends of contact, in order.
std::vector<Rational> marks(const SolvedContact& one, const SolvedContact& other) {
  const Indenter& indenter = one.problem.indenter();
  std::vector<Rational> all{indenter.left(), indenter.right()};
  for (const Rational& jump : one.problem.friction().jumps()) all.push_back(jump);
  for (const Indenter::Break& at : indenter.breaks()) all.push_back(at.x);
  for (const SolvedContact* contact : {&one, &other}) {
    for (const auto& component : contact->solution->contact()) {
      for (const auto* end : {&component.left, &component.right}) {
        all.push_back(std::clamp(Rational(end->x.value), indenter.left(), indenter.right()));
      }
    }
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// True next to a gap that a solution does not resolve.
bool in_doubt(const SolvedContact& contact, const Rational& x) {
  return std::ranges::any_of(contact.solution->unresolved_gaps(), [&](const auto& gap) {
    return std::abs(x.convert_to<double>() - gap.x.value) < 1000 * std::pow(10, gap.log10_length);
  });
}

std::vector<PairOfSamples> samples(const SolvedContact& one, const SolvedContact& other) {
  const std::vector<Rational> ends = marks(one, other);
  const Rational support = ends.back() - ends.front();
  std::vector<PairOfSamples> all;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const Rational length = ends[k + 1] - ends[k];
    if (length * 10'000'000'000'000 < support) continue;
    for (double u = -25; u <= 25; u += 0.625) {
      const Rational part = length * Rational(1 / (1 + std::exp(std::abs(u))));
      const Rational x = u < 0 ? ends[k] + part : ends[k + 1] - part;
      if (in_doubt(one, x) || in_doubt(other, x)) continue;
      all.push_back({x, one.solution->at(x), other.solution->at(x)});
    }
  }
  return all;
}

/// Returns the sign of q next to a singular point of both solutions, from the leading terms; 0 if they do not decide.
int sign_at(const numeric::SolvedSingularPoint<double>& a, const numeric::SolvedSingularPoint<double>& b) {
  const bool is_end = local_terms(a.kind).is_end;
  if (a.kind == SingularKind::free || is_end != local_terms(b.kind).is_end || !a.exponent || !b.exponent) return 0;
  if (is_end &&
      (b.kind == SingularKind::free || a.stress_intensity.left.has_value() != b.stress_intensity.left.has_value())) {
    return 0;
  }
  const int order = (*a.exponent - *b.exponent).sign();
  if (order == 0) return sign_of_difference(a.intensity, b.intensity);
  if (!is_end) return 0;
  const Estimate<double>& stronger = order < 0 ? a.intensity : b.intensity;
  return sign_of_difference(stronger, {}) > 0 ? -order : 0;
}

/// Returns by how much a is not below b, in this unit.
double not_below(Method method, const Estimate<double>& a, const Estimate<double>& b, double unit) {
  const double error = a.error + b.error;
  return (a.value - b.value + (method == Method::riemann_hilbert ? error : -2 * error)) / unit;
}

double length_of_support(const ContactProblem& problem) {
  return to_real<double>(problem.indenter().right() - problem.indenter().left());
}

/// Returns T of both solutions at all marks and at three places between two of them.
std::vector<std::pair<Estimate<double>, Estimate<double>>> cumulative_loads(const SolvedContact& one,
                                                                            const SolvedContact& other) {
  const std::vector<Rational> ends = marks(one, other);
  std::vector<std::pair<Estimate<double>, Estimate<double>>> all;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    for (int part = 0; part < (k + 1 < ends.size() ? 4 : 1); ++part) {
      const Rational x = part == 0 ? ends[k] : ends[k] + (ends[k + 1] - ends[k]) * Rational(part, 4);
      all.emplace_back(one.solution->details_at(x).cumulative_load, other.solution->details_at(x).cumulative_load);
    }
  }
  return all;
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

std::optional<SolvedContact> solved_contact(const ContactProblem& problem, Method method) {
  const auto found = method == Method::riemann_hilbert ? numeric::riemann_hilbert<double>(problem)
                                                       : numeric::variational_inequality(problem, {.cells = cells});
  if (!found.solution || !found.solution->failed_condition().empty()) return std::nullopt;
  return SolvedContact{problem, method, found.solution};
}

std::string_view name_of(Method method) { return method == Method::cells ? "cells" : "Riemann-Hilbert"; }

Values values_of(const Shortfalls& shortfalls) {
  Values values;
  for (const auto& [name, value] : shortfalls) values.add({name, value});
  return values;
}

std::vector<int> signs_of_difference(const SolvedContact& one, const SolvedContact& other) {
  std::vector<std::pair<Rational, int>> found;
  for (const PairOfSamples& s : samples(one, other)) {
    found.emplace_back(s.x, sign_of_difference(pressure(s.one), pressure(s.other)));
  }
  for (const auto& a : one.solution->singular_points()) {
    for (const auto& b : other.solution->singular_points()) {
      if (a.x.value == b.x.value) found.emplace_back(Rational(a.x.value), sign_at(a, b));
    }
  }
  std::ranges::stable_sort(found, {}, &std::pair<Rational, int>::first);
  std::vector<int> signs;
  for (const auto& [x, sign] : found) {
    if (sign != 0 && (signs.empty() || signs.back() != sign)) signs.push_back(sign);
  }
  return signs;
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
    const double slope = to_real<double>(usual_slope(larger.problem));
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

int most_components(const Indenter& indenter) {
  int sum = 0;
  for (const Indenter::Piece& piece : indenter.pieces()) {
    const int degree = std::max(piece.profile.degree() - 1, 0);
    const bool one_more = degree % 2 == 1 && piece.profile.coefficients().back() < 0;
    sum += 1 + degree / 2 + (one_more ? 1 : 0);
  }
  return sum;
}

int components_above_bound(const SolvedContact& contact) {
  return static_cast<int>(contact.solution->contact().size()) - most_components(contact.problem.indenter());
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
                                                               boost::math::tools::eps_tolerance<double>(44), steps);
    return (low + high) / 2;
  } catch (const NotSolved&) {
    return std::nullopt;
  }
}

ContactProblem with_profile_plus(const ContactProblem& problem, const Polynomial& polynomial) {
  std::vector<Indenter::Piece> pieces = problem.indenter().pieces();
  for (Indenter::Piece& piece : pieces) piece.profile = piece.profile + polynomial;
  return problem.with_indenter(Indenter(problem.indenter().left(), std::move(pieces)));
}

ContactProblem with_load_at(const ContactProblem& problem, std::optional<Rational> load_at) {
  return {problem.elasticity(), problem.friction(), problem.indenter(),
          problem.load(),       problem.sliding(),  std::move(load_at)};
}

Rational usual_slope(const ContactProblem& problem) {
  const Indenter& indenter = problem.indenter();
  return problem.elasticity().compliance() * problem.load() / (indenter.right() - indenter.left());
}

ContactProblem random_falling_contact(Random& random, std::size_t k) {
  CellFrictionSteps steps = random_steps(random, random.below(5) == 0 ? Trend::any : Trend::falling, 5, 3);
  if (random.below(2) == 0) steps = mirrored(steps);
  const auto from = [](const Rational& c, const Rational& height, const Rational& slope, const Rational& curve) {
    return Polynomial({height, slope, curve}).composed(1, -c);
  };
  const Rational left = random.between(Rational(1, 8), 1), right = random.between(Rational(1, 8), 1);
  const Rational curve = random.between(Rational(1, 8), 1);
  Rational c = random.between(Rational(-1, 2), Rational(1, 2));
  std::vector<Indenter::Piece> pieces;
  switch (k % 5) {
    case 0: pieces = {{1, random_profile(random, random.below(2) == 0)}}; break;
    case 1: pieces = {{c, from(c, 0, -left, curve)}, {1, from(c, 0, right, curve)}}; break;
    case 2: {
      const Rational notch = c + random.between(0, Rational(1, 3));
      const Rational beyond = right * random.between(-1, Rational(7, 8));
      pieces = {{c, from(c, 0, -left, 0)},
                {notch, from(c, 0, right, 0)},
                {1, from(notch, right * (notch - c), beyond, curve)}};
      c = notch;
      break;
    }
    case 3: {
      const bool rises = random.below(2) == 0;
      const Rational step = left / 4;
      pieces = {{c, Polynomial({rises ? Rational(0) : step, 0, curve})},
                {1, Polynomial({rises ? step : Rational(0), 0, curve})}};
      break;
    }
    default:
      c = 0;
      pieces = {{0, from(Rational(-1, 2), 0, 0, 4)}, {1, from(Rational(1, 2), left / 8, 0, 4 - left / 2)}};
      break;
  }
  // Friction often jumps where the profile breaks.
  if (random.below(3) == 0 && std::ranges::find(steps.jumps, c) == steps.jumps.end()) {
    steps.jumps[random.below(steps.jumps.size())] = c;
    std::ranges::sort(steps.jumps);
  }
  return cell_problem(steps, Polynomial(), random.between(Rational(1, 50), 3)).with_indenter(Indenter(-1, pieces));
}

}  // namespace steadyslide::proofs_checks
