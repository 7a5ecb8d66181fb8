#include "enclosure/contact/panel_moments.hpp"

#include <algorithm>
#include <cmath>

#include "enclosure/number/ball_polynomial.hpp"

namespace steadyslide::enclosure {
namespace {

/// Returns the smallest number of terms with ratio^terms <= 4^-most; ratio <= 1/4.
std::size_t terms_of(const Ball& ratio, std::size_t most) {
  const double rate = -rough_log2(ratio.upper());
  const Ball cut = power(Ball(2, 64), -2 * static_cast<int>(most));
  auto terms = static_cast<std::size_t>(std::ceil(2 * static_cast<double>(most) / rate));
  while (terms < most && !(power(ratio, static_cast<int>(terms)) <= cut)) ++terms;
  return std::min(terms, most);
}

}  // namespace

PanelMoments::PanelMoments(const std::vector<ContactPanel>& panels, const std::vector<std::vector<Ball>>& values,
                           const std::vector<Ball>& sizes, Side c, const std::optional<DistanceRange>& distances,
                           Bits bits)
    : bits_(bits) {
  if (distances) distances_ = {distances->least.at(64).lower(), distances->most.at(64).upper()};
  const std::size_t count = panels.size();
  const std::size_t terms = static_cast<std::size_t>(bits) / 2 + 4;
  const bool left = c == Side::left;
  const auto at = [&](std::size_t n) { return left ? n : count - 1 - n; };
  for (std::size_t n = 0; n < count; ++n) {
    const ContactPanel::Interval& part = panels[at(n)].part();
    const Ball& start = left ? part.from_left : part.from_right;
    starts_.push_back(start.at(64));
    ends_.push_back((start + part.length).at(64));
  }
  least_near_ = distances_ ? count_of_near(distances_->least) : 0;
  least_far_ = distances_ ? first_far(distances_->least) : 1;
  const std::size_t most_near = distances_ ? count_of_near(distances_->most) : count;
  const std::size_t most_far = distances_ ? first_far(distances_->most) : count;

  const auto rule_error = [&](std::size_t n) { return panels[at(n)].remainder(sizes[at(n)], Ellipse::far); };
  const auto points_of = [&](std::size_t n) {
    std::vector<Ball> points;
    for (const ContactPanel::Node& node : panels[at(n)].nodes())
      points.push_back(left ? node.from_left : node.from_right);
    return points;
  };
  const auto add = [](Sums& sums, const std::vector<Ball>& weights, const std::vector<Ball>& points,
                      std::size_t first) {
    for (const Ball& weight : weights) sums.size += abs(weight).upper().at(64);
    add_moments(std::span(sums.moments).first(first), weights, points);
  };
  const Bits precision = values.empty() || values[0].empty() ? bits : values[0][0].bits();
  const Sums nothing{std::vector<Ball>(terms, Ball(0, precision)), Ball(0, 64), Ball(0, 64)};
  near_ = {nothing};
  for (std::size_t n = 0; n < most_near; ++n) {
    if (n >= least_near_) near_.push_back(near_.back());
    Sums& sums = near_.back();
    add(sums, values[at(n)], points_of(n), n < least_near_ ? terms_of(ends_[n] / distances_->least, terms) : terms);
    sums.remainder += rule_error(n);
  }
  far_.assign(most_far - least_far_ + 1, nothing);
  for (std::size_t n = count; n-- > least_far_;) {
    if (n < most_far) far_[n - least_far_] = far_[n - least_far_ + 1];
    Sums& sums = far_[std::min(n, most_far) - least_far_];
    std::vector<Ball> weights, inverses;
    for (const Ball& y : points_of(n)) inverses.push_back(Ball(1) / y);
    for (std::size_t k = 0; k < inverses.size(); ++k) weights.push_back(values[at(n)][k] * inverses[k]);
    add(sums, weights, inverses, n < most_far ? terms : terms_of(distances_->most / starts_[n], terms));
    sums.remainder += rule_error(n) * pole_bound((starts_[n] - panels[at(n)].reach(Ellipse::far)).at(64));
  }
}

bool PanelMoments::cover(const DistanceRange& distances) const {
  return !distances_ || (distances_->least <= distances.least && distances.most <= distances_->most);
}

std::size_t PanelMoments::count_of_near(const Ball& distance) const {
  const Ball least = distance.at(64) / Ball(4);
  const auto is_near = [&](const Ball& end) { return end <= least; };
  return static_cast<std::size_t>(std::partition_point(ends_.begin(), ends_.end(), is_near) - ends_.begin());
}

std::size_t PanelMoments::first_far(const Ball& distance) const {
  const Ball most = distance.at(64) * Ball(4);
  const auto is_not_far = [&](const Ball& start) { return !(start >= most); };
  return static_cast<std::size_t>(std::partition_point(starts_.begin() + 1, starts_.end(), is_not_far) -
                                  starts_.begin());
}

PanelMoments::Rest PanelMoments::seen_from(const Ball& distance) const {
  const std::size_t count = starts_.size();
  Rest rest{Ball(0, bits_), 0, count};
  const Ball cut = power(Ball(2, 64), -2 * static_cast<int>(near_[0].moments.size()));
  const std::size_t near = count_of_near(distance);
  if (near > 0 && near >= least_near_ && (!distances_ || distance >= distances_->least)) {
    const std::size_t i = std::min(near - least_near_, near_.size() - 1);
    rest.first = least_near_ + i;
    const Ball inverse = Ball(-1) / distance;
    Ball sum = value_at(near_[i].moments, inverse);
    // -sum/D * (-1): 1/(D + y) = -(sum_k y^k (-1/D)^k) (-1/D).
    sum *= -inverse;
    rest.sum += Ball::plus_or_minus(
        sum, (near_[i].size * cut + near_[i].remainder * Ball(5) / Ball(4)) * pole_bound(distance.at(64)));
  }
  const std::size_t far = std::max({first_far(distance), rest.first, least_far_});
  if (far < count && far - least_far_ < far_.size() && (!distances_ || distance <= distances_->most)) {
    rest.last = far;
    const Sums& beyond = far_[far - least_far_];
    const Ball sum = value_at(beyond.moments, -distance);
    rest.sum += Ball::plus_or_minus(sum, beyond.size * cut + beyond.remainder);
  }
  return rest;
}

}  // namespace steadyslide::enclosure
