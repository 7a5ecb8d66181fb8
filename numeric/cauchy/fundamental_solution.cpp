#include "numeric/cauchy/fundamental_solution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/hierarchical/line_sum.hpp"
#include "numeric/number/mapped.hpp"
#include "numeric/number/power_product.hpp"

namespace steadyslide::numeric {
namespace {

/// Calls visit(j, |e_j - e|) for all j < count on the left, given the distance from e to e_{count-1}; the same on the
/// right. Distances are sums of lengths. All terms are positive, so nothing cancels.
template <Real R, class Visit>
void visit_leftwards(const std::vector<Panel<R>>& panels, std::size_t count, R distance, Visit&& visit) {
  for (std::size_t j = count; j-- > 0;) {
    visit(j, distance);
    if (j > 0) distance += panels[j - 1].length;
  }
}

template <Real R, class Visit>
void visit_rightwards(const std::vector<Panel<R>>& panels, std::size_t first, R distance, Visit&& visit) {
  for (std::size_t j = first; j <= panels.size(); ++j) {
    visit(j, distance);
    if (j < panels.size()) distance += panels[j].length;
  }
}

template <Real R>
std::vector<Panel<R>> panels_from(R left, std::vector<R> lengths) {
  std::vector<Panel<R>> panels;
  panels.reserve(lengths.size());
  for (R& length : lengths) {
    R right = left + length;
    panels.push_back({std::move(left), right, std::move(length)});
    left = std::move(right);
  }
  return panels;
}

hierarchical::LineSum sum_of(const std::vector<double>& lengths, const std::vector<Power<double>>& powers) {
  std::vector<hierarchical::Source> sources;
  std::vector<double> weights;
  const auto add = [&](std::size_t panel, double from_left, double from_right, double power) {
    if (power == 0) return;
    sources.push_back({panel, from_left, from_right});
    weights.push_back(power);
  };
  for (std::size_t k = 0; k < lengths.size(); ++k) add(k, 0, lengths[k], powers[k].value);
  add(lengths.size() - 1, lengths.back(), 0, powers.back().value);
  return {{hierarchical::LineSum::Kernel::logarithm}, lengths, sources, {weights}};
}

}  // namespace

// prod d_j^{p_j} over distances d_j >= 0, one factor at a time: in double by powers, in higher precision by one
// exponential of a sum of logarithms.

/// The number of bits of R, and the number of bits for the digits that are returned with R, with ten bits to spare.
template <Real R>
inline constexpr int all_bits = std::numeric_limits<R>::digits;
template <Real R>
inline constexpr int served_bits = static_cast<int>(digits_served<R> / (std::numbers::ln2 / std::numbers::ln10)) + 11;

template <>
class DistanceProduct<double> {
 public:
  explicit DistanceProduct(int /*bits*/) {}
  void multiply(double distance, const Power<double>& power) { value_ *= std::pow(distance, power.value); }
  void set_one() { value_ = 1; }
  double value() const { return value_; }

 private:
  double value_ = 1;
};

#ifndef STEADYSLIDE_DOUBLE_ONLY
template <Real R>
class DistanceProduct {
 public:
  /// `bits` is the working precision (elementary.hpp).
  explicit DistanceProduct(int bits) : product_(bits) {}
  void multiply(const R& distance, const Power<R>& power) {
    product_.multiply(distance.backend().data(), power.value.backend().data());
  }
  void set_one() { product_.set_one(); }
  R value() const {
    R result;
    product_.value(result.backend().data());
    return result;
  }

 private:
  elementary::PowerProduct product_;
};
#endif

// The logarithm of prod_j |x - e_j|^{p_j} over the points e_j that are far from x, by cells (numeric/hierarchical/),
// for the fundamental solution of many points in double. The caller adds the points near x.

class DistantPowers {
 public:
  /// Takes adjacent panels, and one more power than panels.
  DistantPowers(const std::vector<Panel<double>>& panels, const std::vector<Power<double>>& powers)
      : lengths_(mapped(panels, [](const Panel<double>& panel) { return panel.length; })),
        sum_(sum_of(lengths_, powers)) {
    for (const Power<double>& power : powers) size_ += std::abs(power.value);
    for (const double length : lengths_) hull_ += length;
  }

  /// Returns the sum over the far points at a place of panel k (or at its ends) and calls visit(j, |e_j - x|) for the
  /// others.
  template <class Visit>
  double around(std::size_t k, double from_left, double from_right, const Visit& visit) const {
    visit_panel(k, from_left, from_right, visit);
    for (const auto& [panel, between] : sum_.near_to(k)) {
      const double length = lengths_[panel];
      if (panel < k) {
        visit_panel(panel, from_left + between + length, from_left + between, visit);
      } else {
        visit_panel(panel, from_right + between, from_right + between + length, visit);
      }
    }
    return sum_.far(0, k, from_left, from_right);
  }

  /// The same at a distance beyond the first or the last point, which is one of the visited points.
  template <class Visit>
  double beyond(Side side, double distance, const Visit& visit) const {
    double sum = 0;
    const hierarchical::PanelTree& tree = sum_.tree();
    const auto takes = [&](std::size_t cell, Side sources, double from_here) {
      const hierarchical::PanelTree::Cell& c = tree.cells()[cell];
      const bool has_end = side == Side::left ? c.first == 0 : c.end == lengths_.size();
      if (has_end || c.is_leaf() || !tree.is_far(cell, from_here)) return false;
      sum += sum_.of_cell(0, cell, sources, from_here);
      return true;
    };
    tree.beyond(side, distance, takes, [&](std::size_t panel, double gap, Side sources) {
      const double other = gap + lengths_[panel];
      visit_panel(panel, sources == Side::right ? gap : other, sources == Side::right ? other : gap, visit);
    });
    return sum;
  }

  /// Returns an estimate of the sum's rounding error on panel k, divided by epsilon.
  double rounding(std::size_t k) const {
    // The distance of a far point is at least the length of the panel.
    const double longest = std::max({1.0, std::abs(std::log(lengths_[k])), std::abs(std::log(hull_))});
    return hierarchical::logarithm_rounding * size_ * longest;
  }

 private:
  /// Calls visit() for the points of panel k: its left end; for the last panel, also its right end.
  template <class Visit>
  void visit_panel(std::size_t k, double from_left, double from_right, const Visit& visit) const {
    visit(k, from_left);
    if (k + 1 == lengths_.size()) visit(k + 1, from_right);
  }

  std::vector<double> lengths_;
  double size_ = 0;  ///< sum |p_j|
  double hull_ = 0;
  hierarchical::LineSum sum_;
};

template <Real R>
FundamentalSolution<R>::FundamentalSolution(const R& left_end, std::vector<R> lengths, std::vector<Power<R>> powers)
    : FundamentalSolution(panels_from(left_end, std::move(lengths)), std::move(powers)) {}

template <Real R>
FundamentalSolution<R>::FundamentalSolution(std::vector<Panel<R>> panels, std::vector<Power<R>> powers)
    : panels_(std::move(panels)), powers_(std::move(powers)) {
  if (std::same_as<R, double> && panels_.size() >= hierarchical::fewest_panels) {
    distant_ = std::make_shared<const Once<DistantPowers>>();
  }
}

template <Real R>
const DistantPowers* FundamentalSolution<R>::distant() const {
  if constexpr (std::same_as<R, double>) {
    if (distant_) return &(*distant_)([this] { return DistantPowers(panels_, powers_); });
  }
  return nullptr;
}

template <Real R>
template <class Skips>
R FundamentalSolution<R>::product(std::size_t k, const R& from_left, const R& from_right, const Skips& skips,
                                  DistanceProduct<R>& product) const {
  const auto visit = [&](std::size_t j, const R& distance) {
    if (powers_[j].value != 0 && !skips(j)) product.multiply(distance, powers_[j]);
  };
  product.set_one();
  if constexpr (std::same_as<R, double>) {
    if (const DistantPowers* powers = distant()) {
      const double far = powers->around(k, from_left, from_right, visit);
      return product.value() * std::exp(far);
    }
  }
  visit_leftwards(panels_, k + 1, from_left, visit);
  visit_rightwards(panels_, k + 1, from_right, visit);
  return product.value();
}

template <Real R>
template <class Skips>
R FundamentalSolution<R>::product(std::size_t k, const R& from_left, const R& from_right, const Skips& skips) const {
  DistanceProduct<R> scratch(all_bits<R>);
  return product(k, from_left, from_right, skips, scratch);
}

template <Real R>
void FundamentalSolution<R>::moduli(std::size_t k, std::span<const R> from_left, std::span<const R> from_right,
                                    std::span<R> values) const {
  const auto one_by_one = [&](const auto& is_due) {
    const auto none = [](std::size_t) { return false; };
    DistanceProduct<R> scratch(served_bits<R>);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (is_due(i)) values[i] = product(k, from_left[i], from_right[i], none, scratch);
    }
  };
  if constexpr (std::same_as<R, double>) {
    // For more panels than this, products by cells are faster.
    constexpr std::size_t most_panels = 512;
    if (panels_.size() > most_panels) return one_by_one([](std::size_t) { return true; });
    std::vector<PowerFactor> of_left, of_right;
    double sum = 0;
    const auto gather = [&](std::vector<PowerFactor>& factors) {
      return [&](std::size_t j, double offset) {
        const double power = powers_[j].value;
        if (power != 0) factors.emplace_back(offset, power);
        sum += std::abs(power);
      };
    };
    visit_leftwards(panels_, k + 1, 0.0, gather(of_left));
    visit_rightwards(panels_, k + 1, 0.0, gather(of_right));
    if (sum <= largest_sum_of_powers) {
      power_products(of_left, of_right, from_left, from_right, values);
      constexpr double least = std::numeric_limits<double>::min();
      return one_by_one([&](std::size_t i) { return !(from_left[i] >= least && from_right[i] >= least); });
    }
  }
  one_by_one([](std::size_t) { return true; });
}

template <Real R>
template <class Skips>
R FundamentalSolution<R>::product_beyond(Side side, const R& distance, const Skips& skips) const {
  DistanceProduct<R> product(all_bits<R>);
  const auto visit = [&](std::size_t j, const R& d) {
    if (powers_[j].value != 0 && !skips(j)) product.multiply(d, powers_[j]);
  };
  if constexpr (std::same_as<R, double>) {
    if (const DistantPowers* powers = distant()) {
      const double far = powers->beyond(side, distance, visit);
      return product.value() * std::exp(far);
    }
  }
  if (side == Side::left) {
    visit_rightwards(panels_, 0, distance, visit);
  } else {
    visit_leftwards(panels_, panels_.size() + 1, distance, visit);
  }
  return product.value();
}

template <Real R>
R FundamentalSolution<R>::modulus(std::size_t k, const Node<R>& node) const {
  return product(k, node.from_left, node.from_right, [](std::size_t) { return false; });
}

template <Real R>
R FundamentalSolution<R>::smooth_modulus(std::size_t k, const Node<R>& node) const {
  return product(k, node.from_left, node.from_right, [k](std::size_t j) { return j == k || j == k + 1; });
}

template <Real R>
R FundamentalSolution<R>::modulus_beyond(Side side, const R& distance) const {
  const Power<R>& end = side == Side::left ? powers_.front() : powers_.back();
  return pow(distance, end.value) * smooth_modulus_beyond(side, distance);
}

template <Real R>
R FundamentalSolution<R>::smooth_modulus_beyond(Side side, const R& distance) const {
  const std::size_t end = side == Side::left ? 0 : panels_.size();
  return product_beyond(side, distance, [end](std::size_t j) { return j == end; });
}

template <Real R>
R FundamentalSolution<R>::amplitude(std::size_t j) const {
  const std::size_t k = std::min(j, panels_.size() - 1);
  const R& length = panels_[k].length;
  return product(k, j == k ? R(0) : length, j == k ? length : R(0), [j](std::size_t i) { return i == j; });
}

template <Real R>
R FundamentalSolution<R>::phase(std::size_t k) const {
  R sum = 0;
  for (std::size_t j = powers_.size(); j-- > k + 1;) sum += powers_[j].value;
  return sum;
}

template <Real R>
Complex<R> FundamentalSolution<R>::boundary(std::size_t k, const Node<R>& node, BoundaryLimit limit) const {
  const R size = modulus(k, node);
  const R angle = pi<R>() * phase(k) * (limit == BoundaryLimit::plus ? 1 : -1);
  return {size * cos(angle), size * sin(angle)};
}

template <Real R>
Complex<R> FundamentalSolution<R>::at(const Complex<R>& z) const {
  R log_modulus = 0;
  R argument = 0;
  for (std::size_t j = 0; j < powers_.size(); ++j) {
    const R re = z.re - point(j);
    log_modulus += powers_[j].value * log(re * re + z.im * z.im) / 2;
    argument += powers_[j].value * atan2(z.im, re);
  }
  const R size = exp(log_modulus);
  return {size * cos(argument), size * sin(argument)};
}

template <Real R>
R FundamentalSolution<R>::relative_error(std::size_t k, const Node<R>& node, const R& end_error) const {
  R rounding = 2;
  R ends = 0;
  const auto add = [&](std::size_t j, const R& d) {
    const R& p = powers_[j].value;
    if (p != 0) rounding += 2 + abs(p) * (2 + abs(log(d)));
  };
  const auto add_end = [&](std::size_t j, const R& d) {
    if (powers_[j].value != 0) ends += abs(powers_[j].value) * end_error / d;
  };
  const std::size_t last = panels_.size();
  if constexpr (std::same_as<R, double>) {
    if (const DistantPowers* powers = distant()) {
      powers->around(k, node.from_left, node.from_right, add);
      rounding += powers->rounding(k);
      add_end(0, std::max(node.from_left, node.x - point(0)));
      add_end(last, std::max(node.from_right, point(last) - node.x));
      return epsilon<R>() * rounding + ends;
    }
  }
  const auto add_both = [&](std::size_t j, const R& d) {
    add(j, d);
    if (j == 0 || j == last) add_end(j, d);
  };
  visit_leftwards(panels_, k + 1, node.from_left, add_both);
  visit_rightwards(panels_, k + 1, node.from_right, add_both);
  return epsilon<R>() * rounding + ends;
}

STEADYSLIDE_INSTANTIATE_CLASS(FundamentalSolution)

}  // namespace steadyslide::numeric
