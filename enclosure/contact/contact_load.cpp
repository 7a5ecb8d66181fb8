#include "enclosure/contact/contact_load.hpp"

#include "enclosure/number/task_threads.hpp"

namespace steadyslide::enclosure {

bool ContactLoad::changes_polynomial(std::size_t j) const {
  return j > 0 && j < set_.segments() && set_.in_contact(j - 1) && set_.in_contact(j) &&
         form_.slope_of(j - 1) != form_.slope_of(j);
}

const ContactPanel& ContactLoad::facing_panel(std::size_t c, std::size_t segment) const {
  return segment < c ? form_.panels(c).front() : form_.panels(c - 1).back();
}

Ball ContactLoad::bound_beside(std::size_t c, const ContactPanel& panel) const {
  // Let y, z lie in the ellipse E of the panel on the other side, of length D. The difference quotient is at most 2 max
  // |G|/(their distance from E's boundary). |z| <= 9/20 D puts them into the confocal ellipse with the larger semi-axis
  // 19/10 D/2. The distance of two confocal ellipses is the difference of their larger semi-axes.
  const std::size_t segment = panel.part().segment;
  const std::size_t k = form_.slope_of(segment);
  const std::size_t other = segment < c ? c : c - 1;
  const ContactPanel& facing = facing_panel(c, segment);
  const TractionRepresentation::Difference& difference = form_.difference(k, other);
  const Ball length = facing.part().length.at(64);
  const Bits bits = length.bits();
  if (!(Ball(4) * panel.part().length.at(64) <= length)) return Ball::unknown(bits);
  const Ball margin = (facing.reach(Ellipse::beside) + length / Ball(2)) - length * Ball(Rational(19, 20), bits);
  const Ball largest =
      facing.largest(difference.coefficients, Ellipse::beside) * facing.largest_product(Ellipse::beside);
  const Ball a = facing.power().at(64);
  const Ball ratio(Rational(9, 11), bits);  // |w|/(1 - |w|) for |w| <= 9/20
  Ball rest =
      set_.is_regular(c) ? abs(log(length)) + ratio : power(length, a) * (Ball(1) / abs(a) + ratio / (Ball(1) - a));
  rest += power(length, a + Ball(1)) / (a + Ball(1)) * Ball(2) * pole_bound(margin);
  Ball sum = form_.bound(k, panel, Ellipse::far, other) + largest * rest / Ball(3);
  for (std::size_t n = 0; n < form_.panels(other).size(); ++n) {
    const ContactPanel& beyond = form_.panels(other)[n];
    if (&beyond == &facing) continue;
    const Ball clear =
        (segment < c ? beyond.part().from_left : beyond.part().from_right).at(bits) - panel.reach(Ellipse::far);
    sum += difference.masses[n] * pole_bound(clear);
  }
  return sum;
}

TractionRule::Singular ContactLoad::singular_term(std::size_t c, std::size_t segment) const {
  const std::size_t other = segment < c ? c : c - 1;
  const Ball pi = Ball::pi(set_.bits());
  const bool logarithm = set_.is_regular(c);
  const Ball factor = Ball(set_.sign(segment) * (segment < c ? 1 : -1)) * set_.cos_alpha(segment) /
                      (logarithm ? pi : -sin(pi * set_.power(c)));
  TractionRule::Singular result{shifted(form_.difference(form_.slope_of(segment), other).coefficients, set_.x(c)),
                                logarithm, segment < c ? -1 : 1};
  for (Ball& coefficient : result.factor) coefficient *= factor;
  return result;
}

TractionRule ContactLoad::rule(ContactPanel::Interval part) const {
  const std::size_t segment = part.segment;
  const std::size_t k = form_.slope_of(segment);
  const std::size_t c = part.touches == Side::right ? segment + 1 : segment;
  const bool apart = part.touches && changes_polynomial(c);
  TractionRule result{form_.panel(std::move(part)), {}, Ball(0), Ball(0, 64), {}};
  // cos(pi alpha) <= 1.
  result.bound = apart ? bound_beside(c, result.panel) : form_.bound(k, result.panel, Ellipse::far);
  if (apart) result.singular = singular_term(c, segment);
  // The load of a panel beside a tiny gap is below the rounding error of the load, so its bound is sufficient.
  Ball mass(0, 64);
  for (const ContactPanel::Node& node : result.panel.nodes()) mass += node.weight.at(64);
  const Ball most = result.bound * mass;
  if (most < Ball(set_.problem().load, 64) * power(Ball(2, 64), -static_cast<int>(set_.bits()))) {
    result.neglected = most;
    return result;
  }
  const Ball factor = Ball(set_.sign(segment)) * set_.cos_alpha(segment);
  for (const ContactPanel::Node& node : result.panel.nodes()) {
    const LocalValue b = form_.regular_factor(k, {segment, node.from_left, node.from_right});
    result.values.push_back(factor * node.weight * (apart ? b.analytic() : b.value()));
  }
  return result;
}

std::vector<TractionRule> ContactLoad::rules(std::size_t segment, const ContactPanel::DistanceRange& range,
                                             const Longest& longest) const {
  std::vector<ContactPanel::Interval> parts;
  const auto outward = [&](Side from, const ContactPanel::DistanceRange& distances) {
    const std::size_t j = from == Side::left ? segment : segment + 1;
    // If the polynomial changes, use a panel with a fifth of the length of the one on the other side.
    std::optional<Ball> first;
    if (changes_polynomial(j)) first = facing_panel(j, segment).part().length / Ball(5);
    for (ContactPanel::Interval& part : ContactPanel::outward(set_, segment, from, distances, first)) {
      for (ContactPanel::Interval& piece : ContactPanel::divided(std::move(part), longest)) {
        parts.push_back(std::move(piece));
      }
    }
  };
  // Divide outwards from the nearer of the segment's points.
  const Ball& whole = set_.length(segment);
  const Ball half = whole / Ball(2);
  const auto is_before = [](const Ball& a, const Ball& b) { return a.midpoint() < b.midpoint(); };
  const bool ends_before = is_before(range.to, half);
  if (is_before(range.from, half)) outward(Side::left, {range.from, ends_before ? range.to : half});
  if (!ends_before) {
    const Ball rest = is_before(range.to, whole) ? whole - range.to : Ball(0, set_.bits());
    outward(Side::right, {rest, is_before(range.from, half) ? half : whole - range.from});
  }
  const auto rule_of = [&](std::size_t i) { return rule(parts[i]); };
  // For fewer places, moments may not pay off; the work counts them as computed one by one.
  const bool are_many = 2 * static_cast<Bits>(parts.size()) * form_.count() > set_.bits();
  if (are_many) form_.prepare(form_.slope_of(segment), segment);
  return TaskThreads(are_many ? threads_ : 1).all(0, parts.size(), rule_of);
}

namespace {

/// Returns int_0^length p(+-d) S dd.
Ball integral(const TractionRule::Singular& term, const BallPolynomial& weight, const Ball& length) {
  const BallPolynomial p = product(term.factor, weight);
  Ball sum(0, length.bits());
  Ball power = length;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Ball n(static_cast<int>(i) + 1, length.bits());
    Ball part = p[i] * power / n;
    if (term.logarithm) part *= log(length) - Ball(1) / n;
    sum += term.direction < 0 && i % 2 == 1 ? -part : part;
    power *= length;
  }
  return sum;
}

}  // namespace

Ball ContactLoad::load_on(std::size_t segment, const ContactPanel::DistanceRange& range,
                          const BallPolynomial& weight) const {
  Ball sum(0, set_.bits());
  for (const TractionRule& rule : rules(segment, range, {})) {
    const auto& nodes = rule.panel.nodes();
    for (std::size_t i = 0; i < rule.values.size(); ++i) {
      sum += rule.values[i] * value_at(weight, set_.x(segment) + nodes[i].from_left);
    }
    sum = Ball::plus_or_minus(sum, rule.error(rule.panel.largest(weight, Ellipse::far)));
    if (!rule.singular) continue;
    const ContactPanel::Interval& part = rule.panel.part();
    const Ball& c = set_.x(part.touches == Side::right ? segment + 1 : segment);
    sum += integral(*rule.singular, shifted(weight, c), part.length);
  }
  return sum;
}

Ball ContactLoad::load_on(std::size_t segment) const {
  return load_on(segment, {Ball(0, set_.bits()), set_.length(segment)}, {Ball(1, set_.bits())});
}

}  // namespace steadyslide::enclosure
