#include "proofs_checks/instruments/tractions/surface.hpp"

#include <array>

#include "numeric/cauchy/sliding_operator.hpp"
#include "numeric/quadrature/gsl_quadrature.hpp"

namespace steadyslide::proofs_checks {
namespace {

template <Real R>
double load_error(const Surface<R>& surface, const R& integral) {
  using std::abs, std::max;
  if (integral == surface.integral) return 0;
  const R scale = max({R(abs(integral)), R(abs(surface.integral)), surface.load_scale});
  return static_cast<double>(R(abs(integral - surface.integral) / scale));
}

/// Requires that all panels have a length and all powers are above -1. Otherwise the traction cannot be sampled.
template <Real R>
void require_integrable(Findings& findings, const Surface<R>& surface) {
  for (const PanelDensity<R>& panel : surface.traction) {
    findings.require(panel.panel.length > 0, "a panel has no length");
    findings.require(panel.left.plus_one > 0 && panel.right.plus_one > 0, "the traction is not integrable");
  }
}

}  // namespace

template <Real R>
Surface<R> surface_of(const PowerForm<R>& form, const ContactProblem& problem, std::size_t first_piece,
                      std::function<R(const R&)> slope) {
  Surface<R> surface{form.traction().density(), {}, std::move(slope), R(-to_real<R>(problem.load()))};
  for (std::size_t k = 0; k < form.lengths.size(); ++k) {
    surface.s.push_back(to_real<R>(problem.coupled_friction(first_piece + k)));
  }
  return surface;
}

template <Real R>
trapezoidal::Grid<R> check_surface(Findings& findings, const Surface<R>& surface, std::size_t tanh_sinh_points) {
  require_integrable(findings, surface);
  trapezoidal::Grid<R> grid(surface.traction);
  const double allowed = tolerance<R>();
  const Quantity load_1{"total load `int t`, trapezoidal rule", {"trapezoidal rule", "the load given"}, allowed};
  const Quantity load_2{
      "total load `int t`, tanh-sinh rule", {"tanh-sinh rule with absorbed powers", "the load given"}, allowed};
  const Quantity equation_1{"`A t = u'/c` at points of every panel, trapezoidal rule",
                            {"`(1/pi) PV int t/(x'-x) dx'` with nodes staggered off the pole", "`u'/c - s t`"},
                            allowed};
  const Quantity equation_2{"`A t = u'/c`, tanh-sinh rule",
                            {"`(1/pi) PV int t/(x'-x) dx'` with the pole subtracted", "`u'/c - s t`"},
                            allowed};
  // The equation is checked before the load. It does not notice a factor of the traction. Only such a factor may be
  // left to the load.
  // Numerators over 10^6, so that the fractions are exact at every precision.
  constexpr std::array<int, 9> fractions{1, 999'999, 500'000, 100, 10'000, 250'000, 800'000, 990'000, 999'900};
  using Operator = numeric::SlidingOperator<R>;
  const Operator A(grid, surface.s);
  const Operator by_tanh_sinh(surface.traction, surface.s, numeric::Route::tanh_sinh);
  const auto residual = [&surface](const Operator& a, const PanelPoint<R>& at) {
    return static_cast<double>(a.at(at).residual(surface.slope(at.node.x)));
  };
  std::vector<PanelPoint<R>> points;
  for (const int fraction : fractions) {
    for (std::size_t k = 0; k < surface.traction.size(); ++k) {
      points.push_back(grid.midpoint_near(k, R(fraction) / 1'000'000));
      findings.compare(equation_1, residual(A, points.back()));
    }
  }
  findings.compare(load_1, load_error(surface, grid.integral()));
  for (std::size_t i = 0; i < tanh_sinh_points && i < points.size(); ++i) {
    findings.compare(equation_2, residual(by_tanh_sinh, points[i]));
  }
  findings.compare(load_2, load_error(surface, tanh_sinh::integral<R>(surface.traction).value));
  return grid;
}

void check_surface_by_gsl(Findings& findings, const Surface<double>& surface) {
  const Quantity load{"total load `int t`, GSL in double", {"GSL's QAWS", "the load given"}, 1e-11};
  const Quantity equation{
      "`A t = u'/c`, GSL in double", {"`(1/pi) PV int t/(x'-x) dx'` by GSL's QAWC and QAWS", "`u'/c - s t`"}, 1e-11};
  const Estimate<double> integral = numeric::gsl::integral(surface.traction);
  if (integral.convergence == numeric::Convergence::reached) {
    findings.compare(load, load_error(surface, integral.value));
  } else {
    findings.skip(load);
  }
  const numeric::SlidingOperator<double> A(surface.traction, surface.s, numeric::Route::gsl);
  for (std::size_t k = 0; k < surface.traction.size(); ++k) {
    const numeric::Panel<double>& panel = surface.traction[k].panel;
    for (const double fraction : {0.25, 0.5, 0.8}) {
      const PanelPoint<double> at{k, panel.node_from_left(fraction * panel.length)};
      const numeric::SlidingTerms<double> terms = A.at(at);
      if (terms.hilbert.convergence == numeric::Convergence::reached) {
        findings.compare(equation, terms.residual(surface.slope(at.node.x)));
      } else {
        findings.skip(equation);
      }
    }
  }
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                                     \
  template Surface<R> surface_of(const PowerForm<R>&, const ContactProblem&, std::size_t, std::function<R(const R&)>); \
  template trapezoidal::Grid<R> check_surface(Findings&, const Surface<R>&, std::size_t);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
