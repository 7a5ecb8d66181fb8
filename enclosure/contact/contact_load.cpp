#include "enclosure/contact/contact_load.hpp"

namespace steadyslide::enclosure {

bool ContactLoad::changes_polynomial(std::size_t j) const {
  return j > 0 && j < set_.segments() && set_.in_contact(j - 1) && set_.in_contact(j) &&
         form_.slope_of(j - 1) != form_.slope_of(j);
}

const ContactPanel& ContactLoad::facing_panel(std::size_t c, std::size_t segment) const {
  return segment < c ? form_.panels(c).front() : form_.panels(c - 1).back();
}

Ball ContactLoad::bound_beside(std::size_t c, const ContactPanel& panel) const {
  // With y, z in the ellipse E of the panel on the other side, of length D: the quotient of differences is at most
  // 2 max |G|/(their distance from E's boundary). |z| <= 9/20 D puts them into the confocal ellipse with the larger
  // semi-axis 19/10 D/2, and two of these are as far apart as their larger semi-axes differ.
  const std::size_t segment = panel.part().segment;
  const std::size_t k = form_.slope_of(segment);
  const std::size_t other = segment < c ? c : c - 1;
  const ContactPanel& facing = facing_panel(c, segment);
  const ContactForm::Difference& difference = form_.difference(k, other);
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

Ball ContactLoad::singular_load(std::size_t c, std::size_t segment, const Ball& length) const {
  const std::size_t k = form_.slope_of(segment);
  const std::size_t other = segment < c ? c : c - 1;
  BallPolynomial around = shifted(form_.difference(k, other).coefficients, set_.x(c));
  const Ball pi = Ball::pi(set_.bits());
  const bool logarithm = set_.is_regular(c);
  Ball sum(0, set_.bits());
  Ball power = length;
  for (std::size_t i = 0; i < around.size(); ++i) {
    // (x - c)^i = (-d)^i to the left of c.
    Ball term = around[i] * power / Ball(static_cast<int>(i) + 1);
    if (logarithm) term *= log(length) - Ball(1) / Ball(static_cast<int>(i) + 1, set_.bits());
    sum += segment < c && i % 2 == 1 ? -term : term;
    power *= length;
  }
  const Ball factor = Ball(set_.sign(segment) * (segment < c ? 1 : -1)) * set_.cos_alpha(segment);
  return sum * factor / (logarithm ? pi : -sin(pi * set_.power(c)));
}

Ball ContactLoad::load_on(std::size_t segment) const {
  const Bits bits = set_.bits();
  const std::size_t k = form_.slope_of(segment);
  Ball sum(0, bits);  // of |Y| B, and apart from it the singular terms
  Ball singular(0, bits);
  const auto add = [&](ContactPanel::Part part, std::optional<std::size_t> c) {
    const ContactPanel panel = form_.panel(std::move(part));
    for (const ContactPanel::Node& node : panel.nodes()) {
      const LocalValue b = form_.regular_factor(k, {segment, node.from_left, node.from_right});
      sum += node.weight * (c ? b.regular : b.value());
    }
    sum = Ball::plus_or_minus(
        sum, panel.remainder(c ? bound_beside(*c, panel) : form_.bound(k, panel, Ellipse::far), Ellipse::far));
  };
  for (ContactPanel::Part& part : ContactPanel::graded(set_, segment)) {
    const std::size_t c = part.touches == Side::right ? segment + 1 : segment;
    if (!part.touches || !changes_polynomial(c)) {
      add(std::move(part), std::nullopt);
      continue;
    }
    // A panel a fifth as long as the one on the other side, then each as long as what lies behind it.
    const bool left = *part.touches == Side::left;
    const Ball whole = part.length;
    const Ball fifth = (facing_panel(c, segment).part().length / Ball(5)).lower();
    Ball from(0, bits);
    for (bool first = true, more = true; more; first = false) {
      Ball length = first ? fifth : from;
      more = length < whole - from;
      if (!more) length = whole - from;
      const Ball rest = set_.length(segment) - from - length;
      ContactPanel::Part piece{segment, left ? from : rest, left ? rest : from, length, {}};
      if (first) {
        piece.touches = part.touches;
        singular += singular_load(c, segment, length);
      }
      add(std::move(piece), first ? std::optional(c) : std::nullopt);
      from += length;
    }
  }
  return sum * Ball(set_.sign(segment)) * set_.cos_alpha(segment) + singular;
}

}  // namespace steadyslide::enclosure
