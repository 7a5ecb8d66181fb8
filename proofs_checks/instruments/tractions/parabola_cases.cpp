#include "proofs_checks/instruments/tractions/parabola_cases.hpp"

#include <algorithm>

#include "numeric/closed_form/closed_form.hpp"
#include "symbolic/riemann_hilbert/derived_contact.hpp"

namespace steadyslide::proofs_checks {

ContactProblem parabola(const Rational& nu, const std::vector<Rational>& friction,
                        const std::vector<Rational>& jumps_from_vertex, const Rational& radius, const Rational& load,
                        const Rational& vertex, Sliding sliding) {
  const Elasticity elasticity(Solid(nu, 1));
  const Rational a = elasticity.compliance() / (2 * radius);
  std::vector<Rational> jumps;
  for (const Rational& c : jumps_from_vertex) jumps.push_back(c + vertex);
  const Polynomial profile({a * vertex * vertex, -2 * a * vertex, a});
  return ContactProblem(elasticity, FrictionProfile(friction, jumps), Indenter(-100'000, {{100'000, profile}}), load,
                        sliding);
}

namespace {

const Polynomial& profile_of(const ContactProblem& problem) { return problem.indenter().pieces().front().profile; }

}  // namespace

Rational radius_of(const ContactProblem& problem) {
  return problem.elasticity().compliance() / (2 * profile_of(problem).coefficient(2));
}

Rational vertex_of(const ContactProblem& problem) {
  return -profile_of(problem).coefficient(1) / (2 * profile_of(problem).coefficient(2));
}

template <Real R>
void check_parabola(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem,
                    const Context& context) {
  using std::abs;
  const PowerForm<R> form = t.at<R>();
  const Quantity first{"equation for the middle of the contact", {"`sum p_j r_j`", "0"}, tolerance<R>()};
  const Quantity second{"equation for the width of the contact", {"`sum p_j r_j^2`", "`2 P R/pi`"}, tolerance<R>()};
  const R radius = to_real<R>(radius_of(problem));
  const std::function<R(const R&)> slope = [radius](const R& x) { return R(x / radius); };
  const trapezoidal::Grid<R> grid =
      check_surface(findings, surface_of<R>(form, problem, t.first_piece, slope), count_for(context, {9, 2, 2}));

  R sum1 = 0, size1 = 0, sum2 = 0;
  const std::vector<R> r = form.points();
  for (std::size_t j = 0; j < r.size(); ++j) {
    const R term = form.powers[j].value * r[j];
    sum1 += term;
    size1 += abs(term);
    sum2 += term * r[j];
  }
  findings.compare(first, R(abs(sum1) / size1));
  findings.compare(second, relative_difference<R>(sum2, R(2 * to_real<R>(problem.load()) * radius / numeric::pi<R>())));
  const R width = r.back() - r.front();
  const R allowed = R(-tolerance<R>()) * width * width / radius;
  for (const Side side : {Side::left, Side::right}) {
    const bool left = side == Side::left;
    const R end = left ? r.front() : r.back();
    for (int i = 1; i <= 16; i += context.quick ? 5 : 1) {
      const R distance = 2 * width * i * i / 256;
      const R x = left ? R(end - distance) : R(end + distance);
      const R rise = (left ? R(-distance) : distance) * (slope(end) + slope(x)) / 2;
      const R gap = rise - grid.displacement(left ? 0 : form.lengths.size() - 1, side, distance);
      findings.require(gap >= allowed, left ? "the surface penetrates left of the contact"
                                            : "the surface penetrates right of the contact");
    }
  }
}

namespace {

/// Compares both ends. The unit is the width of the contact, because an end may lie anywhere near the vertex.
template <Real R>
void compare_ends(Findings& findings, const Quantity& quantity, const PowerForm<R>& form, const R& left,
                  const R& right) {
  using std::abs;
  const R end = form.points().back();
  const R width = end - form.left_end;
  findings.compare(quantity, R(abs(left - form.left_end) / width));
  findings.compare(quantity, R(abs(right - end) / width));
}

/// Calls visit(panel, node, t) at points of every panel.
template <Real R, class Visit>
void visit_values(const PowerForm<R>& form, const Visit& visit) {
  const numeric::PowerTraction<R> traction = form.traction();
  for (std::size_t k = 0; k < form.lengths.size(); ++k) {
    const numeric::Panel<R>& panel = traction.weight.panel(k);
    for (const int tenths : {2, 5, 9}) {
      const Node<R> node = panel.node_from_left(panel.length * tenths / 10);
      visit(k, node, traction(k, node));
    }
  }
}

}  // namespace

template <Real R>
void check_parabola_by_cln(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem) {
  const PowerForm<R> form = t.at<R>();
  const Quantity ends{"ends of the contact, in CLN", {"the formula", "the derived contact in CLN"}, tolerance<R>()};
  // If a free end almost touches a friction jump, the condition number of the traction is the inverse of their
  // distance.
  const Quantity values{"values of the traction, in CLN, times shortest panel over width",
                        {"the formula", "the derived contact in CLN"},
                        tolerance<R>()};
  const R conditioning = std::ranges::min(form.lengths) / (form.points().back() - form.left_end);
  const Rational vertex = vertex_of(problem);
  // CLN rounds the ends in the user's x. If the vertex is far away, this costs digits.
  const auto zones = symbolic::DerivedContact::all(problem, numeric::digits_served<R> + 15);
  findings.require(zones.size() == 1, "CLN finds " + std::to_string(zones.size()) + " contact zones");
  compare_ends(findings, ends, form, to_real<R>(zones[0].end(End::left).value - vertex),
               to_real<R>(zones[0].end(End::right).value - vertex));
  visit_values(form, [&](std::size_t, const Node<R>& node, const R& value) {
    const Rational x = Rational(node.x) + vertex;
    const R by_cln = to_real<R>(zones[0].traction(x).value);
    findings.compare(values, static_cast<double>(conditioning) * relative_difference<R>(value, by_cln));
  });
}

template <Real R>
void check_parabola_by_numeric(Findings& findings, const ParabolaTraction& t, const ContactProblem& problem) {
  const PowerForm<R> form = t.at<R>();
  const Quantity quantity{"ends of the contact and values of the traction, as solved",
                          {"the formula", "the closed form that `solve` uses"},
                          tolerance<R>()};
  const auto data = numeric::closed_form_data<R>(problem);
  const auto* closed_form = std::get_if<numeric::ClosedFormData<R>>(&data);
  findings.require(closed_form != nullptr, "the numeric layer knows no closed form");
  const auto& weight = closed_form->traction.weight;
  compare_ends(findings, quantity, form, weight.point(0), weight.point(weight.panel_count()));
  visit_values(form, [&](std::size_t k, const Node<R>& node, const R& value) {
    findings.compare(quantity, relative_difference<R>(value, closed_form->traction(k, node)));
  });
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                            \
  template void check_parabola<R>(Findings&, const ParabolaTraction&, const ContactProblem&, const Context&); \
  template void check_parabola_by_cln<R>(Findings&, const ParabolaTraction&, const ContactProblem&);          \
  template void check_parabola_by_numeric<R>(Findings&, const ParabolaTraction&, const ContactProblem&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
