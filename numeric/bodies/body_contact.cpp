#include "numeric/bodies/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "numeric/bodies/correction_sum.hpp"
#include "numeric/bodies/fixed_point.hpp"
#include "numeric/bodies/smooth_slope.hpp"
#include "numeric/layers/layer_field.hpp"
#include "numeric/periodic/repeated_contact.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/solution/gathered_forces.hpp"
#include "numeric/variational/cell_data.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::numeric {
namespace {

/// A solution on the half-plane under the corrected profile, as one of the body under its own.
class BodySolution : public RiemannHilbertSolution<double> {
 public:
  BodySolution(const ContactProblem& problem, const ContactProblem& corrected, const Frame& frame, const Search& search,
               std::shared_ptr<const SurfaceCorrection<double>> correction, double relative_error)
      : RiemannHilbertSolution<double>(corrected, frame, search),
        compliance_(to_real<double>(problem.elasticity().compliance())),
        origin_(to_real<double>(problem.origin_of_displacement())),
        correction_(std::move(correction), piecewise_traction()),
        relative_error_(relative_error) {
    const Body& body = problem.body();
    if (body.layers().empty()) return;
    layers_ =
        std::make_unique<LayerField>(problem, gathered_on_meshes(piecewise_traction(), LayerField::longest_part(body)));
  }

  Sample<double> at(const Rational& x) const override {
    Sample<double> result = RiemannHilbertSolution<double>::at(x);
    correct(result);
    return result;
  }
  std::vector<Sample<double>> samples(int count) const override {
    std::vector<Sample<double>> result = RiemannHilbertSolution<double>::samples(count);
    for (Sample<double>& sample : result) correct(sample);
    return result;
  }
  DetailedSample<double> details_at(const Rational& x) const override {
    return corrected(RiemannHilbertSolution<double>::details_at(x));
  }
  std::vector<DetailedSample<double>> detailed_samples(int count) const override {
    std::vector<DetailedSample<double>> result = RiemannHilbertSolution<double>::detailed_samples(count);
    for (DetailedSample<double>& sample : result) sample = corrected(sample);
    return result;
  }

 private:
  Estimate<double> estimate(double value) const { return {value, relative_error_ * std::abs(value)}; }
  void correct(Sample<double>& sample) const {
    const Estimate<double> slope = estimate(compliance_ * correction_.slope(sample.x));
    sample.slope = {sample.slope.left - slope, sample.slope.right - slope};
  }
  DetailedSample<double> corrected(DetailedSample<double> sample) const {
    correct(sample);
    sample.displacement =
        sample.displacement - estimate(compliance_ * (correction_.height(sample.x) - correction_.height(origin_)));
    // sigma_xx = (1 - 2 gamma) t + 2 u_t'/c at the surface.
    const Estimate<double> further =
        layers_ ? compliance_ / 2 * layers_->at(0, sample.x, 0)[0] : Estimate<double>{0, infinity<double>()};
    sample.shear_slope = {sample.shear_slope.left + further, sample.shear_slope.right + further};
    return sample;
  }

  double compliance_;
  double origin_;
  CorrectionSum correction_;
  double relative_error_;
  std::unique_ptr<const LayerField> layers_;  ///< absent for given symbols and periods
};

/// The iteration for w.
class CorrectedContact {
 public:
  CorrectedContact(const ContactProblem& problem, const ContactSolution<double>& cells)
      : problem_(problem),
        support_(to_real<double>(Rational(problem.indenter().right() - problem.indenter().left()))),
        correction_(surface_correction<double>(problem, 1.5 * support_)),
        left_(cells.contact().front().left.x.value),
        right_(cells.contact().back().right.x.value),
        slope_(problem.indenter(), left_, right_, [this](double x) { return radius(x); }),
        harmonics_(slope_.nodes().size()) {
    const auto compliance = to_real<double>(problem.elasticity().compliance());
    for (std::size_t i = 0; i < slope_.nodes().size(); ++i) {
      const Rational x(slope_.nodes()[i]);
      harmonics_(static_cast<Eigen::Index>(i)) = variational::harmonic_sum(problem, x).slope / compliance;
    }
  }

  Attempt<double> solve(const ContactSolution<double>& cells);

 private:
  using Solution = RiemannHilbertSolution<double>;

  /// Returns the distance of the singularities of w, as far as the contact's ends tell.
  double radius(double x) const {
    const double near = std::max({left_ - x, x - right_, 0.0});
    const double far = std::max(std::abs(left_ - x), std::abs(right_ - x));
    double result = std::min(correction_->radius(near), correction_->radius(far));
    // The series of a harmonic has no singularity, but needs panels that are not longer than its wave.
    for (const Harmonic& term : problem_.indenter().harmonics())
      result = std::min(result, to_real<double>(*problem_.body().period()) / term.n);
    return result;
  }
  /// Returns w at the nodes.
  Eigen::VectorXd correction_under(const ContactSolution<double>& solution) const {
    const CorrectionSum sum(correction_, solution.piecewise_traction());
    Eigen::VectorXd w(slope_.nodes().size());
    for (std::size_t i = 0; i < slope_.nodes().size(); ++i)
      w(static_cast<Eigen::Index>(i)) = sum.slope(slope_.nodes()[i]);
    return w;
  }
  ContactProblem corrected(const Eigen::VectorXd& w, SmoothSlope::Detail detail) {
    const Eigen::VectorXd sum = w + harmonics_;
    slope_.set({sum.begin(), sum.end()});
    return slope_.added_to(problem_, problem_.elasticity().compliance(), detail);
  }

  const ContactProblem& problem_;
  double support_;
  std::shared_ptr<const SurfaceCorrection<double>> correction_;
  double left_, right_;
  SmoothSlope slope_;
  Eigen::VectorXd harmonics_;  ///< the slope of the profile's harmonics over c, at the nodes
};

Attempt<double> CorrectedContact::solve(const ContactSolution<double>& cells) {
  if (slope_.nodes().empty()) return {nullptr, "the repeated contact has no gap, or lengths are out of range"};
  constexpr double widest = 10;
  if (right_ - left_ > widest * correction_->radius(0))
    return {nullptr, "the contact is more than 20 times as wide as the first layer is thick"};
  using Detail = SmoothSlope::Detail;
  constexpr int most_steps = 60, patience = 4;
  constexpr double enough = 2e-15, acceptable = 1e-9;
  AndersonIteration iteration;
  Eigen::VectorXd w = correction_under(cells);
  std::shared_ptr<const Solution> best;
  Eigen::VectorXd best_w;
  auto least = infinity<double>();
  // t is about P over the contact's width, and an error of w changes t by about as much.
  const double scale = to_real<double>(problem_.load()) / (right_ - left_);
  std::string reason;
  int without_progress = 0;
  Detail detail = Detail::rough;
  for (int step = 0; step < most_steps && least > enough && without_progress < patience; ++step) {
    // Rough polynomials change w by about their error, so more steps with them do not help.
    if (detail == Detail::rough && (least < 100 * slope_.relative_error(detail) || without_progress == patience - 1)) {
      detail = Detail::fine;
      least = infinity<double>();
      without_progress = 0;
    }
    if (!w.allFinite()) {
      reason = "a number is not finite";
      break;
    }
    const ContactSolution<double>& start = best ? *best : cells;
    const Attempt<double> found = riemann_hilbert<double>(corrected(w, detail), &start);
    if (!found.solution || !found.solution->failed_condition().empty()) {
      reason = found.solution ? found.solution->failed_condition() : found.reason;
      break;
    }
    const Eigen::VectorXd residual = correction_under(*found.solution) - w;
    const double change = residual.cwiseAbs().maxCoeff() / std::max(scale, w.cwiseAbs().maxCoeff());
    ++without_progress;
    if (change < least / 2) without_progress = 0;
    if (change < least) {
      least = change;
      best = std::dynamic_pointer_cast<const Solution>(found.solution);
      best_w = w;
    }
    w = iteration.next(w, residual);
  }
  if (!best || least > acceptable) {
    return {nullptr, "the correction of the surface did not converge: its last change is " + std::to_string(least) +
                         (reason.empty() ? "" : "; " + reason)};
  }
  const double error = 10 * (least + slope_.relative_error(detail));
  const auto search = [&](const RoundedProblem<double>& reduced, JacobiRules<double>&) {
    const ContactState<double>& state = best->state();
    StateErrors<double> errors = best->state_errors();
    errors.ends.distance += error * state.set.span_length();
    errors.ends.length += error;
    errors.tilt += error * reduced.load();
    const bool has_poles = !best->form().y().pivots().empty();
    if (errors.polynomial.empty()) errors.polynomial.resize(has_poles ? state.set.components() : 1);
    for (double& coefficient : errors.polynomial) coefficient += error * reduced.load();
    return SearchResult<double>{
        {ContactSet<double>::converted(reduced, state.set), state.q, state.tilt}, errors, {}, best->hairline_gaps()};
  };
  return {std::make_shared<BodySolution>(problem_, corrected(best_w, detail), best->problem().frame(), search,
                                         correction_, error),
          {}};
}

}  // namespace

Attempt<double> contact_on_body(const ContactProblem& problem) {
  const Attempt<double> cells = variational_inequality(problem, {.cells = 1024});
  if (!cells.solution || !cells.solution->failed_condition().empty())
    return {nullptr, cells.solution ? cells.solution->failed_condition() : cells.reason};
  // The cells cover the support, in periodic contact one period whose ends lie in a gap.
  const Rational begin = cells.solution->equal_cells()->left;
  const ContactProblem solved = beginning_at(begin, problem);
  Attempt<double> found = CorrectedContact(solved, *cells.solution).solve(*cells.solution);
  return {repeated(problem, begin, std::move(found.solution)), std::move(found.reason)};
}

}  // namespace steadyslide::numeric
