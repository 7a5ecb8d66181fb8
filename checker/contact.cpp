#include "checker/contact.hpp"

#include <algorithm>

#include "checker/failure.hpp"

namespace steadyslide::checker {

using Kind = LayoutPoint::Contact;

Contact::Contact(const ReducedProblem& problem, const Layout& layout, const std::vector<Ball>& log_offsets,
                 slong precision)
    : problem_(&problem), layout_(&layout), precision_(precision), degree_(layout.degree_at_infinity()) {
  place_points(log_offsets);
  find_powers();
  expand();
}

void Contact::place_points(const std::vector<Ball>& log_offsets) {
  std::size_t free = 0;
  for (const LayoutPoint& point : layout_->points) {
    offset_.push_back(point.side == 0 ? Ball().rounded(precision_)
                                      : Ball(point.side) * exp(log_offsets[free++].rounded(precision_)));
    xi_.push_back(Ball(problem_->anchors[point.anchor], precision_) + offset_.back());
  }
  for (std::size_t k = 0; k < segments(); ++k) {
    if (!length(k).is_positive()) {
      throw Unproved("points " + std::to_string(k) + " and " + std::to_string(k + 1) +
                     " are not in order over all of the box");
    }
  }
}

Ball Contact::distance(std::size_t i, std::size_t j) const {
  const std::size_t from = layout_->points[i].anchor;
  const std::size_t to = layout_->points[j].anchor;
  if (i == j) return {};
  if (from == to) return offset_[j] - offset_[i];
  return Ball(problem_->anchors[to] - problem_->anchors[from], precision_) + (offset_[j] - offset_[i]);
}

void Contact::find_powers() {
  const Ball half(0.5);
  const auto alpha = [&](std::size_t segment) { return atan(Ball(s(segment), precision_)) / Ball::pi(precision_); };
  power_.resize(points());
  cosine_.resize(segments());
  sign_.resize(segments());
  int n = 0;  // sigma outside the contact; inside it is m, with sigma = alpha + m + 1/2
  for (std::size_t j = points(); j-- > 0;) {
    const LayoutPoint& point = layout_->points[j];
    if (point.contact == Kind::ends) {
      power_[j] = point.is_free() ? half + alpha(j - 1) : alpha(j - 1) - half;
      n -= point.is_free() ? 0 : 1;
    } else if (point.contact == Kind::begins) {
      power_[j] = point.is_free() ? half - alpha(j) : -half - alpha(j);
      n += point.is_free() ? 1 : 0;
    } else if (point.contact == Kind::interior && s(j - 1) != s(j)) {
      power_[j] = alpha(j - 1) - alpha(j);
    }
    if (!power_[j].is_zero()) {
      const auto same = std::ranges::find_if(alike_, [&](const auto& group) { return same_power(group.front(), j); });
      (same == alike_.end() ? alike_.emplace_back() : *same).push_back(j);
    }
    if (j == 0) break;
    const int parity = n % 2 == 0 ? 1 : -1;
    sign_[j - 1] = in_contact(j - 1) ? -parity : parity;
    const Ball slope(s(j - 1), precision_);
    cosine_[j - 1] = Ball(1) / sqrt(Ball(1) + slope * slope);
  }
}

bool Contact::same_power(std::size_t i, std::size_t j) const {
  const LayoutPoint& a = layout_->points[i];
  const LayoutPoint& b = layout_->points[j];
  const auto contact_at = [](std::size_t k, const LayoutPoint& p) { return p.contact == Kind::ends ? k - 1 : k; };
  return a.contact == b.contact && a.is_end() && a.is_free() == b.is_free() &&
         s(contact_at(i, a)) == s(contact_at(j, b));
}

Ball Contact::modulus(const SurfacePoint& at, std::size_t but) const {
  Ball sum;
  for (std::size_t j = 0; j < points(); ++j) {
    if (j != but && !power_[j].is_zero()) sum += power_[j] * log(distance(at, j));
  }
  return exp(sum.rounded(precision_));
}

void Contact::expand() {
  std::size_t degree = 0;
  for (const Polynomial& g : problem_->slopes) degree = std::max(degree, g.size());
  const std::size_t count = degree + 4 + static_cast<std::size_t>(std::abs(degree_));
  // log Y = S log z - sum_k sigma_k z^-k/k with the power sums sigma_k of the points.
  std::vector<Ball> sigma(count);
  for (std::size_t j = 0; j < points(); ++j) {
    Ball term = power_[j];
    for (std::size_t k = 1; k < count; ++k) sigma[k] += term = term * xi_[j];
  }
  series_.assign(count, Ball());
  inverse_series_.assign(count, Ball());
  series_[0] = inverse_series_[0] = Ball(1).rounded(precision_);
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = 1; k <= i; ++k) {
      series_[i] -= sigma[k] * series_[i - k];
      inverse_series_[i] += sigma[k] * inverse_series_[i - k];
    }
    series_[i] = series_[i] / Ball(static_cast<int>(i));
    inverse_series_[i] = inverse_series_[i] / Ball(static_cast<int>(i));
  }
}

Ball Contact::coefficient(const std::vector<Ball>& g, int k) const {
  Ball sum;
  for (std::size_t l = 0; l < g.size(); ++l) {
    const int index = static_cast<int>(l) - degree_ - k;
    if (index >= 0) sum += g[l] * inverse_series_.at(static_cast<std::size_t>(index));
  }
  return sum;
}

}  // namespace steadyslide::checker
