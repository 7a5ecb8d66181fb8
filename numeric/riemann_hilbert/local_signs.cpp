#include "numeric/riemann_hilbert/local_signs.hpp"

#include <cmath>
#include <sstream>

namespace steadyslide::numeric {
namespace {

/// Returns D, from the exact difference.
template <Real R>
R slope_jump(const TractionRepresentation<R>& form, std::size_t point) {
  return to_real<R>(form.set().anchor_at(point)->exact.wedge);
}

template <Real R>
LeadingTerm<R> power_term(const TractionRepresentation<R>& form, std::size_t point, const R& end_error) {
  const ContactSet<R>& set = form.set();
  const bool is_end = set.point(point).is_end();
  const Side side = set.contact_side(point);
  const std::size_t segment = side == Side::right ? point : point - 1;
  const Estimate<R> b = form.regular_factor_at(point, side);
  const Side seen = is_end ? side : Side::right;
  // Lengths keep their relative precision, for any size.
  const R shift = sqrt(epsilon<R>());
  const R error = b.error + form.error_of_state(beside(set, point, seen, R(0)), {{end_error, shift, shift}, {}});
  R factor = -form.sign(static_cast<std::ptrdiff_t>(segment)) * form.amplitude(point);
  if (is_end) factor *= form.problem().cos_alpha(form.friction_at(segment));
  const bool decided = abs(b.value) > 4 * error;
  const int sign = b.value * form.sign(static_cast<std::ptrdiff_t>(segment)) > 0 ? 1 : -1;
  return {LeadingTerm<R>::Kind::power,
          {factor * b.value, abs(factor) * error},
          form.power(point).value,
          decided ? sign : 0};
}

}  // namespace

template <Real R>
std::optional<LeadingTerm<R>> leading_term(const TractionRepresentation<R>& form, std::size_t point,
                                           const R& end_error) {
  using Kind = typename LeadingTerm<R>::Kind;
  const ContactSet<R>& set = form.set();
  if (set.point(point).is_end()) return power_term(form, point, end_error);
  if (point == 0 || point == set.segments() || !set.in_contact(point)) return std::nullopt;
  const int beta = form.exponent(point).sign();
  const int wedge = sign(set.anchor_at(point)->exact.wedge);
  if (wedge == 0 || beta < 0) return power_term(form, point, end_error);
  const R& s = form.problem().s(form.friction_at(point));
  const bool jumps = beta != 0;
  const R coefficient = slope_jump(form, point) / (jumps ? set.anchor_at(point)->s_jump : 1 + s * s);
  // log d and [s] are negative where they are used.
  return LeadingTerm<R>{jumps ? Kind::constant : Kind::logarithm,
                        Estimate<R>{coefficient, R(0)}.widened(4 * epsilon<R>()), R(0), -wedge};
}

template <Real R>
std::optional<R> log_reach(const TractionRepresentation<R>& form, std::size_t point) {
  if (!form.changes_polynomial(point)) return std::nullopt;
  const R d = slope_jump(form, point);
  const R& s = form.problem().s(form.friction_at(point));
  const R& cosine = form.problem().cos_alpha(form.friction_at(point));
  const R regular = -cosine * power_term(form, point, R(0)).coefficient.value;
  if (form.exponent(point).sign() == 0) {
    // D/(1+s^2) log(d)/pi + regular
    return d == 0 ? std::nullopt : std::optional<R>(-regular * pi<R>() * (1 + s * s) / d);
  }
  const R ratio = -d / form.set().anchor_at(point)->s_jump / regular;
  if (!(ratio > 0)) return std::nullopt;
  return log(ratio) / form.power(point).value;
}

namespace {

template <Real R>
std::optional<R> hairline_reach(const TractionRepresentation<R>& form, std::size_t point) {
  const std::optional<R> reach = log_reach(form, point);
  return reach && *reach < log(R(1e30) * form.problem().shortest_gap()) ? reach : std::nullopt;
}

}  // namespace

template <Real R>
bool pulls(const TractionRepresentation<R>& form, std::size_t point, const std::optional<LeadingTerm<R>>& term) {
  if (!term || term->sign <= 0) return false;
  return form.set().point(point).is_end() || !hairline_reach(form, point);
}

template <Real R>
std::vector<HairlineGap<R>> hairline_gaps(const TractionRepresentation<R>& form, const R& end_error) {
  std::vector<HairlineGap<R>> result;
  for (std::size_t j = 0; j < form.set().points().size(); ++j) {
    if (form.set().point(j).is_end()) continue;
    const std::optional<LeadingTerm<R>> term = leading_term(form, j, end_error);
    if (!term || term->sign <= 0) continue;
    if (const auto reach = hairline_reach(form, j)) result.push_back({*form.set().point(j).anchor, *reach});
  }
  return result;
}

template <Real R>
R highest_limit(const TractionRepresentation<R>& form, const R& end_error) {
  using Kind = typename LeadingTerm<R>::Kind;
  R highest = 0;
  for (std::size_t j = 0; j < form.set().points().size(); ++j) {
    const std::optional<LeadingTerm<R>> term = leading_term(form, j, end_error);
    if (!pulls(form, j, term)) continue;
    if (term->kind == Kind::logarithm || term->power < 0) return infinity<R>();
    if (term->kind == Kind::constant) highest = std::max(highest, term->coefficient.value);
    if (term->kind == Kind::power && term->power == 0) highest = std::max(highest, -term->coefficient.value);
  }
  return highest;
}

template <Real R>
std::string in_words(const TractionRepresentation<R>& form, std::size_t point, const LeadingTerm<R>& term) {
  using Kind = typename LeadingTerm<R>::Kind;
  const auto& anchor = form.set().point(point).anchor;
  const Frame& frame = form.problem().frame();
  const R scale = pow(to_real<R>(frame.unit), -term.power);
  std::ostringstream text;
  const auto number = [](const R& value) { return static_cast<double>(value); };
  text << "the leading term at x = ";
  if (anchor) {
    text << to_string(form.problem().place(*anchor));
  } else {
    text << number(to_real<R>(frame.origin) + to_real<R>(frame.unit) * form.set().x(point));
  }
  text << " pulls: "
       << (term.kind == Kind::power      ? "theta"
           : term.kind == Kind::constant ? "[psi']/[s]"
                                         : "[psi']/(1+s^2) log(d)/pi with")
       << " = " << number(scale * term.coefficient.value);
  text.precision(1);
  text << " +- " << number(scale * term.coefficient.error);
  return text.str();
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                              \
  template std::optional<LeadingTerm<R>> leading_term(const TractionRepresentation<R>&, std::size_t, const R&); \
  template std::optional<R> log_reach(const TractionRepresentation<R>&, std::size_t);                           \
  template std::vector<HairlineGap<R>> hairline_gaps(const TractionRepresentation<R>&, const R&);               \
  template bool pulls(const TractionRepresentation<R>&, std::size_t, const std::optional<LeadingTerm<R>>&);     \
  template R highest_limit(const TractionRepresentation<R>&, const R&);                                         \
  template std::string in_words(const TractionRepresentation<R>&, std::size_t, const LeadingTerm<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
