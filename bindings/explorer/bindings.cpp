// The functions that the page calls. They take the text of a problem file and return numbers, under the names of `solve
// --format json`. A list of places is a Float64Array.

#include <emscripten/bind.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "library/answer/solved_contact.hpp"
#include "library/problem_file/file_error.hpp"
#include "library/problem_file/problem_file.hpp"
#include "model/uniqueness.hpp"
#include "numeric/bodies/body_contact.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/interior_stress.hpp"
#include "numeric/periodic/repeated_contact.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/cell_data.hpp"

namespace steadyslide::explorer {
namespace {

using emscripten::val;
using numeric::Estimate;
using Solution = std::shared_ptr<const numeric::ContactSolution<double>>;

/// A state with a larger residual is not a solution, as for the command line.
constexpr double largest_residual = 1e-9;

val text(std::string_view value) { return val(std::string(value)); }

val object(const std::vector<std::pair<const char*, val>>& entries) {
  val result = val::object();
  for (const auto& [key, value] : entries) result.set(key, value);
  return result;
}

/// A value for the page; null if it is unknown or absent.
val shown(const Estimate<double>& estimate) {
  const bool known = std::isinf(estimate.value) || std::isfinite(estimate.error);
  return known ? val(estimate.value) : val::null();
}
val shown(std::size_t count) { return val(static_cast<double>(count)); }
val shown(const Exponent& exponent) { return val(numeric::to_real<double>(exponent)); }
val shown(const answer::IntervalOf<Estimate<double>>& interval) {
  return object({{"left", shown(interval.left)}, {"right", shown(interval.right)}});
}
template <class T>
val shown(const std::optional<T>& value) {
  return value ? shown(*value) : val::null();
}
val shown(const numeric::LargestPressure<double>& largest) {
  return object({{"value", shown(largest.value)}, {"x", shown(largest.x)}, {"exponent", shown(largest.exponent)}});
}

/// The common members of an end of contact and a singular point.
template <class Point>
val point_object(const Point& point) {
  const std::optional<Exponent> exponent = point.exponent;
  return object({{"x", shown(point.x)},
                 {"kind", text(name_of(point.kind))},
                 {"words", text(local_terms(point.kind).words)},
                 {"exponent", shown(exponent)},
                 {"sign", val(exponent ? exponent->sign() : -1)},
                 {"symbolic", text(exponent ? to_string(*exponent) : "log")},
                 {"intensity", shown(point.intensity)}});
}
val shown(const numeric::SolvedSingularPoint<double>& point) {
  val result = point_object(point);
  result.set("constant", shown(point.constant));
  return result;
}

template <class T>
val shown(const std::vector<T>& values) {
  val result = val::array();
  for (const T& value : values) result.call<void>("push", shown(value));
  return result;
}

/// A copy that JavaScript owns.
val column(const std::vector<double>& values) {
  return val::global("Float64Array").new_(val(emscripten::typed_memory_view(values.size(), values.data())));
}

val contact(const numeric::ContactSolution<double>& solution) {
  const std::vector<Estimate<double>> loads = solution.resultants().component_load;
  val result = val::array();
  std::size_t k = 0;
  for (const auto& [left, right, width] : solution.contact()) {
    result.call<void>("push", object({{"left", point_object(left)},
                                      {"right", point_object(right)},
                                      {"width", shown(width)},
                                      {"load", shown(loads[k++])}}));
  }
  return result;
}

/// The quantities of the table (library/answer/quantities.hpp).
val resultants(const ContactProblem& problem, const numeric::ContactSolution<double>& solution) {
  val result = val::object();
  answer::for_each_value(
      library::SolvedContact<double>(problem, solution),
      [&](const answer::Quantity& row, const auto& value) { result.set(std::string(row.key), shown(value)); });
  return result;
}

class Explorer {
 public:
  /// Solves for both directions of sliding. Returns an empty text, or the error of the problem in one line.
  std::string solve(const std::string& problem_file) try {
    problem_.emplace(library::parse_problem(problem_file, "problem").contact);
    const bool forwards = problem_->sliding() == Sliding::plus_x;
    interior_.reset();
    solution_ = nullptr;
    opposite_ = nullptr;
    const std::string reason = solve_in_double(*problem_, solution_);
    if (!reason.empty()) return reason;
    return solve_in_double(problem_->with_sliding(forwards ? Sliding::minus_x : Sliding::plus_x), opposite_);
  } catch (const library::InvalidFile& invalid) {
    return invalid.complaint();
  } catch (const std::exception& error) {
    return error.what();
  }

  val solution() const {
    return object(
        {{"method", text(solution_->method())},
         {"failed_condition", text(solution_->failed_condition())},
         {"uniqueness", text(uniqueness_theorem(*problem_))},
         {"contact", contact(*solution_)},
         {"singular_points", shown(solution_->singular_points())},
         {"resultants", resultants(*problem_, *solution_)},
         {"other_direction", object({{"effective_friction", shown(opposite_->resultants().effective_friction)}})}});
  }

  /// Samples of the surface: `count` places in each contact component and gap. An unbounded traction is infinite; the
  /// profile is psi.
  val samples(int count) const {
    std::vector<double> x, traction, shear, gap, profile;
    for (const numeric::Sample<double>& sample : solution_->samples(count)) {
      const bool left = sample.traction.left.value < sample.traction.right.value;
      x.push_back(sample.x);
      traction.push_back(left ? sample.traction.left.value : sample.traction.right.value);
      shear.push_back(left ? sample.shear.left.value : sample.shear.right.value);
      gap.push_back(sample.gap ? sample.gap->value : std::nan(""));
      profile.push_back(height(sample.x));
    }
    return object({{"x", column(x)},
                   {"traction", column(traction)},
                   {"shear", column(shear)},
                   {"gap", column(gap)},
                   {"profile", column(profile)}});
  }

  /// Heights of the surface beyond the support, on the scale of the profile: psi - gap, continued to these places.
  val surface_at(const val& places) const {
    const std::vector<double> x = emscripten::convertJSArrayToNumberVector<double>(places);
    const Rational& left = problem_->indenter().left();
    const numeric::DetailedSample<double> at_left = solution_->details_at(left);
    const double shift = height(numeric::to_real<double>(left)) - at_left.gap->value - at_left.displacement.value;
    std::vector<double> result;
    for (const double place : x) result.push_back(shift + solution_->details_at(Rational(place)).displacement.value);
    return column(result);
  }

  /// Von Mises stress at columns x rows points, in the middle of cells of [left, right] x [0, depth], row by row
  /// downwards. Not a number in a rigid base.
  val stresses(double left, double right, double depth, int columns, int rows) {
    std::vector<double> x, z;
    for (int row = 0; row < rows; ++row) {
      for (int k = 0; k < columns; ++k) {
        x.push_back(left + (right - left) * (k + 0.5) / columns);
        z.push_back(depth * (row + 0.5) / rows);
      }
    }
    std::vector<numeric::StressState<double>> states(x.size());
    interior().at(x, z, states);
    std::vector<double> result;
    for (const auto& state : states) {
      const auto von_mises = state.von_mises();
      result.push_back(von_mises ? von_mises->value : state.largest_shear().value);
    }
    return column(result);
  }

  /// Residuals by a rule that no solver uses. `solved`: they are small enough for a solution, and no condition has
  /// failed.
  val residuals() const {
    const numeric::Residuals<double> found = solution_->residuals();
    bool solved = solution_->failed_condition().empty();
    for (const double residual : {found.equation, found.load, found.penetration, found.tension}) {
      solved = solved && residual <= largest_residual;
    }
    return object({{"equation", val(found.equation)},
                   {"load", val(found.load)},
                   {"penetration", val(found.penetration)},
                   {"tension", val(found.tension)},
                   {"solved", val(solved)}});
  }

 private:
  static std::string solve_in_double(const ContactProblem& problem, Solution& solution) {
    numeric::Attempt<double> found = numeric::closed_form<double>(problem);
    if (!found.solution) {
      found = problem.body().is_half_plane() ? numeric::riemann_hilbert<double>(problem, nullptr)
                                             : numeric::contact_on_body(problem);
    }
    solution = found.solution;
    return solution ? "" : found.reason;
  }

  double height(double x) const {
    const Rational& left = problem_->indenter().left();
    const std::optional<Rational>& period = problem_->body().period();
    const Rational place = period ? numeric::moved_into(Rational(x), left, *period) : Rational(x);
    x = numeric::to_real<double>(place);
    double result = 0;
    const auto& of = problem_->indenter().profile(place, Side::right).coefficients();
    for (std::size_t k = of.size(); k-- > 0;) result = result * x + numeric::to_real<double>(of[k]);
    return result + numeric::variational::harmonic_sum(*problem_, place).height;
  }

  const numeric::InteriorStress<double>& interior() {
    if (!interior_) interior_.emplace(*problem_, *solution_);
    return *interior_;
  }

  std::optional<ContactProblem> problem_;
  Solution solution_;
  Solution opposite_;
  std::optional<numeric::InteriorStress<double>> interior_;
};

}  // namespace

EMSCRIPTEN_BINDINGS(explorer) {
  emscripten::class_<Explorer>("Explorer")
      .constructor<>()
      .function("solve", &Explorer::solve)
      .function("solution", &Explorer::solution)
      .function("samples", &Explorer::samples)
      .function("surface", &Explorer::surface_at)
      .function("stresses", &Explorer::stresses)
      .function("residuals", &Explorer::residuals);
}

}  // namespace steadyslide::explorer
