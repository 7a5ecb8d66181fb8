#include "enclosure/contact/traction_representation.hpp"

#include <algorithm>

#include "enclosure/contact/power_at_point.hpp"

namespace steadyslide::enclosure {
namespace {

/// An expansion costs as much as this number of panels.
constexpr std::size_t few_panels = 12;
/// From this number of segments in contact on, sums over other segments use the moments of each segment.
constexpr std::ptrdiff_t many_segments = 4;

/// Returns sum v_i/(to_segment + y_i). This is the sum with the most terms in this file.
Ball cauchy_sum(const ContactPanel& panel, const std::vector<Ball>& values, const Ball& to_segment, bool to_the_right) {
  const Bits bits = to_segment.bits();
  Ball sum(0, bits), term(0, bits);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ContactPanel::Node& node = panel.nodes()[i];
    arb_add(term.get(), to_segment.get(), (to_the_right ? node.from_left : node.from_right).get(), bits);
    arb_div(term.get(), values[i].get(), term.get(), bits);
    arb_add(sum.get(), sum.get(), term.get(), bits);
  }
  return sum;
}

}  // namespace

int LocalValue::sign() const {
  const auto decided = [](const Ball& x) { return x.is_positive() ? 1 : x.is_negative() ? -1 : 0; };
  if (has_singular && least.is_positive()) {
    // C times any number >= `least`.
    const int leading = decided(coefficient);
    if (leading != 0 && decided(regular + coefficient * least) == leading) return leading;
  }
  return !has_singular || singular.is_finite() ? decided(value()) : 0;
}

Ball LocalValue::value() const { return has_singular ? regular + coefficient * singular : regular; }

TractionRepresentation::TractionRepresentation(ContactSet set, BallPolynomial q, Ball tilt, int count,
                                               JacobiRules& rules)
    : set_(std::move(set)), q_(std::move(q)), tilt_(std::move(tilt)), count_(count), rules_(&rules) {
  if (set_.degree_at_infinity() < 0) q_.push_back(set_.loads());
  for (const Polynomial& slope : set_.problem().slopes) slopes_.push_back({slope, {}, {}});
  expand_at_infinity();
  for (Slope& slope : slopes_) take_polynomial_parts(slope);
  panels_.resize(set_.segments());
  differences_.resize(slopes_.size());
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) take_differences(segment);
  for (const auto& panels : panels_) {
    const auto nodes = static_cast<std::int64_t>(panels.size()) * count_;
    work_of_place_ += std::min(nodes, static_cast<std::int64_t>(set_.bits()) / 2);
  }
  work_of_place_ = (work_of_place_ + static_cast<std::int64_t>(set_.points())) * ((set_.bits() + 63) / 64);
}

void TractionRepresentation::expand_at_infinity() {
  const Bits bits = set_.bits();
  int highest = 0;
  for (const Slope& slope : slopes_) highest = std::max(highest, slope.exact.degree());
  const int terms = highest + std::abs(set_.degree_at_infinity()) + static_cast<int>(q_.size()) + 4;
  std::vector<Ball> sums;  // sums of p_j e_j^n
  for (int n = 1; n <= terms; ++n) {
    Ball sum(0, bits);
    for (std::size_t j = 0; j < set_.points(); ++j) {
      if (!set_.is_regular(j)) sum += set_.power(j) * power(set_.x(j), n);
    }
    sums.push_back(std::move(sum));
  }
  // prod (1 - e_j/z)^(-+p_j): n d_n = +-(sum of sums_k d_{n-k}).
  const auto expand = [&](int sign) {
    std::vector<Ball> result{Ball(1, bits)};
    for (int n = 1; n <= terms; ++n) {
      Ball sum(0, bits);
      for (int k = 1; k <= n; ++k) {
        sum += sums[static_cast<std::size_t>(k - 1)] * result[static_cast<std::size_t>(n - k)];
      }
      result.push_back(Ball(sign) * sum / Ball(n));
    }
    return result;
  };
  reciprocal_ = expand(1);
  expansion_ = expand(-1);
}

void TractionRepresentation::take_polynomial_parts(Slope& slope) {
  const int degree = set_.degree_at_infinity();
  slope.coefficients = in_balls(slope.exact, set_.bits());
  if (slope.coefficients.empty()) slope.coefficients.emplace_back(0, set_.bits());
  slope.coefficients[0] += tilt_;
  const int top = std::max(static_cast<int>(slope.coefficients.size()) - 1 - degree, static_cast<int>(q_.size()) - 1);
  for (int i = 0; i <= top; ++i) {
    Ball c(0, set_.bits());
    for (std::size_t m = 0; m < slope.coefficients.size(); ++m) {
      c += slope.coefficients[m] * reciprocal(static_cast<int>(m) - degree - i);
    }
    if (static_cast<std::size_t>(i) < q_.size()) c -= q_[static_cast<std::size_t>(i)] / Ball::pi(set_.bits());
    slope.rational.push_back(std::move(c));
  }
}

void TractionRepresentation::take_differences(std::size_t segment) {
  const bool integrates = set_.in_contact(segment) && slopes_.size() > 1;
  if (integrates) {
    for (ContactPanel::Interval& part : ContactPanel::graded(set_, segment)) {
      panels_[segment].emplace_back(set_, std::move(part), -1, std::nullopt, count_, *rules_);
    }
  }
  const Ball factor =
      set_.in_contact(segment) ? Ball(set_.sign(segment)) * set_.cos_alpha(segment) : Ball(1, set_.bits());
  std::vector<Ball> moments_of_weights;
  if (integrates && set_.segments_in_contact() >= many_segments) {
    int degree = 0;
    for (const Slope& slope : slopes_) degree = std::max(degree, slope.exact.degree());
    moments_of_weights = SegmentMoments::of_weights(set_, segment, panels_[segment], degree);
  }
  const auto nodes = static_cast<std::int64_t>(panels_[segment].size()) * count_;
  work_of_panels_ +=
      nodes * static_cast<std::int64_t>(set_.points() + moments_of_weights.size()) * ((set_.bits() + 63) / 64);
  for (std::size_t k = 0; k < slopes_.size(); ++k) {
    Difference difference;
    difference.exact = slopes_[slope_of(segment)].exact - slopes_[k].exact;
    difference.coefficients = in_balls(difference.exact, set_.bits());
    for (Ball& c : difference.coefficients) c *= factor;
    for (const ContactPanel& panel : panels_[segment]) {
      if (k == slope_of(segment)) break;
      const Ball size = panel.largest(difference.coefficients, Ellipse::far);
      std::vector<Ball> values;
      Ball mass = panel.remainder(size, Ellipse::far);
      for (const ContactPanel::Node& node : panel.nodes()) {
        values.push_back(node.weight * value_at(difference.coefficients, set_.x(segment) + node.from_left));
        mass += node.weight.at(size.bits()) * size;
      }
      difference.values.push_back(std::move(values));
      difference.masses.push_back(mass / Ball(3));  // 3 < pi
      difference.sizes.push_back(size);
    }
    if (!moments_of_weights.empty() && k != slope_of(segment)) {
      difference.from_afar.emplace(set_, segment, panels_[segment], moments_of_weights, difference.coefficients,
                                   difference.sizes, set_.bits());
    }
    differences_[k].push_back(std::move(difference));
  }
}

Ball TractionRepresentation::distance(const SurfacePoint& place, std::size_t j) const {
  return abs(j <= place.segment ? place.from_left + set_.distance(j, place.segment)
                                : place.from_right + set_.distance(place.segment + 1, j));
}

Ball TractionRepresentation::coordinate(const SurfacePoint& place) const {
  // Measure from the nearer point, because its distance is the thinner ball.
  return place.from_left < place.from_right ? set_.x(place.segment) + place.from_left
                                            : set_.x(place.segment + 1) - place.from_right;
}

Ball TractionRepresentation::modulus(const SurfacePoint& place, std::optional<std::size_t> without) const {
  Ball product(1, set_.bits());
  Ball sum(0, set_.bits());
  for (std::size_t j = 0; j < set_.points(); ++j) {
    if (set_.is_regular(j) || without == j) continue;
    const Ball d = distance(place, j);
    if (d.is_positive()) {
      sum += set_.power(j) * log(d);
    } else {
      product *= power(d, set_.power(j));
    }
  }
  return product * exp(sum);
}

LocalValue TractionRepresentation::regular_factor(std::size_t k, const SurfacePoint& place) const {
  LocalValue sum{Ball(0, set_.bits()), Ball(0, set_.bits()), Ball(0, set_.bits()), Ball(0, set_.bits())};
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    if (set_.in_contact(segment) && slope_of(segment) != k) add_cauchy(k, segment, place, sum);
  }
  sum.regular = value_at(slopes_[k].rational, coordinate(place)) - sum.regular / Ball::pi(set_.bits());
  return sum;
}

Ball TractionRepresentation::regular_factor_at_end(std::size_t j) const {
  const bool begins = set_.point(j).kind == ContactTopology::Kind::begins;
  return regular_factor(set_.place_of(j, begins ? j : j - 1)).value();
}

void TractionRepresentation::add_cauchy(std::size_t k, std::size_t segment, const SurfacePoint& place,
                                        LocalValue& sum) const {
  const bool to_the_right = segment > place.segment;
  const Difference& difference = differences_[k][segment];
  const Ball to_segment = distance(place, to_the_right ? segment : segment + 1);
  const Side towards = to_the_right ? Side::left : Side::right;
  if (difference.from_afar) {
    if (const std::optional<Ball> all = difference.from_afar->seen_from(to_segment, towards)) {
      sum.regular += to_the_right ? *all : -*all;
      return;
    }
  }
  const std::size_t count = panels_[segment].size();
  PanelMoments::Rest rest{Ball(0, set_.bits()), 0, count};
  // An expansion is useless for a wide distance.
  const bool is_thin = to_segment.radius() * power(Ball(2, 64), 20) < to_segment;
  if (count > few_panels && is_thin) {
    if (const PanelMoments* all = moments(difference, segment, place.segment)) {
      rest = all->seen_from(to_segment);
      sum.regular += to_the_right ? rest.sum : -rest.sum;
    }
  }
  for (std::size_t from_c = rest.first; from_c < rest.last; ++from_c) {
    const std::size_t n = to_the_right ? from_c : count - 1 - from_c;
    const ContactPanel& panel = panels_[segment][n];
    const std::vector<Ball>& values = difference.values[n];
    const ContactPanel::Interval& part = panel.part();
    const bool neighbours = to_the_right ? segment == place.segment + 1 : segment + 1 == place.segment;
    if (neighbours && part.touches == towards && Ball(2) * to_segment < part.length) {
      add_beside(panel, difference, values, place, sum);
      continue;
    }
    const Ball to_panel = to_segment + (to_the_right ? part.from_left : part.from_right);
    const Ellipse ellipse =
        to_panel > part.length * Ball(Rational(19, 20), set_.bits()) ? Ellipse::far : Ellipse::close;
    const Ball clear = to_panel.lower() - panel.reach(ellipse);
    const Ball part_sum = Ball::plus_or_minus(
        cauchy_sum(panel, values, to_segment, to_the_right),
        panel.remainder(panel.largest(difference.coefficients, ellipse) * pole_bound(clear), ellipse));
    sum.regular += to_the_right ? part_sum : -part_sum;
  }
}

void TractionRepresentation::prepare(std::size_t k, std::size_t segment) const {
  for (std::size_t other = 0; other < set_.segments(); ++other) {
    if (!set_.in_contact(other) || slope_of(other) == k || panels_[other].size() <= few_panels) continue;
    const Side facing = other > segment ? Side::left : Side::right;
    differences_[k][other].asked[facing == Side::left ? 0 : 1] = set_.bits();
    moments(differences_[k][other], other, segment);
  }
}

const PanelMoments* TractionRepresentation::moments(const Difference& difference, std::size_t segment,
                                                    std::size_t seen_from) const {
  const Side facing = segment > seen_from ? Side::left : Side::right;
  const std::size_t side = facing == Side::left ? 0 : 1;
  std::shared_ptr<const PanelMoments>& made = difference.moments[side];
  const Ball zero(0, 64);
  const PanelMoments::DistanceRange here =
      facing == Side::left
          ? PanelMoments::DistanceRange{seen_from + 1 == segment ? zero : set_.distance(seen_from + 1, segment),
                                        set_.distance(seen_from, segment)}
          : PanelMoments::DistanceRange{segment + 1 == seen_from ? zero : set_.distance(segment + 1, seen_from),
                                        set_.distance(segment + 1, seen_from + 1)};
  if (made && made->cover(here)) return made.get();
  if (2 * ++difference.asked[side] <= set_.bits()) return made.get();
  difference.asked[side] = 0;
  // At first for the distances of one segment; for all distances when another segment needs the moments.
  const std::optional<PanelMoments::DistanceRange> expected = made ? std::nullopt : std::optional(here);
  made = std::make_shared<PanelMoments>(panels_[segment], difference.values, difference.sizes, facing, expected,
                                        set_.bits());
  return made.get();
}

void TractionRepresentation::add_beside(const ContactPanel& panel, const Difference& difference,
                                        const std::vector<Ball>& values, const SurfacePoint& place,
                                        LocalValue& sum) const {
  const Bits bits = set_.bits();
  const ContactPanel::Interval& part = panel.part();
  const bool to_the_right = *part.touches == Side::left;
  const std::size_t c = to_the_right ? part.segment : part.segment + 1;
  const Ball& d = to_the_right ? place.from_right : place.from_left;
  const Ball& a = panel.power();
  const Ball pi = Ball::pi(bits);

  // G(-d) without the zero of order m of g - g_k.
  const Rational& c_exact = set_.problem().anchors[set_.point(c).anchor].x;
  int m = 0;
  for (Polynomial exact = difference.exact; exact(c_exact) == 0; exact = exact.derivative()) ++m;
  std::vector<Ball> around = shifted(difference.coefficients, set_.x(c));
  around.erase(around.begin(), around.begin() + m);
  Ball exponents(0, bits);
  for (std::size_t j = 0; j < set_.points(); ++j) {
    if (j != c && !set_.is_regular(j)) exponents -= set_.power(j) * log(distance(place, j));
  }
  const Ball beyond = to_the_right ? -d : d;  // x - c
  const Ball reduced = value_at(around, beyond) * exp(exponents);
  const Ball at_place = reduced * power(beyond, m);

  // int y^a (G(y) - G(-d))/(y + d) dy.
  Ball total(0, bits);
  for (std::size_t i = 0; i < panel.nodes().size(); ++i) {
    const ContactPanel::Node& node = panel.nodes()[i];
    total += (values[i] - node.end_weight * at_place) / ((to_the_right ? node.from_left : node.from_right) + d);
  }
  const Ball clear = panel.reach(Ellipse::beside) - d.upper();
  total = Ball::plus_or_minus(
      total,
      panel.remainder(panel.largest(difference.coefficients, Ellipse::beside) * pole_bound(clear), Ellipse::beside));
  total = Ball::plus_or_minus(total, panel.end_remainder(abs(at_place) * pole_bound(clear), Ellipse::beside));

  // G(-d) times Cauchy's integral of y^a, without its singular term. (-1/pi) times this is part of B.
  const Ball sign(to_the_right ? 1 : -1, bits);
  const PowerAtPoint at_c(a, set_.is_regular(c), part.length);
  sum.regular += sign * (total + at_place * at_c.analytic_part(d));
  // (x - c)^m = (-+1)^m d^m.
  sum.coefficient = -sign * reduced * Ball(to_the_right && m % 2 == 1 ? -1 : 1) * at_c.factor() / pi;
  sum.shift = sum.coefficient * power(d, m) * at_c.constant();
  sum.singular = at_c.singular_part(d, m);
  sum.least = m == 0 && d.upper().is_positive() ? at_c.at(d.upper()) : Ball(0, bits);
  sum.has_singular = true;
}

Ball TractionRepresentation::profile_slope(const SurfacePoint& place) const {
  return value_at(slopes_[slope_of(place.segment)].coefficients, coordinate(place));
}

Ball TractionRepresentation::bound(std::size_t k, const ContactPanel& panel, Ellipse ellipse,
                                   std::optional<std::size_t> without) const {
  Ball sum = panel.largest(slopes_[k].rational, ellipse);
  const std::size_t at = panel.part().segment;
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    if (!set_.in_contact(segment) || slope_of(segment) == k || without == segment) continue;
    const bool to_the_right = segment > at;
    const Ball clear = (to_the_right ? set_.distance(at + 1, segment) + panel.part().from_right
                                     : set_.distance(segment + 1, at) + panel.part().from_left)
                           .at(sum.bits()) -
                       panel.reach(ellipse);
    for (const Ball& mass : differences_[k][segment].masses) sum += mass * pole_bound(clear);
  }
  return sum;
}

Ball TractionRepresentation::gap_change(const ContactPanel::Interval& part, std::size_t k) const {
  const std::size_t segment = part.segment;
  const ContactPanel panel = this->panel(part);
  const Ball error = panel.remainder(bound(k, panel, Ellipse::far), Ellipse::far);
  if (!error.is_finite()) return Ball::unknown(set_.bits());
  Ball sum = Ball::plus_or_minus(Ball(0, set_.bits()), error);
  for (const ContactPanel::Node& node : panel.nodes()) {
    sum += node.weight * regular_factor(k, {segment, node.from_left, node.from_right}).value();
  }
  return Ball(set_.sign(segment)) * sum +
         integral_over(differences_[k][segment].coefficients, set_.x(segment) + part.from_left, part.length);
}

}  // namespace steadyslide::enclosure
