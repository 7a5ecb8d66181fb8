#include <algorithm>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/closed_form/parabola.hpp"
#include "numeric/number/mapped.hpp"
#include "numeric/periodic/periodic_solution.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns the polynomial of the profile if all its pieces are the same polynomial.
std::optional<Polynomial> common_profile(const Indenter& indenter) {
  const Polynomial& first = indenter.pieces().front().profile;
  for (const Indenter::Piece& piece : indenter.pieces()) {
    if (piece.profile != first) return std::nullopt;
  }
  return first;
}

/// Returns the amplitudes -|N| cos(pi alpha) on the panels. Panel 0 is the friction piece `first_piece`.
template <Real R>
std::vector<R> amplitudes(const ContactProblem& problem, std::size_t first_piece, std::size_t panels, const R& factor) {
  std::vector<R> result;
  result.reserve(panels);
  for (std::size_t k = 0; k < panels; ++k) {
    result.push_back(-abs(factor) * cos_pi_alpha<R>(problem.coupled_friction(first_piece + k)));
  }
  return result;
}

/// Returns the exponents of the left end, the jumps and the right end, for the contact on the pieces first..last.
std::vector<Exponent> exponents(const ContactProblem& problem, SingularKind ends, std::size_t first, std::size_t last) {
  const auto end_exponent = ends == SingularKind::edge ? edge_exponent : free_exponent;
  std::vector<Exponent> result{end_exponent(End::left, problem.coupled_friction(first))};
  for (std::size_t k = first; k < last; ++k) {
    result.push_back(jump_exponent(problem.coupled_friction(k), problem.coupled_friction(k + 1)));
  }
  result.push_back(end_exponent(End::right, problem.coupled_friction(last)));
  return result;
}

template <Real R>
ClosedFormData<R> flat_punch(const ContactProblem& problem) {
  const Indenter& indenter = problem.indenter();
  const Rational origin = (indenter.left() + indenter.right()) / 2;
  std::vector<Rational> points{indenter.left() - origin};
  for (const Rational& c : problem.friction().jumps()) points.push_back(c - origin);
  points.push_back(indenter.right() - origin);

  std::vector<R> lengths;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) lengths.push_back(to_real<R>(points[k + 1] - points[k]));
  const std::size_t last = problem.friction().values().size() - 1;
  std::vector<Exponent> p = exponents(problem, SingularKind::edge, 0, last);
  const R factor = -to_real<R>(problem.load()) / pi<R>();
  PowerTraction<R> traction{
      FundamentalSolution<R>(to_real<R>(points.front()), std::move(lengths), mapped(p, Power<R>::of)),
      amplitudes(problem, 0, last + 1, factor)};
  return {origin, SingularKind::edge, 0, std::move(p), {points.begin(), points.end()}, R(0),
          factor, std::move(traction)};
}

template <Real R>
std::variant<ClosedFormData<R>, std::string> parabola(const ContactProblem& problem, const Polynomial& profile) {
  const Rational vertex = -profile.coefficient(1) / (2 * profile.coefficient(2));
  const Rational radius = problem.elasticity().compliance() / (2 * profile.coefficient(2));
  std::vector<Rational> s;
  for (std::size_t k = 0; k < problem.friction().values().size(); ++k) s.push_back(problem.coupled_friction(k));
  const std::vector<Rational> jumps =
      mapped(problem.friction().jumps(), [&](const Rational& c) { return Rational(c - vertex); });

  const R K = to_real<R>(2 * problem.load() * radius) / pi<R>();
  const ParabolaZone<R> zone = parabola_zone<R>(s, jumps, K);
  if (zone.left < to_real<R>(problem.indenter().left() - vertex) ||
      zone.right > to_real<R>(problem.indenter().right() - vertex)) {
    return std::string("the parabola's contact reaches an edge of the support");
  }

  std::vector<std::optional<Rational>> exact{std::nullopt};
  std::vector<R> lengths;
  if (zone.first == zone.last) {
    lengths.push_back(zone.right - zone.left);
  } else {
    lengths.push_back(to_real<R>(jumps[zone.first]) - zone.left);
    for (std::size_t k = zone.first; k < zone.last; ++k) {
      exact.emplace_back(jumps[k]);
      if (k + 1 < zone.last) lengths.push_back(to_real<R>(jumps[k + 1] - jumps[k]));
    }
    lengths.push_back(zone.right - to_real<R>(jumps[zone.last - 1]));
  }
  exact.emplace_back(std::nullopt);

  std::vector<Exponent> p = exponents(problem, SingularKind::free, zone.first, zone.last);
  const R factor = 1 / to_real<R>(radius);
  PowerTraction<R> traction{FundamentalSolution<R>(zone.left, std::move(lengths), mapped(p, Power<R>::of)),
                            amplitudes(problem, zone.first, zone.last - zone.first + 1, factor)};
  return ClosedFormData<R>{vertex,           SingularKind::free, zone.first, std::move(p),
                           std::move(exact), zone.error,         factor,     std::move(traction)};
}

}  // namespace

std::string too_many_friction_pieces(const ContactProblem& problem, Digits digits) {
  const std::size_t pieces = problem.friction().values().size();
  const bool in_double = digits == Digits::sixteen;
  const std::size_t most = in_double ? max_friction_pieces : max_friction_pieces_in_digits;
  if (pieces <= most) return {};
  return "too many values of friction for a solution by powers" +
         std::string(in_double ? "" : " with more than 16 digits") + "; there are at most " + std::to_string(most) +
         "; " + std::to_string(pieces) + " values";
}

template <Real R>
std::variant<ClosedFormData<R>, std::string> closed_form_data(const ContactProblem& problem) {
  if (std::string reason = too_many_friction_pieces(problem, digits_of<R>); !reason.empty()) return reason;
  if (problem.load_at()) return std::string("the indenter may tilt");
  const std::optional<Polynomial> profile = common_profile(problem.indenter());
  if (profile && profile->degree() <= 0) {
    if (problem.elasticity().indenter()) {
      return std::string("a flat elastic indenter touches with its edges, where the half-plane idealisation fails");
    }
    return flat_punch<R>(problem);
  }
  if (profile && profile->degree() == 2 && profile->coefficient(2) > 0) return parabola<R>(problem, *profile);
  return std::string("the profile is neither flat nor a parabola that opens away from the body");
}

template <Real R>
Attempt<R> closed_form(const ContactProblem& problem) {
  if (problem.body().period()) return periodic_closed_form<R>(problem);
  if (std::string reason = problem.body().beyond_half_plane(); !reason.empty()) return {nullptr, std::move(reason)};
  std::variant<ClosedFormData<R>, std::string> data = closed_form_data<R>(problem);
  if (auto* reason = std::get_if<std::string>(&data)) return {nullptr, std::move(*reason)};
  return {std::make_shared<const ClosedForm<R>>(problem, std::get<ClosedFormData<R>>(std::move(data))), {}};
}

#define STEADYSLIDE_INSTANTIATE(R)                                                               \
  template std::variant<ClosedFormData<R>, std::string> closed_form_data(const ContactProblem&); \
  template Attempt<R> closed_form(const ContactProblem&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
