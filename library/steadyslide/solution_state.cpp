#include "library/steadyslide/solution_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "library/answer/solved_contact.hpp"
#include "library/solve/double_range.hpp"
#include "library/solve/failed_condition.hpp"
#include "library/solve/warnings.hpp"
#include "library/text/number_format.hpp"
#include "numeric/interior/average_stress.hpp"
#include "numeric/interior/interface_stress.hpp"
#include "numeric/interior/interior_displacement.hpp"
#include "numeric/interior/interior_stress.hpp"
#include "numeric/interior/largest_stress.hpp"
#include "numeric/interior/surface_stress.hpp"
#include "numeric/number/once.hpp"
#include "numeric/solution/nodal_forces.hpp"
#include "numeric/variational/variational_solution.hpp"

namespace steadyslide {
namespace {

using numeric::Estimate;
using numeric::Real;

/// Converts estimates of one precision to numbers with `digits` digits, or without a text for 0: for many numbers the
/// texts would cost more than the numbers.
template <Real R>
struct Numbers {
  int digits;

  Number operator()(const Estimate<R>& estimate) const {
    using std::abs, std::isinf, std::isnan;
    const R& value = estimate.value;
    if (isnan(value) || (isinf(estimate.error) && !isinf(value))) return unknown_number();
    const auto nearest = static_cast<double>(value);
    std::string text = digits > 0 ? library::full_number(value, digits) : "";
    R error = estimate.error;
    if (!isinf(value)) error = digits > 0 ? library::error_of_text(text, estimate) : R(error + abs(R(nearest) - value));
    return {nearest, rounded_up(error), std::move(text)};
  }
  Number operator()(const Exponent& exponent) const { return number_of(exponent, digits); }
  Limits operator()(const numeric::TwoSided<R>& limits) const { return {(*this)(limits.left), (*this)(limits.right)}; }
  template <class T>
  auto operator()(const std::optional<T>& value) const {
    return value ? std::optional((*this)(*value)) : std::nullopt;
  }
  LargestPressure operator()(const numeric::LargestPressure<R>& largest) const {
    return {(*this)(largest.value), (*this)(largest.x), (*this)(largest.exponent)};
  }
  ContactEnd operator()(const numeric::ContactEnd<R>& end) const {
    return {(*this)(end.x), std::string(name_of(end.kind)), (*this)(end.exponent), (*this)(end.intensity)};
  }
  Stress operator()(const numeric::StressState<R>& state) const {
    Stress stress{(*this)(state.xx),
                  (*this)(state.zz),
                  (*this)(state.xz),
                  (*this)(state.largest_shear()),
                  (*this)(state.yy),
                  (*this)(state.mean()),
                  (*this)(state.von_mises()),
                  {},
                  {},
                  {},
                  {}};
    if (state.gradient) {
      const auto& [x_x, x_z, z_x, z_z] = *state.gradient;
      stress.ux_x = (*this)(x_x);
      stress.ux_z = (*this)(x_z);
      stress.uz_x = (*this)(z_x);
      stress.uz_z = (*this)(z_z);
    }
    return stress;
  }

  static double rounded_up(const R& error) {
    const auto nearest = static_cast<double>(error);
    return R(nearest) < error ? std::nextafter(nearest, std::numeric_limits<double>::infinity()) : nearest;
  }
  static Number unknown_number() {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), ""};
  }
};

/// The exact nodes of a mesh. A midside node that misses the middle of its element by rounding only is moved to the
/// middle.
std::vector<Rational> nodes_of(const Mesh& mesh) {
  std::vector<Rational> nodes;
  for (const Exact& node : mesh.nodes) nodes.push_back(rational(node, "nodes[" + std::to_string(nodes.size()) + "]"));
  for (std::size_t k = 2; mesh.order == 2 && k < nodes.size(); k += 2) {
    const Rational middle = (nodes[k - 2] + nodes[k]) / 2;
    const Rational rounding = Rational(1, Integer(1000000000000)) * (abs(nodes[k - 2]) + abs(nodes[k]));
    if (abs(nodes[k - 1] - middle) <= rounding) nodes[k - 1] = middle;
  }
  return nodes;
}

template <Real R>
std::vector<R> reals(std::span<const double> x) {
  return {x.begin(), x.end()};
}

template <Real R>
class SolvedIn final : public Solution::State {
 public:
  SolvedIn(const Problem& of, std::shared_ptr<const numeric::ContactSolution<R>> solution, const SolveWanted& wanted,
           std::string of_another)
      : State(of), solution_(std::move(solution)), number_{wanted.digits}, over_(wanted.over) {
    digits = wanted.digits;
    instead = std::move(of_another);
    method = solution_->method();
    const bool on_cells = solution_->equal_cells().has_value();
    failed_condition =
        library::failed_condition(*solution_, solution_->residuals(),
                                  on_cells ? std::numeric_limits<double>::infinity()
                                           : library::largest_residual_of(contact_problem(of), *solution_));
    if (on_cells && failed_condition.empty() && !is_in_range()) failed_condition = "values out of the range of double";
  }

  bool is_in_range() const override {
    for (const auto& component : solution_->contact()) {
      for (const auto* end : {&component.left, &component.right}) {
        if (!library::is_in_range(end->x) || !library::is_in_range(end->intensity, library::has_double<R>)) {
          return false;
        }
      }
    }
    return std::ranges::all_of(solution_->resultants().load_share,
                               [](const Estimate<R>& share) { return library::is_in_range(share); });
  }

  std::vector<std::string> warnings() const override { return library::warnings(data_of(problem).problem, *solution_); }

  std::vector<ContactComponent> contact() const override {
    const auto components = solution_->contact();
    const auto loads = solution_->resultants().component_load;
    std::vector<ContactComponent> result;
    for (std::size_t k = 0; k < components.size(); ++k) {
      const auto& [left, right, width] = components[k];
      result.push_back({number_(left), number_(right), number_(width), number_(loads[k])});
    }
    return result;
  }

  std::vector<SolvedPoint> singular_points() const override {
    std::vector<SolvedPoint> result;
    for (const auto& point : solution_->singular_points()) {
      result.push_back({number_(point.x), std::string(name_of(point.kind)), number_(point.exponent),
                        point.exponent ? to_string(*point.exponent) : "", number_(point.intensity),
                        number_(point.constant), number_(point.stress_intensity.left),
                        number_(point.stress_intensity.right)});
    }
    return result;
  }

  std::vector<UnresolvedGap> unresolved_gaps() const override {
    std::vector<UnresolvedGap> result;
    for (const auto& [x, log10_length] : solution_->unresolved_gaps()) result.push_back({number_(x), log10_length});
    return result;
  }

  Residuals residuals() const override {
    const auto& [equation, load, penetration, tension] = solution_->residuals();
    const auto number = [](const R& value) { return static_cast<double>(value); };
    return {number(equation), number(load), number(penetration), number(tension)};
  }

  EstimatedError estimated_error() const override {
    const auto& [ends, traction, resultants] = solution_->estimated_error();
    return {static_cast<double>(ends), static_cast<double>(traction), static_cast<double>(resultants)};
  }

  Resultants resultants() const override {
    return answer::resultants_of<Resultants>(library::SolvedContact<R>(contact_problem(problem), *solution_, over_),
                                             number_);
  }

  SurfaceSample at(const Rational& x, bool detailed) const override {
    if (!detailed) return sample(solution_->at(x));
    const numeric::DetailedSample<R> found = solution_->details_at(x);
    SurfaceSample result = sample(found);
    result.displacement = number_(found.displacement);
    result.shear_slope = number_(found.shear_slope);
    result.cumulative_load = number_(found.cumulative_load);
    return result;
  }

  std::pair<std::vector<double>, std::vector<double>> tractions(std::span<const double> x) const override {
    std::vector<R> normal(x.size());
    std::vector<R> shear(x.size());
    solution_->tractions(reals<R>(x), normal, shear);
    const auto doubles = [](const std::vector<R>& values) {
      std::vector<double> result;
      for (const R& value : values) result.push_back(static_cast<double>(value));
      return result;
    };
    return {doubles(normal), doubles(shear)};
  }

  Stress stress(const Rational& x, const Rational& z) const override {
    if (z == 0) return number_(at_surface(x));
    check_depth(numeric::to_real<R>(z), to_string(z));
    return number_(interior().at(x, z));
  }

  std::vector<Stress> stress(std::span<const double> x, std::span<const double> z) const override {
    std::vector<R> depths = reals<R>(z);
    for (R& depth : depths) {
      // The stress at the surface follows from the traction.
      if (depth == 0) {
        depth = 1;
      } else {
        check_depth(depth, Exact(static_cast<double>(depth)).text());
      }
    }
    std::vector<numeric::StressState<R>> states(x.size());
    interior().at(reals<R>(x), depths, states);
    std::vector<Stress> result;
    result.reserve(states.size());
    for (std::size_t k = 0; k < states.size(); ++k) {
      if (z[k] == 0) states[k] = at_surface(Rational(x[k]));
      result.push_back(Numbers<R>{0}(states[k]));
    }
    return result;
  }

  Displacement displacement(const Rational& x, const Rational& z) const override {
    const numeric::InteriorDisplacement<R>& displacement = displacement_([&] {
      return numeric::InteriorDisplacement<R>(interior().traction(), contact_problem(problem).origin_of_displacement());
    });
    const auto found = displacement.at(x, z);
    return {number_(found.x), number_(found.z)};
  }

  LargestStress max_stress(const std::optional<Rational>& depth, const std::optional<Rational>& over) const override {
    const R usual = over ? R(0) : numeric::default_depth(*solution_);
    const R least = depth ? numeric::to_real<R>(*depth) : usual;
    LargestStress result;
    result.depth = number_(Estimate<R>{least});
    std::optional<numeric::LargestStress<R>> largest;
    if (over) {
      if constexpr (std::same_as<R, double>) {
        const numeric::AverageStress<R> averages(interior().traction(), numeric::to_real<R>(*over));
        largest = numeric::largest_stress<R>(averages, least);
      } else {
        throw InvalidData("over", "over: too many digits", numeric::digits_of_averages, "50 or 100");
      }
    } else {
      for (const Estimate<R>& x : numeric::unbounded_places(*solution_)) result.unbounded_at.push_back(number_(x));
      largest = numeric::largest_stress<R>(interior(), least);
    }
    result.von_mises = largest ? number_(largest->von_mises) : Numbers<R>::unknown_number();
    result.x = largest ? number_(largest->x) : Numbers<R>::unknown_number();
    result.z = largest ? number_(largest->z) : Numbers<R>::unknown_number();
    return result;
  }

  std::vector<InterfaceStress> interface_stress() const override {
    std::vector<InterfaceStress> result;
    if constexpr (std::same_as<R, double>) {
      for (const auto& [depth, shear, shear_x, tension, tension_x] : numeric::interface_stresses(interior())) {
        result.push_back(
            {number_(Estimate<double>{depth}), number_(shear), number_(shear_x), number_(tension), number_(tension_x)});
      }
    }
    return result;
  }

  std::vector<NodalForce> nodal_forces(const Mesh& mesh) const override {
    std::vector<NodalForce> result;
    for (const auto& force : numeric::nodal_forces(interior().traction(), SurfaceMesh(nodes_of(mesh), mesh.order))) {
      result.push_back({number_(force.normal), number_(force.tangential)});
    }
    return result;
  }

  AnySolution solution() const override { return solution_.get(); }

  ApproximateContact approximate_contact() const override { return solution_->approximate_contact(); }

  std::optional<std::vector<double>> touching_pressures() const override {
    const auto* on_cells = dynamic_cast<const numeric::VariationalSolution*>(solution_.get());
    return on_cells != nullptr ? std::optional(on_cells->touching_pressures()) : std::nullopt;
  }

 private:
  SurfaceSample sample(const numeric::Sample<R>& found) const {
    return {number_(found.traction), number_(found.shear), number_(found.gap), number_(found.slope), {}, {}, {}};
  }

  static void check_depth(const R& z, const std::string& text) {
    if (numeric::InteriorStress<R>::reaches(z)) return;
    throw InvalidData("z", "z: depth too small for 16 digits",
                      "its square is a number of that precision; ask for 50 digits", text);
  }

  numeric::StressState<R> at_surface(const Rational& x) const {
    return numeric::surface_stress(contact_problem(problem).elasticity(), solution_->details_at(x));
  }

  const numeric::InteriorStress<R>& interior() const {
    return interior_([&] {
      return contact_problem(problem).body().symbols()
                 ? numeric::InteriorStress<R>(*solution_)
                 : numeric::InteriorStress<R>(contact_problem(problem), *solution_);
    });
  }

  std::shared_ptr<const numeric::ContactSolution<R>> solution_;
  Numbers<R> number_;
  std::optional<Rational> over_;
  numeric::Once<numeric::InteriorStress<R>> interior_;
  numeric::Once<numeric::InteriorDisplacement<R>> displacement_;
};

template <Real R>
std::shared_ptr<const Solution::State> state_of(const Problem& problem, const numeric::Attempt<R>& attempt,
                                                const SolveWanted& wanted, std::string instead = {}) {
  if (attempt.solution) return std::make_shared<SolvedIn<R>>(problem, attempt.solution, wanted, std::move(instead));
  const bool closed = wanted.method == library::Method::closed_form;
  const std::string& name = data_of(problem).problem.file;
  throw InvalidData(closed ? "method closed-form: no closed form applies; " + attempt.reason
                           : (name.empty() ? "" : name + ": ") + attempt.reason);
}

}  // namespace

std::shared_ptr<const Solution::State> solved_state(const Problem& problem, const SolveWanted& wanted,
                                                    const Solution::State* start) {
  const ContactProblem& contact = contact_problem(problem);
  const auto on_cells = [&](std::string instead) {
    return state_of<double>(problem, numeric::variational_inequality(contact, wanted.variational), wanted,
                            std::move(instead));
  };
  if (library::takes_variational(wanted.method, contact, false, wanted.digits)) return on_cells({});
  const std::shared_ptr<const Solution::State> found = library::in_precision(
      wanted.digits, contact, {},
      [&]<Real R>() {
        const auto* before = dynamic_cast<const SolvedIn<R>*>(start);
        const auto* solution =
            before != nullptr ? std::get<const numeric::ContactSolution<R>*>(before->solution()) : nullptr;
        return state_of<R>(problem, library::attempt<R>(wanted.method, contact, solution), wanted);
      },
      [](const std::shared_ptr<const Solution::State>& state) {
        return state->failed_condition.empty() && state->is_in_range();
      });
  if (found->failed_condition.empty() || !library::may_fall_back(wanted.method, wanted.digits)) return found;
  const std::shared_ptr<const Solution::State> cells = on_cells(library::fallen_back(found->failed_condition));
  return cells->failed_condition.empty() ? cells : found;
}

}  // namespace steadyslide
