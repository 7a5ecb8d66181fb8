// What the page may ask: a problem file's text in, numbers out, under the names that `steadyslide solve --format json` gives
// them. Lists of places come as a Float64Array a column.

#include <emscripten/bind.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "library/answer/solved_contact.hpp"
#include "library/problem_file/file_error.hpp"
#include "library/problem_file/problem_file.hpp"
#include "model/uniqueness.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/interior_stress.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"

namespace steadyslide::explorer {
namespace {

using emscripten::val;
using numeric::Estimate;
using Solution = std::shared_ptr<const numeric::ContactSolution<double>>;

/// Residuals above it are no solution's, as for the command line.
constexpr double largest_residual = 1e-9;

val text(const std::string& value) { return val(value); }
val text(std::string_view value) { return val(std::string(value)); }

/// A value of the page; null: unknown, or absent.
val shown(const Estimate<double>& estimate) {
  const bool known = std::isinf(estimate.value) || std::isfinite(estimate.error);
  return known ? val(estimate.value) : val::null();
}
val shown(std::size_t count) { return val(static_cast<double>(count)); }
val shown(const Exponent& exponent) { return val(numeric::to_real<double>(exponent)); }
val shown(const answer::IntervalOf<Estimate<double>>& interval) {
  val result = val::object();
  result.set("left", shown(interval.left));
  result.set("right", shown(interval.right));
  return result;
}
template <class T>
val shown(const std::optional<T>& value) {
  return value ? shown(*value) : val::null();
}
val shown(const numeric::LargestPressure<double>& largest) {
  val result = val::object();
  result.set("value", shown(largest.value));
  result.set("x", shown(largest.x));
  result.set("exponent", shown(largest.exponent));
  return result;
}
val shown(const std::vector<Estimate<double>>& values) {
  val result = val::array();
  for (const Estimate<double>& value : values) result.call<void>("push", shown(value));
  return result;
}

void set(val& object, const char* key, const Estimate<double>& estimate) { object.set(key, shown(estimate)); }

void set(val& object, const std::optional<Exponent>& exponent) {
  object.set("exponent", shown(exponent));
  object.set("sign", exponent ? exponent->sign() : -1);
  object.set("symbolic", exponent ? to_string(*exponent) : std::string("log"));
}

template <class T, class Write>
val list(const std::vector<T>& values, Write write) {
  val result = val::array();
  for (const T& value : values) result.call<void>("push", write(value));
  return result;
}

/// A copy that is JavaScript's own.
val column(const std::vector<double>& values) {
  return val::global("Float64Array").new_(val(emscripten::typed_memory_view(values.size(), values.data())));
}

val end(const numeric::ContactEnd<double>& end) {
  val result = val::object();
  set(result, "x", end.x);
  result.set("kind", text(name_of(end.kind)));
  set(result, end.exponent);
  set(result, "intensity", end.intensity);
  return result;
}

val contact(const numeric::ContactSolution<double>& solution, const std::vector<Estimate<double>>& loads) {
  val result = val::array();
  for (const auto& component : solution.contact()) {
    val zone = val::object();
    zone.set("left", end(component.left));
    zone.set("right", end(component.right));
    set(zone, "width", component.width);
    set(zone, "load", loads[result["length"].as<std::size_t>()]);
    result.call<void>("push", zone);
  }
  return result;
}

val singular_points(const numeric::ContactSolution<double>& solution) {
  return list(solution.singular_points(), [](const numeric::SolvedSingularPoint<double>& point) {
    val result = val::object();
    set(result, "x", point.x);
    result.set("kind", text(name_of(point.kind)));
    set(result, point.exponent);
    set(result, "intensity", point.intensity);
    set(result, "constant", point.constant);
    return result;
  });
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
  /// Empty, or what is wrong with the problem in one line. The solutions of both directions are then found.
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
    val result = val::object();
    result.set("method", solution_->method());
    result.set("failed_condition", solution_->failed_condition());
    result.set("contact", contact(*solution_, solution_->resultants().component_load));
    result.set("singular_points", singular_points(*solution_));
    result.set("resultants", resultants(*problem_, *solution_));
    val other = val::object();
    set(other, "effective_friction", opposite_->resultants().effective_friction);
    result.set("other_direction", other);
    const Uniqueness unique = uniqueness(*problem_);
    result.set("unique", unique.proved);
    return result;
  }

  /// Surface: `count` places in each contact component and gap. A traction without bound is infinite; the profile is psi.
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
    val result = val::object();
    result.set("x", column(x));
    result.set("traction", column(traction));
    result.set("shear", column(shear));
    result.set("gap", column(gap));
    result.set("profile", column(profile));
    return result;
  }

  /// The surface beyond the support, on the scale of the profile: psi - gap continued to these places.
  val surface_at(const val& places) const {
    const std::vector<double> x = emscripten::convertJSArrayToNumberVector<double>(places);
    const Rational& left = problem_->indenter().left();
    const numeric::DetailedSample<double> at_left = solution_->details_at(left);
    const double shift = height(numeric::to_real<double>(left)) - at_left.gap->value - at_left.displacement.value;
    std::vector<double> result;
    for (const double place : x) result.push_back(shift + solution_->details_at(Rational(place)).displacement.value);
    return column(result);
  }

  /// von Mises stress at columns x rows points in the middle of cells of [left, right] x [0, depth], row by row downwards.
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

  /// By a rule that no solver uses. `solved`: small enough for a solution, and no condition has failed.
  val residuals() const {
    const numeric::Residuals<double> found = solution_->residuals();
    val result = val::object();
    result.set("equation", found.equation);
    result.set("load", found.load);
    result.set("penetration", found.penetration);
    result.set("tension", found.tension);
    bool solved = solution_->failed_condition().empty();
    for (const double residual : {found.equation, found.load, found.penetration, found.tension}) {
      solved = solved && residual <= largest_residual;
    }
    result.set("solved", solved);
    return result;
  }

 private:
  static std::string solve_in_double(const ContactProblem& problem, Solution& solution) {
    numeric::Attempt<double> found = numeric::closed_form<double>(problem);
    if (!found.solution) found = numeric::riemann_hilbert<double>(problem, nullptr);
    solution = found.solution;
    return solution ? "" : found.reason;
  }

  double height(double x) const {
    double result = 0;
    const auto& of = problem_->indenter().profile(Rational(x), Side::right).coefficients();
    for (std::size_t k = of.size(); k-- > 0;) result = result * x + numeric::to_real<double>(of[k]);
    return result;
  }

  const numeric::InteriorStress<double>& interior() {
    if (!interior_) interior_.emplace(*solution_);
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
