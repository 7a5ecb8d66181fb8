// Samples of a solution on cells at places of the surface, and integrals of the pressures for these samples.

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

#include "numeric/number/node.hpp"
#include "numeric/solution/gathered_forces.hpp"
#include "numeric/solution/mesh_error.hpp"
#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns values at the middles of equal cells, interpolated linearly. `cells` is the distance from the first middle,
/// in cell lengths.
double interpolated(const std::vector<double>& values, double cells) {
  const std::size_t i = cells <= 0 ? 0 : std::min(static_cast<std::size_t>(cells), values.size() - 2);
  return values[i] + (cells - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

/// The same at xi, on cells of [-1/2, 1/2]; constant beyond the outermost middles.
double interpolated_within(const std::vector<double>& values, double xi) {
  const auto n = static_cast<double>(values.size());
  return interpolated(values, std::clamp((xi + 0.5) * n - 0.5, 0.0, n - 1));
}

/// Returns the sum of f(i) over all cells in contact.
template <class F>
double sum_over(const std::vector<VariationalSolution::Run>& runs, const F& f) {
  double sum = 0;
  for (const VariationalSolution::Run& run : runs) {
    for (std::size_t i = run.begin; i < run.end; ++i) sum += f(i);
  }
  return sum;
}

/// The ratio of shear to normal traction at places from left to right.
class ShearRatios {
 public:
  ShearRatios(const ContactProblem& problem, const variational::CellMesh& mesh) : problem_(problem), mesh_(mesh) {
    set();
  }
  /// Returns the mean over a cell. Cells are asked for from left to right.
  double over(double left, double right) {
    const double length = right - left;
    double sum = 0;
    for (; next_ < right; ++piece_, set()) {
      sum += ratio_ * std::max(next_ - left, 0.0);
      left = std::max(next_, left);
    }
    return (sum + ratio_ * (right - left)) / length;
  }

 private:
  void set() {
    ratio_ = to_real<double>(problem_.shear_ratio(piece_));
    const std::vector<Rational>& jumps = problem_.friction().jumps();
    next_ = piece_ == jumps.size() ? infinity<double>() : mesh_.place(jumps[piece_]);
  }

  const ContactProblem& problem_;
  const variational::CellMesh& mesh_;
  std::size_t piece_ = 0;
  double ratio_ = 0;
  double next_ = 0;  ///< the end of the piece
};

}  // namespace

using variational::DiscreteState;

Estimate<double> VariationalSolution::traction(std::size_t cell) const {
  const double t = traction_[cell];
  if (t == 0) return {};
  // The expected change on the next mesh, and the variation of t within the cell.
  const double before = cell > 0 ? traction_[cell - 1] : t;
  const double after = cell + 1 < traction_.size() ? traction_[cell + 1] : t;
  const double variation = std::max(std::abs(t - before), std::abs(t - after)) / 2;
  return {t, std::max(std::abs(t - coarse_traction(cell)), variation)};
}

double VariationalSolution::displacement(double xi) const {
  return interpolated(displacement_, (xi - mesh().left(0)) / mesh().length(0) - 0.5);
}

double VariationalSolution::displacement_beyond(const variational::MeshSolution& solution, double xi) const {
  const variational::CellMesh& cells = solution.problem->mesh();
  const variational::CellFriction& friction = solution.problem->galerkin_operator().friction();
  const bool feels_friction = (xi > 0) == (friction.sign > 0);
  const double h = cells.length(0);
  double sum = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double p = solution.found.state.pressure[i];
    if (p == 0) continue;
    sum += p * cells.length(i) * kernel().mean_from_point(cells.left(i), cells.right(i), xi);
    if (feels_friction) sum += friction.sign * p * friction.whole[i];
    if (!friction.signed_friction.empty())
      sum += p * friction.signed_friction[i] * kernel().coupling_from_equal_cell(h, (xi - cells.centre(i)) / h);
  }
  return sum;
}

double VariationalSolution::height_in_units(const Rational& x) const {
  return to_real<double>(Rational(variational::profile_above_middle(problem_, x) /
                                  (problem_.elasticity().compliance() * problem_.load()))) +
         variational::harmonic_sum(problem_, x).height / height_;
}

bool VariationalSolution::is_on_support(const Rational& x) const {
  return x >= problem_.indenter().left() && x <= problem_.indenter().right();
}

Estimate<double> VariationalSolution::gap(const Rational& x, double fine, double coarse, double rounding) const {
  const double height = height_in_units(x), xi = mesh().place(x);
  const double tilted = std::abs(xi) * open_error([](const MeshLoads& on) { return on.tilt; });
  const double moved = open_error([](const MeshLoads& on) { return on.approach; });
  return {height_ * (height + state().tilt * xi + fine - state().approach),
          height_ * (2 * std::abs(fine - coarse) + tilted + moved + rounding + 1e-15 * std::abs(height))};
}

TwoSided<double> VariationalSolution::slope_beyond(double slope) const {
  const Estimate<double> estimate{slope, std::abs(slope) * estimated_error().traction};
  return {estimate, estimate};
}

Sample<double> VariationalSolution::outside(const Rational& x) const {
  const double xi = mesh().place(x);
  const double sum = sum_over(runs_, [&](std::size_t i) {
    return state().pressure[i] * kernel().slope(mesh().left(i), mesh().right(i), xi, signed_friction(i));
  });
  Sample<double> result{to_real<double>(x), {}, {}, std::nullopt, {}};
  result.slope = slope_beyond(-height_ / unit_ * sum / std::numbers::pi);
  if (is_on_support(x)) {
    result.gap = gap(x, displacement_beyond(found_.fine, xi), displacement_beyond(found_.coarse, xi), 0);
  }
  return result;
}

Sample<double> VariationalSolution::at(const Rational& x) const {
  const Frame& frame = mesh().frame();
  if (2 * abs(x - frame.origin) > frame.unit) return outside(x);
  const double xi = mesh().place(x);
  const std::size_t right = mesh().cell_at(xi);
  const std::size_t left = right > 0 && xi == mesh().left(right) ? right - 1 : right;
  const variational::CellSet& contact = found_.fine.found.contact;
  Sample<double> result{to_real<double>(x), {}, {}, std::nullopt, {}};
  result.traction = {traction(left), traction(right)};
  const auto shear = [&](const Estimate<double>& t, Side side) {
    const auto ratio = to_real<double>(problem_.shear_ratio(problem_.friction().piece(x, side)));
    return ratio == 0 || t.value == 0 ? Estimate<double>{} : ratio * t;
  };
  result.shear = {shear(result.traction.left, Side::left), shear(result.traction.right, Side::right)};

  const auto curvature = [&](std::size_t i) {
    const std::size_t k = std::clamp<std::size_t>(i, 1, displacement_.size() - 2);
    return std::abs(displacement_[k - 1] - 2 * displacement_[k] + displacement_[k + 1]);
  };
  if (contact[left] || contact[right]) {
    result.gap = Estimate<double>{};
  } else {
    // The curvature is the error of linear interpolation between cells.
    result.gap = gap(x, displacement(xi), displacement(xi), curvature(right));
  }
  const auto slope = [&](std::size_t cell, Side side) -> Estimate<double> {
    if (contact[cell]) {
      const double profile = to_real<double>(problem_.indenter().profile(x, side).derivative()(x)) +
                             variational::harmonic_sum(problem_, x).slope;
      const double value = profile + height_ / unit_ * state().tilt;
      return {value, 4e-16 * std::abs(value)};
    }
    // Outside the contact u' = -(c P/unit) d(B p)/dxi, by differences.
    const std::size_t k = std::clamp<std::size_t>(cell, 1, displacement_.size() - 2);
    const double scale = -height_ / (unit_ * mesh().length(0));
    return {scale * (displacement_[k + 1] - displacement_[k - 1]) / 2, std::abs(scale) * curvature(k)};
  };
  result.slope = {slope(left, Side::left), slope(right, Side::right)};
  return result;
}

std::vector<Rational> VariationalSolution::sampled_places(int count) const {
  std::vector<Rational> result;
  const Rational origin = mesh().frame().origin;
  const auto sample_between = [&](double from, double to) {
    for (int i = 0; i < count && from < to; ++i) {
      const auto [before, after] = chebyshev_position<double>(i, count);
      const double x = before < after ? from + before * (to - from) : to - after * (to - from);
      result.push_back(origin + Rational(x));
    }
  };
  double end = unit_ * mesh().place(problem_.indenter().left());
  for (const Run& run : runs_) {
    sample_between(end, edges_[run.begin]);
    sample_between(edges_[run.begin], edges_[run.end]);
    end = edges_[run.end];
  }
  sample_between(end, unit_ * mesh().place(problem_.indenter().right()));
  return result;
}

PiecewiseTraction<double> VariationalSolution::piecewise_traction() const {
  PiecewiseTraction<double> result = traction_on(meshes_.front());
  for (std::size_t k = 1; k < meshes_.size(); ++k) result.add_coarser(traction_on(meshes_[k]));
  PiecewiseTraction<double>::MeshRates rates{mesh_rate_, mesh_rate_};
  for (const SingularPlace& place : places_) {
    if (place.exponent) rates.surface_rate = std::min(rates.surface_rate, 1 + to_real<double>(*place.exponent));
  }
  result.set_mesh_rates(rates);
  return result;
}

PiecewiseTraction<double> VariationalSolution::traction_on(const MeshLoads& loads) const {
  const std::vector<Rational>& jumps = problem_.friction().jumps();
  const SurfacePlace<double> middle = SurfacePlace<double>::of(mesh().frame().origin);
  const std::size_t cells = loads.before.size() - 1;
  const double cell = 1 / static_cast<double>(cells);
  PiecewiseTraction<double> result(problem_.elasticity());
  std::size_t piece = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const double load = loads.before[i + 1] - loads.before[i];
    double left = static_cast<double>(i) * cell - 0.5;
    const auto add = [&](double to) {
      if (to <= left || load == 0) return;
      result.add(middle.moved(unit_ * left), middle.moved(unit_ * to), unit_ * (to - left), -stress_ * load / cell,
                 to_real<double>(problem_.shear_ratio(piece)));
      left = to;
    };
    // A cell is divided where the friction jumps.
    const double right = static_cast<double>(i + 1) * cell - 0.5;
    for (; piece < jumps.size() && mesh().place(jumps[piece]) < right; ++piece) add(mesh().place(jumps[piece]));
    add(right);
  }
  return result;
}

std::vector<Sample<double>> VariationalSolution::samples(int count) const {
  std::vector<Sample<double>> result;
  for (const Rational& x : sampled_places(count)) result.push_back(at(x));
  return result;
}

Estimate<double> VariationalSolution::height(const Rational& x) const {
  const double profile =
      to_real<double>(variational::profile_above_middle(problem_, x)) + variational::harmonic_sum(problem_, x).height;
  const double tilted = height_ * state().tilt * mesh().place(x);
  const double change = height_ * (state().tilt - found_.coarse.found.state.tilt) * mesh().place(x);
  return Estimate<double>{profile + tilted, std::abs(change) + 1e-15 * (std::abs(profile) + std::abs(tilted))} -
         at(x).gap.value_or(Estimate<double>{});
}

Estimate<double> VariationalSolution::rise_beyond(double xi) const {
  const Indenter& indenter = problem_.indenter();
  const double end = mesh().place(xi < 0 ? indenter.left() : indenter.right());
  const double sum = sum_over(runs_, [&](std::size_t i) {
    return state().pressure[i] * kernel().rise(mesh().left(i), mesh().right(i), end, xi, signed_friction(i));
  });
  const double rise = height_ / std::numbers::pi * sum;
  return {rise, std::abs(rise) * estimated_error().traction + 1e-15 * height_};
}

std::vector<double> VariationalSolution::shear_transform(const std::vector<double>& traction) const {
  // The sum over cells j of t_j times the slope at a distance of i - j cells is a convolution.
  const std::size_t n = traction.size();
  const std::size_t size = std::bit_ceil(2 * n);
  const variational::Fourier fourier(size);
  const std::span<double> values = fourier.values();
  std::fill(values.begin(), values.end(), 0.0);
  const variational::SurfaceKernel half_plane;
  for (std::size_t m = 1; m < n; ++m) {
    values[size - m] = half_plane.slope(-0.5, 0.5, -static_cast<double>(m), 0) / std::numbers::pi;
    values[m] = -values[size - m];
  }
  fourier.forward();
  const std::vector<std::complex<double>> kernel(fourier.modes().begin(), fourier.modes().end());
  std::fill(values.begin(), values.end(), 0.0);
  ShearRatios ratios(problem_, mesh());
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = ratios.over(static_cast<double>(i) / static_cast<double>(n) - 0.5,
                            static_cast<double>(i + 1) / static_cast<double>(n) - 0.5) *
                traction[i];
  }
  fourier.forward();
  std::vector<double> result(n);
  fourier.convolve(kernel, result);
  return result;
}

TwoSided<double> VariationalSolution::shear_slope(double xi, const TwoSided<double>& traction) const {
  const auto c = to_real<double>(problem_.elasticity().compliance());
  const auto gamma = to_real<double>(problem_.elasticity().gamma());
  if (xi < mesh().edges().front() || xi > mesh().edges().back()) {
    ShearRatios ratios(problem_, mesh());
    const variational::SurfaceKernel half_plane;
    const double sum = sum_over(runs_, [&](std::size_t i) {
      const double left = mesh().left(i), right = mesh().right(i);
      return ratios.over(left, right) * traction_[i] * half_plane.slope(left, right, xi, 0);
    });
    return slope_beyond(c / std::numbers::pi * sum);
  }
  const auto& [fine, coarse] =
      shear_transforms_([this] { return std::pair(shear_transform(traction_), shear_transform(coarse_traction_)); });
  const double here = interpolated_within(fine, xi);
  const double cell = mesh().length(0);
  const double change = std::max(std::abs(here - interpolated_within(fine, xi - cell)),
                                 std::abs(here - interpolated_within(fine, xi + cell)));
  const Estimate<double> transform{here, std::max(std::abs(here - interpolated_within(coarse, xi)), change / 2)};
  return {c * (transform + gamma * traction.left), c * (transform + gamma * traction.right)};
}

Estimate<double> VariationalSolution::further_shear_slope(double x) const {
  const Body& body = problem_.body();
  if (body.layers().empty()) return {0, infinity<double>()};
  const PiecewiseTraction<double>& traction = surface_traction_([this] { return piecewise_traction(); });
  const LayerField& layers =
      layers_([&] { return LayerField(problem_, gathered_on_meshes(traction, LayerField::longest_part(body))); });
  std::vector<std::size_t> meshes(1 + traction.coarser().size());
  std::iota(meshes.begin(), meshes.end(), 0);
  const auto on_mesh = [&](std::size_t mesh) { return std::array{layers.at(mesh, x, 0)[0]}; };
  const auto [stress] = on_nested_meshes(std::span<const std::size_t>(meshes), on_mesh, traction.mesh_rates().rate);
  return to_real<double>(problem_.elasticity().compliance()) / 2 * stress;
}

DetailedSample<double> VariationalSolution::details_at(const Rational& x) const {
  DetailedSample<double> result{at(x), {}, {}, {}, {}};
  const double xi = mesh().place(x);
  const Indenter& indenter = problem_.indenter();
  const bool beyond = !is_on_support(x);
  const Estimate<double>& origin = height_at_origin_([this] { return height(problem_.origin_of_displacement()); });
  result.displacement = height(!beyond ? x : xi < 0 ? indenter.left() : indenter.right()) - origin;
  if (beyond) result.displacement += rise_beyond(xi);
  if (!beyond) result.friction = {problem_.friction().piece(x, Side::left), problem_.friction().piece(x, Side::right)};
  result.cumulative_load = load_before(xi);
  result.shear_slope = shear_slope(xi, result.traction);
  if (!kernel().is_half_plane()) {
    const Estimate<double> further = further_shear_slope(to_real<double>(x));
    result.shear_slope = {result.shear_slope.left + further, result.shear_slope.right + further};
  }
  return result;
}

std::vector<DetailedSample<double>> VariationalSolution::detailed_samples(int count) const {
  std::vector<DetailedSample<double>> result;
  for (const Rational& x : sampled_places(count)) result.push_back(details_at(x));
  return result;
}

}  // namespace steadyslide::numeric
