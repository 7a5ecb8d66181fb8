#include "proofs_checks/instruments/solutions/contact_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/bodies/body_contact.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::proofs_checks {
namespace {

constexpr std::size_t cells = 1024;

/// Returns the sign of a - b, or 0 if the errors may exceed it.
int sign_of_difference(const Estimate<double>& a, const Estimate<double>& b) {
  const double difference = a.value - b.value;
  const double error = 4 * (a.error + b.error) + 1e-12 * (std::abs(a.value) + std::abs(b.value));
  return difference > error ? 1 : difference < -error ? -1 : 0;
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

/// Returns T(x). In periodic contact the right end of a support as long as the period is also the left end, with T = 0.
Estimate<double> load_up_to(const SolvedContact& contact, const Rational& x) {
  const Indenter& indenter = contact.problem.indenter();
  if (x == indenter.right() && contact.problem.body().period()) {
    return {to_real<double>(contact.problem.load()), 0};
  }
  return contact.solution->details_at(x).cumulative_load;
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

}  // namespace

std::string_view name_of(Method method) { return method == Method::cells ? "cells" : "Riemann-Hilbert"; }

std::optional<SolvedContact> solved_contact(const ContactProblem& problem, Method method) {
  const auto by_exponents = [&] {
    if (problem.body().period()) return numeric::closed_form<double>(problem);
    return problem.body().is_half_plane() ? numeric::riemann_hilbert<double>(problem)
                                          : numeric::contact_on_body(problem);
  };
  const auto found =
      method == Method::riemann_hilbert ? by_exponents() : numeric::variational_inequality(problem, {.cells = cells});
  if (!found.solution || !found.solution->failed_condition().empty()) return std::nullopt;
  return SolvedContact{problem, method, found.solution};
}

std::vector<PairOfSamples> samples(const SolvedContact& one, const SolvedContact& other) {
  const std::vector<Rational> ends = marks(one, other);
  const Rational support = ends.back() - ends.front();
  std::vector<PairOfSamples> all;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const Rational length = ends[k + 1] - ends[k];
    if (length * 10'000'000'000'000 < support) continue;
    for (int u = -25; u <= 25; ++u) {
      const Rational part = length * Rational(1 / (1 + std::exp(std::abs(static_cast<double>(u)))));
      const Rational x = u < 0 ? ends[k] + part : ends[k + 1] - part;
      if (in_doubt(one, x) || in_doubt(other, x)) continue;
      all.push_back({x, one.solution->at(x), other.solution->at(x)});
    }
  }
  return all;
}

std::vector<std::pair<Estimate<double>, Estimate<double>>> cumulative_loads(const SolvedContact& one,
                                                                            const SolvedContact& other) {
  const std::vector<Rational> ends = marks(one, other);
  std::vector<std::pair<Estimate<double>, Estimate<double>>> all;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    for (int part = 0; part < (k + 1 < ends.size() ? 2 : 1); ++part) {
      const Rational x = part == 0 ? ends[k] : ends[k] + (ends[k + 1] - ends[k]) * Rational(part, 2);
      all.emplace_back(load_up_to(one, x), load_up_to(other, x));
    }
  }
  return all;
}

std::optional<double> relative_excess(const Estimate<double>& a, const Estimate<double>& b) {
  if (sign_of_difference(a, b) == 0) return std::nullopt;
  return (a.value - b.value) / (a.value + b.value);
}

Estimate<double> pressure(const numeric::Sample<double>& sample) {
  Estimate<double> p = -sample.traction.left;
  p.value = std::max(p.value, 0.0);
  return p;
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

}  // namespace steadyslide::proofs_checks
