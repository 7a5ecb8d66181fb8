#include "numeric/cauchy/fundamental_solution.hpp"

#include <mutex>
#include <optional>

#include "numeric/cauchy/distance_product.hpp"
#include "numeric/cauchy/distant_powers.hpp"
#include "numeric/number/power_product.hpp"

namespace steadyslide::numeric {

namespace {

/// Calls visit(j, |e_j - e|) for all j < count to the left, given the distance from e to e_{count-1}, and likewise to
/// the right. Distances grow by adding lengths: sums of positive numbers lose nothing.
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

}  // namespace

template <Real R>
struct FundamentalSolution<R>::LazyDistantPowers {
  std::once_flag made;
  std::optional<DistantPowers> powers;
};

template <Real R>
FundamentalSolution<R>::FundamentalSolution(const R& left_end, std::vector<R> lengths, std::vector<Power<R>> powers)
    : FundamentalSolution(panels_from(left_end, std::move(lengths)), std::move(powers)) {}

template <Real R>
FundamentalSolution<R>::FundamentalSolution(std::vector<Panel<R>> panels, std::vector<Power<R>> powers)
    : panels_(std::move(panels)), powers_(std::move(powers)) {
  if (std::same_as<R, double> && panels_.size() >= hierarchical::fewest_panels) {
    distant_ = std::make_shared<LazyDistantPowers>();
  }
}

template <Real R>
const DistantPowers* FundamentalSolution<R>::distant() const {
  if constexpr (std::same_as<R, double>) {
    if (!distant_) return nullptr;
    std::call_once(distant_->made, [this] { distant_->powers.emplace(panels_, powers_); });
    return &*distant_->powers;
  } else {
    return nullptr;
  }
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
    // Products over more panels than this cost less by cells.
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
  using std::pow;
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
  using std::cos, std::sin;
  const R size = modulus(k, node);
  const R angle = pi<R>() * phase(k) * (limit == BoundaryLimit::plus ? 1 : -1);
  return {size * cos(angle), size * sin(angle)};
}

template <Real R>
Complex<R> FundamentalSolution<R>::at(const Complex<R>& z) const {
  using std::atan2, std::cos, std::exp, std::log, std::sin;
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
  using std::abs, std::log;
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

#define STEADYSLIDE_INSTANTIATE(R) template class FundamentalSolution<R>;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
