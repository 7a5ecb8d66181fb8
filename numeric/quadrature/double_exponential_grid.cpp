#include "numeric/quadrature/double_exponential_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>

namespace steadyslide::numeric::double_exponential {
namespace {

/// Added to the accuracy exponent, for small quantities next to a panel's end.
constexpr double margin = 28;
/// Samples nearer to an end, as a fraction of the panel, do not count for the largest t: a rounding error times a power
/// of the distance has no meaning there. The limit of the traction decides there.
constexpr double outermost_seen = 1e-6;
constexpr double narrowest_strip = 0.2;
constexpr double least_power = 1e-3;  // 1 + lambda

/// h.
double step(int per_octave) { return std::numbers::ln2 / per_octave; }

/// Returns the integer part of 2^shift x. Sums of products of integers cost a third of the same sums of floating-point
/// numbers.
template <Real R>
Integer shifted(const R& x, int shift) {
  Integer result;
  if (x == 0) return result;
  mpz_ptr z = result.backend().data();
  const mpfr_exp_t exponent = mpfr_get_z_2exp(z, x.backend().data()) + shift;
  exponent < 0 ? mpz_tdiv_q_2exp(z, z, static_cast<mp_bitcnt_t>(-exponent))
               : mpz_mul_2exp(z, z, static_cast<mp_bitcnt_t>(exponent));
  return result;
}

template <Real R>
R shifted_back(const Integer& sum, int shift) {
  return ldexp(R(sum), -shift);
}

/// Computes e^-(2 p u) at tau = 0, h, 2h, ...; `rise` is (pi/2) e^tau over one octave. From one octave to the next,
/// e^(-p rise) is squared, and e^(p (pi/2) e^-tau) becomes its square root. So only the nodes of one octave need an
/// exponential.
template <Real R>
std::vector<R> decays(const R& p, const std::vector<R>& rise, std::size_t count) {
  const std::size_t octave = rise.size();
  std::vector<R> falling(std::max(count, octave)), rising(count), result(count);
  for (std::size_t i = 0; i < falling.size(); ++i) {
    falling[i] = i < octave ? R(exp(-p * rise[i])) : R(falling[i - octave] * falling[i - octave]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const R square = i == 0 ? R(falling[0] * falling[0]) : i < octave ? falling[octave - i] : rising[i - octave];
    rising[i] = i < octave ? R(1 / sqrt(square)) : R(sqrt(square));
    result[i] = falling[i] * rising[i];
  }
  return result;
}

/// A node at tau >= 0 of the unit interval.
template <Real R>
struct UnitNode {
  R near;  ///< distances to the right end and to the left one
  R far;
  R log_far;
  R rate;             ///< pi cosh tau
  R both;             ///< near far
  R mirror;           ///< near far rate^2
  double rough_near;  ///< for uses in which double is sufficient

  /// Returns the node from (pi/2) e^tau and e^-2u.
  static UnitNode of(const R& rise, const R& decay) {
    const R far = 1 / (1 + decay);
    const R near = decay * far;
    const R both = near * far;
    const R rate = rise + fall_at(rise);
    return {near, far, log(far), rate, both, both * rate * rate, static_cast<double>(near)};
  }
  /// Returns (pi/2) e^-tau.
  static R fall_at(const R& rise) { return pi<R>() * pi<R>() / (4 * rise); }
};

/// The data on the unit interval of a trapezoidal rule with the nodes tau = 0, h, 2h, ..., which do not depend on the
/// panel. `per_octave` steps double e^tau. The data grow on demand and are shared by all grids.
template <Real R>
class UnitGrid {
 public:
  using Numbers = std::shared_ptr<const std::vector<Integer>>;
  using Nodes = std::shared_ptr<const std::vector<UnitNode<R>>>;

  static UnitGrid& of(int per_octave) {
    static std::mutex mutex;
    static std::map<int, UnitGrid> known;
    const std::lock_guard lock(mutex);
    return known.try_emplace(per_octave, per_octave).first->second;
  }
  static constexpr int bits = std::numeric_limits<R>::digits;
  explicit UnitGrid(int per_octave) {
    for (int i = 0; i < per_octave; ++i) octave_.push_back(rise_at(R(i) / per_octave));
  }

  /// The step h, and (pi/2) e^tau at 0, h, ... below log 2.
  R step() const { return log(R(2)) / octave_.size(); }
  const std::vector<R>& octave() const { return octave_; }
  /// Returns at least `count` nodes at 0, h, 2h, ...
  Nodes nodes(int count) {
    const std::lock_guard lock(mutex_);
    return made_nodes(count);
  }
  /// Returns the distances of the midpoint; `near` is the distance to the nearer end.
  UnitNode<R> midpoint(int cell) {
    const std::lock_guard lock(mutex_);
    return made_midpoint(cell);
  }
  /// Returns 2^`bits`/(y' - y) at least at the nodes -`reach`, ..., `reach`, where y is the midpoint of a cell. There
  /// is the same number of nodes on both sides of the middle.
  Numbers reciprocals(int cell, int reach) {
    const std::lock_guard lock(mutex_);
    Numbers& known = reciprocals_[cell];
    if (known && static_cast<int>(known->size()) > 2 * reach) return known;
    const Nodes nodes = made_nodes(reach + 1);
    const UnitNode<R>& place = made_midpoint(cell);
    const bool right = cell >= 0;
    std::vector<Integer> made;
    for (int i = -reach; i <= reach; ++i) {
      const UnitNode<R>& node = (*nodes)[static_cast<std::size_t>(std::abs(i))];
      // Measure from the end nearer to y, because distances to it are the most accurate.
      const R& distance = (i > 0) == right ? node.near : node.far;
      made.push_back(shifted(R(1 / (right ? R(place.near - distance) : R(distance - place.near))), bits));
    }
    known = std::make_shared<const std::vector<Integer>>(std::move(made));
    return known;
  }

 private:
  static R rise_at(const R& octaves) { return pi<R>() / 2 * exp(R(octaves * log(R(2)))); }

  Nodes made_nodes(int count) {
    if (!nodes_ || static_cast<int>(nodes_->size()) < count) {
      std::vector<UnitNode<R>> made;
      const auto size = static_cast<std::size_t>(count);
      const std::vector<R> decay = decays(R(1), octave_, size);
      for (std::size_t i = 0; i < size; ++i) {
        const R rise = ldexp(octave_[i % octave_.size()], static_cast<int>(i / octave_.size()));
        made.push_back(UnitNode<R>::of(rise, decay[i]));
      }
      nodes_ = std::make_shared<const std::vector<UnitNode<R>>>(std::move(made));
    }
    return nodes_;
  }

  const UnitNode<R>& made_midpoint(int cell) {
    const auto known = midpoints_.find(cell);
    if (known != midpoints_.end()) return known->second;
    const R rise = rise_at(R(std::abs(2 * cell + 1)) / (2 * octave_.size()));
    const R decay = exp(R(UnitNode<R>::fall_at(rise) - rise));
    return midpoints_.emplace(cell, UnitNode<R>::of(rise, decay)).first->second;
  }

  std::vector<R> octave_;
  std::mutex mutex_;
  Nodes nodes_;
  std::map<int, UnitNode<R>> midpoints_;
  std::map<int, Numbers> reciprocals_;
};

/// The accuracy exponent of the returned digits and four more.
template <Real R>
double accuracy() {
  return (digits_served<R> + 4) * std::numbers::ln10;
}

/// Returns b of the pole at the nearest admissible place.
double strip_of_places() {
  const double s = std::log(nearest_place / (1 - nearest_place)) / std::numbers::pi;
  const double sum = 5 + s * s;
  return std::asin(2 / std::sqrt((sum + std::sqrt(sum * sum - 16)) / 2));
}

/// Returns b of a real point beyond an end.
double strip(double distance) {
  const double a = std::log1p(1 / distance) / std::numbers::pi;
  return std::asin(2 / (a + std::sqrt(a * a + 4)));
}

/// Returns the distance from a panel to the nearest singular point or pole beyond it on that side, divided by the
/// panel's length.
template <Real R>
double clearance(const PiecewiseDensity<R>& density, std::size_t k, Side side) {
  const bool left = side == Side::left;
  if (left ? k == 0 : k + 1 == density.size()) return HUGE_VAL;
  const PanelDensity<R>& neighbour = density[left ? k - 1 : k + 1];
  const R& gap = left ? density[k].gap : neighbour.gap;
  // A midpoint lies up to one step before the requested place.
  const R distance = gap > 0 ? gap : R(neighbour.panel.length * R(0.75 * nearest_beside_a_panel));
  return static_cast<double>(R(distance / density[k].panel.length));
}

template <Real R>
double strip_of(const PiecewiseDensity<R>& density, std::size_t k) {
  return std::min(strip_of_places(),
                  strip(std::min(clearance(density, k, Side::left), clearance(density, k, Side::right))));
}

template <Real R>
int nodes_per_octave(const PiecewiseDensity<R>& density, std::size_t k) {
  const double longest = 2 * std::numbers::pi * 0.955 * strip_of(density, k) / accuracy<R>();
  return static_cast<int>(std::ceil(std::numbers::ln2 / longest));
}

/// The range of the nodes in tau.
template <Real R>
double reach(const Power<R>& power) {
  return std::asinh((accuracy<R>() + margin) / (std::numbers::pi * static_cast<double>(power.plus_one)));
}

template <Real R>
Node<R> node_at(const Panel<R>& panel, const R& from_left, const R& from_right) {
  return {from_left < from_right ? R(panel.left + from_left) : R(panel.right - from_right), from_left, from_right};
}

template <Real R>
R power_of(const R& base, const R& exponent) {
  return exponent == 1 ? base : pow(base, exponent);
}

/// Computes y^a (1-y)^b pi cosh tau at the nodes first..last, a, b > 0, as y^(a+b) e^-2bu on the right and (1-y)^(a+b)
/// e^2au on the left, so that the base is the larger of y and 1-y. If a + b is an integer, the values at two mirrored
/// nodes have the product (y (1-y))^(a+b) (pi cosh tau)^2.
template <Real R>
std::vector<R> end_weights(UnitGrid<R>& grid, const R& a, const R& b, int first, int last) {
  const R sum = a + b;
  const int whole = static_cast<int>(std::lround(static_cast<double>(sum)));
  const bool mirrored = whole > 0 && abs(R(sum - whole)) <= 8 * epsilon<R>();
  const auto nodes = grid.nodes(std::max(-first, last) + 1);
  std::vector<R> result(static_cast<std::size_t>(last - first + 1));
  const auto at = [&](int i) -> R& { return result[static_cast<std::size_t>(i - first)]; };
  const auto fill = [&](int direction, int count, const R& p) {
    const std::vector<R> decay = decays(p, grid.octave(), static_cast<std::size_t>(count + 1));
    for (int i = 0; i <= count; ++i) {
      const UnitNode<R>& node = (*nodes)[static_cast<std::size_t>(i)];
      R& weight = at(direction * i);
      weight = decay[static_cast<std::size_t>(i)] * node.rate;
      if (!mirrored) weight *= exp(R(sum * node.log_far));
      for (int k = 0; mirrored && k < whole; ++k) weight *= node.far;
    }
  };
  // The lower power needs the longer range.
  const int longer = a < b ? -1 : 1;
  fill(longer, a < b ? -first : last, std::min(a, b));
  if (!mirrored) {
    fill(-longer, a < b ? last : -first, std::max(a, b));
    return result;
  }
  for (int i = a < b ? last : -first; i > 0; --i) {
    const UnitNode<R>& node = (*nodes)[static_cast<std::size_t>(i)];
    R& weight = at(-longer * i);
    weight = node.mirror;
    for (int k = 1; k < whole; ++k) weight *= node.both;
    weight /= at(longer * i);
  }
  return result;
}

}  // namespace

template <Real R>
bool Grid<R>::suits(const PiecewiseDensity<R>& density) {
  for (std::size_t k = 0; k < density.size(); ++k) {
    const bool fine = strip_of(density, k) > narrowest_strip && density[k].left.plus_one > least_power &&
                      density[k].right.plus_one > least_power;
    if (!fine) return false;
  }
  return !density.empty();
}

template <Real R>
Grid<R>::Grid(PiecewiseDensity<R> density) : density_(std::move(density)) {
  panels_.reserve(density_.size());
  for (std::size_t k = 0; k < density_.size(); ++k) {
    panels_.push_back(sampled(density_[k], nodes_per_octave(density_, k), density_.size() == 1));
  }
}

template <Real R>
typename Grid<R>::PanelSamples Grid<R>::sampled(const PanelDensity<R>& density, int per_octave, bool alone) {
  const Panel<R>& panel = density.panel;
  const auto count = [&](const Power<R>& power) { return static_cast<int>(reach(power) / step(per_octave)) + 1; };
  const int first = -count(density.left);
  const int last = count(density.right);
  UnitGrid<R>& grid = UnitGrid<R>::of(per_octave);
  const auto nodes = grid.nodes(std::max(-first, last) + 1);
  const R h = grid.step();
  const R& a = density.left.plus_one;
  const R& b = density.right.plus_one;
  PanelSamples result{per_octave, first, R(0), end_weights(grid, a, b, first, last), 0, {}, {}, {}, {}, -infinity<R>()};
  const R middle = panel.length / 2;
  const R constant = density.is_constant ? density.smooth(panel.node_from_left(middle)) : R(1);
  // dx = length pi cosh(tau) y (1-y) dtau
  result.factor = h * power_of(panel.length, R(a + b - 1)) * constant;
  const auto factor = static_cast<double>(result.factor);
  const auto length = static_cast<double>(panel.length);
  const bool positive = result.factor > 0;
  double size = 0;
  result.rough.reserve(result.weighted.size());
  for (int i = first; i <= last; ++i) {
    const UnitNode<R>& unit = (*nodes)[static_cast<std::size_t>(std::abs(i))];
    const R& y = i > 0 ? unit.far : unit.near;
    const R& rest = i > 0 ? unit.near : unit.far;
    R& weighted = result.weighted[static_cast<std::size_t>(i - first)];
    if (!alone || !density.is_constant) {
      const Node<R> node = node_at(panel, R(panel.length * y), R(panel.length * rest));
      if (!density.is_constant) weighted *= density.smooth(node);
      if (!alone) result.nodes.push_back({node.from_left, node.from_right});
    }
    const double near = length * unit.rough_near;
    const double far = length * (1 - unit.rough_near);
    const double rough = factor * static_cast<double>(weighted);
    result.rough.push_back({i > 0 ? far : near, i > 0 ? near : far, rough});
    size += std::abs(rough);
    if (unit.rough_near < outermost_seen) continue;
    // Only the sign matters; if it is wrong, the size matters too.
    R t = rough;
    if ((weighted > 0) == positive) t = result.factor * weighted / (h * panel.length * unit.rate * y * rest);
    result.highest = std::max(result.highest, t);
  }
  const auto is_smaller = [](const R& v, const R& w) {
    return mpfr_cmpabs(v.backend().data(), w.backend().data()) < 0;
  };
  int exponent = 0;
  frexp(*std::max_element(result.weighted.begin(), result.weighted.end(), is_smaller), &exponent);
  result.shift = UnitGrid<R>::bits - exponent;
  result.integers.reserve(result.weighted.size());
  Integer sum = 0;
  for (const R& weighted : result.weighted) sum += result.integers.emplace_back(shifted(weighted, result.shift));
  result.integral = {result.factor * shifted_back<R>(sum, result.shift), 16 * epsilon<R>() * size};
  return result;
}

template <Real R>
bool Grid<R>::touches(std::size_t k, Side side) const {
  return side == Side::left ? k > 0 && density_[k].gap == 0 : k + 1 < density_.size() && density_[k + 1].gap == 0;
}

template <Real R>
R Grid<R>::integral() const {
  R total = 0;
  for (std::size_t k = 0; k < panels_.size(); ++k) total += panel_integral(k).value;
  return total;
}

template <Real R>
R Grid<R>::highest() const {
  R highest = -infinity<R>();
  for (const PanelSamples& panel : panels_) highest = std::max(highest, panel.highest);
  return highest;
}

template <Real R>
typename Grid<R>::Midpoint Grid<R>::midpoint_near(std::size_t k, double fraction) const {
  const double tau = std::asinh(std::log(fraction / (1 - fraction)) / std::numbers::pi);
  const int per_octave = panels_[k].per_octave;
  const auto cell = static_cast<int>(std::floor(tau / step(per_octave)));
  const UnitNode<R> unit = UnitGrid<R>::of(per_octave).midpoint(cell);
  const Panel<R>& panel = density_[k].panel;
  const R near = panel.length * unit.near;
  const R far = panel.length * unit.far;
  return {{k, cell >= 0 ? node_at(panel, far, near) : node_at(panel, near, far)}, cell};
}

template <Real R>
R Grid<R>::hilbert(const Midpoint& midpoint) const {
  const Node<R>& x = midpoint.node;
  const PanelSamples& own = panels_[midpoint.panel];
  const int last = own.first + static_cast<int>(own.weighted.size()) - 1;
  const auto reciprocals = UnitGrid<R>::of(own.per_octave).reciprocals(midpoint.cell, std::max(-own.first, last));
  auto reciprocal = reciprocals->begin() + static_cast<std::ptrdiff_t>(reciprocals->size() / 2) + own.first;
  Integer products = 0;
  for (const Integer& weighted : own.integers) {
    mpz_addmul(products.backend().data(), weighted.backend().data(), (reciprocal++)->backend().data());
  }
  R total =
      shifted_back<R>(products, own.shift + UnitGrid<R>::bits) * own.factor / density_[midpoint.panel].panel.length;
  for (std::size_t j = 0; j < panels_.size(); ++j) {
    if (j == midpoint.panel) continue;
    const PanelSamples& other = panels_[j];
    const bool to_the_right = j > midpoint.panel;
    const R from_x = (to_the_right ? x.from_right : x.from_left) + distance_between(density_, j, midpoint.panel);
    R sum = 0;
    for (std::size_t i = 0; i < other.nodes.size(); ++i) {
      const Distances& node = other.nodes[i];
      sum += other.weighted[i] / (from_x + (to_the_right ? node.from_left : node.from_right));
    }
    sum *= other.factor;
    total += to_the_right ? sum : R(-sum);
  }
  return total / pi<R>();
}

template <Real R>
Estimate<double> Grid<R>::rough_displacement(std::size_t k, Side end, double distance) const {
  double sum = 0;
  double size = 0;
  double lost = 0;
  const bool beyond_right = end == Side::right;
  const auto own_length = static_cast<double>(density_[k].panel.length);
  for (std::size_t j = 0; j < panels_.size(); ++j) {
    const double apart = j == k ? 0 : static_cast<double>(distance_between(density_, j, k));
    const bool same_side = j == k || (j < k) == beyond_right;
    double part = 0;
    for (const RoughSample& s : panels_[j].rough) {
      const double facing = beyond_right == same_side ? s.from_right : s.from_left;
      const double to_end = facing + apart + (same_side && j != k ? own_length : 0);
      // Nodes so close to the end that double cannot resolve the distance carry no load.
      if (to_end < 1e-300) continue;
      const double term = s.weighted * std::log1p(same_side ? distance / to_end : -distance / to_end);
      sum += term;
      part += std::abs(term);
    }
    size += part;
    // The point itself is a logarithmic singular point beyond the panel.
    const auto length = static_cast<double>(density_[j].panel.length);
    const double clear = same_side ? distance + apart + (j == k ? 0 : own_length) : apart - distance;
    const double h = step(panels_[j].per_octave);
    lost += part * (clear > 0 ? std::exp(-2 * std::numbers::pi * strip(clear / length) / h) : 1);
  }
  return {-sum / std::numbers::pi, 10 * lost + 1e-13 * size};
}

template class Grid<Real50>;
template class Grid<Real100>;

}  // namespace steadyslide::numeric::double_exponential
