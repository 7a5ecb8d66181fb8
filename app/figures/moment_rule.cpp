#include "app/figures/moment_rule.hpp"

#include <cmath>

#include "numeric/quadrature/graded_panels.hpp"
#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::app {
namespace {

using R = numeric::Real50;
using Form = numeric::TractionRepresentation<R>;

/// Returns the length of the contact in a segment, or infinity if there is no contact: then no singular point is near.
R length_beyond(const numeric::ContactSet<R>& set, std::size_t segment) {
  const bool goes_on = segment < set.segments() && set.in_contact(segment);
  return goes_on ? set.length(segment) : numeric::infinity<R>();
}

struct Moments {
  R zeroth = 0, first = 0, size = 0;
};

void add(const Form& form, std::size_t k, int nodes, numeric::JacobiRules<R>& rules, Moments& moments) {
  using std::abs;
  const numeric::ContactSet<R>& set = form.set();
  // For k = 0, k - 1 is not a segment: the index is then too large.
  const numeric::Surroundings<R> around{true, true, length_beyond(set, k - 1), length_beyond(set, k + 1)};
  const R amplitude = form.sign(static_cast<std::ptrdiff_t>(k)) * form.problem().cos_alpha(form.friction_at(k));
  for (const numeric::GradedPanel<R>& panel : numeric::graded_panels(set.length(k), around)) {
    numeric::Power<R> power{R(0), R(1)};
    if (panel.singular_end) {
      const std::size_t j = panel.singular_end == Side::left ? k : k + 1;
      const R p = form.fundamental_solution().powers()[j].value;
      power = {R(-p), R(1 - p)};
    }
    const numeric::UnitRule<R>& rule = rules.get(power, {R(0), R(1)}, nodes);
    const bool mirrored = panel.singular_end == Side::right;
    for (std::size_t i = 0; i < rule.size(); ++i) {
      // The nodes of the rule are counted from the end with the power.
      const R from_left = panel.from_left + panel.length * (mirrored ? rule.from_right[i] : rule.from_left[i]);
      const R from_right = panel.from_right + panel.length * (mirrored ? rule.from_left[i] : rule.from_right[i]);
      const numeric::SurfacePoint<R> at = numeric::surface_point(set, k, from_left, from_right);
      R weight = panel.length * rule.weights[i];
      if (power.value != 0) weight /= pow(rule.from_left[i], power.value);
      const R h = amplitude * form.problem().slope(form.slope_at(k), at.node.x) / form.modulus(at);
      moments.zeroth += weight * h;
      moments.first += weight * h * at.node.x;
      moments.size += weight * abs(h);
    }
  }
}

}  // namespace

MomentErrors moment_errors(const numeric::RiemannHilbertSolution<R>& solution, int nodes) {
  using std::abs;
  const Form& form = solution.form();
  numeric::JacobiRules<R> rules;
  Moments moments;
  for (std::size_t k = 0; k < form.set().segments(); ++k) {
    if (form.set().in_contact(k)) add(form, k, nodes, rules, moments);
  }
  const R& load = form.problem().load();
  return {R(abs(moments.zeroth) / moments.size), R(abs(moments.first + load) / load)};
}

}  // namespace steadyslide::app
