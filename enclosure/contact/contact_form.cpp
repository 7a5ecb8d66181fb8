#include "enclosure/contact/contact_form.hpp"

#include <algorithm>

namespace steadyslide::enclosure {
namespace {

using Polynomial_ = std::vector<Ball>;

Polynomial_ in_balls(const Polynomial& polynomial, Bits bits) {
  Polynomial_ result;
  for (const Rational& c : polynomial.coefficients()) result.emplace_back(c, bits);
  return result;
}

Ball value_at(const Polynomial_& polynomial, const Ball& x) {
  Ball value(0, x.bits());
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * x + polynomial[i];
  return value;
}

/// int_x^{x+length} p: from the derivatives at x, so that a short interval loses nothing.
Ball integral_over(Polynomial_ polynomial, const Ball& x, const Ball& length) {
  Ball sum(0, x.bits());
  Ball power = length;
  for (int i = 1; !polynomial.empty(); ++i) {
    sum += value_at(polynomial, x) * power;
    power *= length / Ball(i + 1);
    for (std::size_t k = 1; k < polynomial.size(); ++k) polynomial[k - 1] = polynomial[k] * Ball(static_cast<int>(k));
    polynomial.pop_back();
  }
  return sum;
}

/// The coefficients of powers of x - c.
Polynomial_ shifted(Polynomial_ polynomial, const Ball& c) {
  for (std::size_t low = 0; low < polynomial.size(); ++low) {
    for (std::size_t i = polynomial.size() - 1; i-- > low;) polynomial[i] += polynomial[i + 1] * c;
  }
  return polynomial;
}

/// q(z)/(z - e) without its remainder.
Polynomial_ quotient(const Polynomial_& q, const Ball& e) {
  Polynomial_ result(q.empty() ? 0 : q.size() - 1, Ball(0, e.bits()));
  Ball carry(0, e.bits());
  for (std::size_t k = q.size(); k-- > 1;) {
    carry = carry * e + q[k];
    result[k - 1] = carry;
  }
  return result;
}

/// 1/distance; not finite where the distance may be 0, so that no bound is made of it.
Ball pole_bound(const Ball& distance) {
  return distance.is_positive() ? Ball(1) / distance : Ball::unknown(distance.bits());
}

/// [-x, x].
Ball error(const Ball& x) { return Ball::around(Ball(0, x.bits()), x.upper()); }

}  // namespace

int LocalValue::sign() const {
  const auto decided = [](const Ball& x) { return x.is_positive() ? 1 : x.is_negative() ? -1 : 0; };
  if (!has_singular || singular.is_finite()) return decided(value());
  // C times anything from `least` to infinity.
  const int leading = decided(coefficient);
  return leading != 0 && least.is_positive() && decided(regular + coefficient * least) == leading ? leading : 0;
}

Ball LocalValue::value() const { return has_singular ? regular + coefficient * singular : regular; }

ContactForm::ContactForm(ContactSet set, std::vector<Ball> q, Ball tilt, int count, JacobiRules& rules)
    : set_(std::move(set)),
      q_(std::move(q)),
      tilt_(std::move(tilt)),
      count_(count),
      rules_(&rules),
      degree_(set_.degree_at_infinity()) {
  const Bits bits = set_.bits();
  if (degree_ < 0) q_.emplace_back(set_.problem().load, bits);

  int highest = 0;
  std::vector<Polynomial> exact;
  for (std::size_t k = 0; k < set_.segments(); ++k) {
    const Polynomial& slope = set_.interval(k).slope;
    const auto found = std::find(exact.begin(), exact.end(), slope);
    slopes_of_.push_back(static_cast<std::size_t>(found - exact.begin()));
    if (found == exact.end()) exact.push_back(slope);
    highest = std::max(highest, slope.degree());
  }

  // n d_n = sum of (sum p_j e_j^k) d_{n-k}.
  const int terms = highest + std::abs(degree_) + static_cast<int>(q_.size()) + 4;
  std::vector<Ball> sums;
  for (int n = 1; n <= terms; ++n) {
    Ball sum(0, bits);
    for (std::size_t j = 0; j < set_.points(); ++j) {
      if (!set_.is_regular(j)) sum += set_.power(j) * power(set_.x(j), n);
    }
    sums.push_back(sum);
  }
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
  y_series_ = expand(-1);

  const Ball pi = Ball::pi(bits);
  for (const Polynomial& g : exact) {
    Slope slope{g, in_balls(g, bits), {}};
    if (slope.coefficients.empty()) slope.coefficients.emplace_back(0, bits);
    slope.coefficients[0] += tilt_;
    const int top =
        std::max(static_cast<int>(slope.coefficients.size()) - 1 - degree_, static_cast<int>(q_.size()) - 1);
    for (int i = 0; i <= top; ++i) {
      Ball c(0, bits);
      for (std::size_t m = 0; m < slope.coefficients.size(); ++m) {
        c += slope.coefficients[m] * series(reciprocal_, static_cast<int>(m) - degree_ - i);
      }
      if (static_cast<std::size_t>(i) < q_.size()) c -= q_[static_cast<std::size_t>(i)] / pi;
      slope.rational.push_back(std::move(c));
    }
    slopes_.push_back(std::move(slope));
  }

  const bool integrates = slopes_.size() > 1;
  panels_.resize(set_.segments());
  differences_.resize(slopes_.size());
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    for (std::size_t k = 0; k < slopes_.size(); ++k) {
      Difference difference{set_.interval(segment).slope - slopes_[k].exact, {}, {}, {}};
      difference.coefficients = in_balls(difference.exact, bits);
      if (set_.in_contact(segment)) {
        const Ball factor = Ball(set_.sign(segment)) * set_.cos_alpha(segment);
        for (Ball& c : difference.coefficients) c *= factor;
      }
      differences_[k].push_back(std::move(difference));
    }
    if (!set_.in_contact(segment) || !integrates) continue;
    for (ContactPanel::Part& part : ContactPanel::graded(set_, segment)) {
      panels_[segment].emplace_back(set_, std::move(part), -1, std::nullopt, count_, rules);
    }
    for (std::size_t k = 0; k < slopes_.size(); ++k) {
      if (k == slopes_of_[segment]) continue;
      Difference& difference = differences_[k][segment];
      for (const ContactPanel& panel : panels_[segment]) {
        const Ball size = panel.largest(difference.coefficients, Ellipse::far);
        std::vector<Ball> values;
        Ball mass = panel.remainder(size, Ellipse::far);
        for (const ContactPanel::Node& node : panel.nodes()) {
          values.push_back(node.weight * value_at(difference.coefficients, set_.x(segment) + node.from_left));
          mass += node.weight.at(size.bits()) * size;
        }
        difference.values.push_back(std::move(values));
        difference.masses.push_back(mass / Ball(3));  // 3 < pi
      }
    }
  }
}

Ball ContactForm::series(const std::vector<Ball>& coefficients, int n) const {
  return n < 0 ? Ball(0, set_.bits()) : coefficients[static_cast<std::size_t>(n)];
}

Ball ContactForm::distance(const Place& place, std::size_t j) const {
  return j <= place.segment ? place.from_left + set_.distance(j, place.segment)
                            : place.from_right + set_.distance(place.segment + 1, j);
}

Ball ContactForm::coordinate(const Place& place) const {
  // From the nearer point, whose distance is the thinner one.
  return place.from_left < place.from_right ? set_.x(place.segment) + place.from_left
                                            : set_.x(place.segment + 1) - place.from_right;
}

Ball ContactForm::modulus(const Place& place, std::optional<std::size_t> without) const {
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

LocalValue ContactForm::regular_factor(std::size_t k, const Place& place) const {
  LocalValue sum{Ball(0, set_.bits()), Ball(0, set_.bits()), Ball(0, set_.bits()), Ball(0, set_.bits())};
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    if (set_.in_contact(segment) && slopes_of_[segment] != k) add_cauchy(k, segment, place, sum);
  }
  sum.regular = value_at(slopes_[k].rational, coordinate(place)) - sum.regular / Ball::pi(set_.bits());
  return sum;
}

Ball ContactForm::regular_factor_at_end(std::size_t j) const {
  const bool begins = set_.point(j).kind == ContactTopology::Kind::begins;
  const std::size_t segment = begins ? j : j - 1;
  const Ball zero(0, set_.bits());
  return regular_factor({segment, begins ? zero : set_.length(segment), begins ? set_.length(segment) : zero}).value();
}

void ContactForm::add_cauchy(std::size_t k, std::size_t segment, const Place& place, LocalValue& sum) const {
  const bool to_the_right = segment > place.segment;
  const Difference& difference = differences_[k][segment];
  const Ball to_segment = distance(place, to_the_right ? segment : segment + 1);
  for (std::size_t n = 0; n < panels_[segment].size(); ++n) {
    const ContactPanel& panel = panels_[segment][n];
    const std::vector<Ball>& values = difference.values[n];
    const ContactPanel::Part& part = panel.part();
    const std::optional<Side> facing = to_the_right ? Side::left : Side::right;
    const bool neighbours = to_the_right ? segment == place.segment + 1 : segment + 1 == place.segment;
    if (neighbours && part.touches == facing && Ball(2) * to_segment < part.length) {
      add_beside(panel, difference, values, place, sum);
      continue;
    }
    const Ball to_panel = to_segment + (to_the_right ? part.from_left : part.from_right);
    const Ellipse ellipse =
        to_panel > part.length * Ball(Rational(19, 20), set_.bits()) ? Ellipse::far : Ellipse::close;
    const Ball clear = to_panel.lower() - panel.reach(ellipse);
    Ball part_sum(0, set_.bits());
    for (std::size_t i = 0; i < panel.nodes().size(); ++i) {
      const ContactPanel::Node& node = panel.nodes()[i];
      part_sum += values[i] / (to_segment + (to_the_right ? node.from_left : node.from_right));
    }
    part_sum += error(panel.remainder(panel.largest(difference.coefficients, ellipse) * pole_bound(clear), ellipse));
    sum.regular += to_the_right ? part_sum : -part_sum;
  }
}

void ContactForm::add_beside(const ContactPanel& panel, const Difference& difference, const std::vector<Ball>& values,
                             const Place& place, LocalValue& sum) const {
  const Bits bits = set_.bits();
  const ContactPanel::Part& part = panel.part();
  const bool to_the_right = *part.touches == Side::left;
  const std::size_t c = to_the_right ? part.segment : part.segment + 1;
  const Ball& d = to_the_right ? place.from_right : place.from_left;
  const Ball& a = panel.power();
  const Ball pi = Ball::pi(bits);

  // G(-d) without the zero of order m that it has from g - g_k.
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
  total += error(
      panel.remainder(panel.largest(difference.coefficients, Ellipse::beside) * pole_bound(clear), Ellipse::beside));
  total += error(panel.end_remainder(abs(at_place) * pole_bound(clear), Ellipse::beside));

  // G(-d) I(d), its singular term apart: (-1/pi) of it belongs to B.
  const Ball sign(to_the_right ? 1 : -1, bits);
  // (x - c)^m = (-+1)^m d^m.
  const Ball coefficient = reduced * Ball(to_the_right && m % 2 == 1 ? -1 : 1);
  const Ball upper = d.upper();
  const bool reaches = !d.is_positive();
  sum.has_singular = true;
  if (set_.is_regular(c)) {
    total += at_place * log(part.length + d);
    sum.coefficient = -sign * coefficient / pi;
    const auto term = [&](const Ball& at) { return -log(at) * power(at, m); };
    if (!reaches) {
      sum.singular = term(d);
    } else if (m == 0) {
      sum.singular = Ball::unknown(bits);
      sum.least = term(upper);
    } else {
      // -d^m log d increases from 0 to exp(-1/m) >= 0.36.
      sum.singular =
          upper < Ball(Rational(36, 100), bits) ? Ball::hull(Ball(0, bits), term(upper)) : Ball::unknown(bits);
      sum.least = Ball(0, bits);
    }
  } else {
    const Ball exponent = a + Ball(m, bits);
    sum.coefficient = sign * coefficient / sin(pi * a);
    sum.singular = power(d, exponent);
    sum.least = reaches ? power(upper, exponent) : Ball(0, bits);
    // L^a sum (-d/L)^k/(k - a).
    const Ball ratio = d / part.length;
    const Ball largest_ratio = abs(ratio).upper();
    Ball series(0, bits);
    Ball term(1, bits);
    Ball size(1, bits);
    int k = 0;
    const Ball enough = power(Ball(2, bits), -static_cast<int>(bits));
    do {
      series += term / (Ball(k, bits) - a);
      term *= -ratio;
      size *= largest_ratio;
      ++k;
    } while (!(size < enough));
    series += error(size / ((Ball(k, bits) - abs(a)) * (Ball(1) - largest_ratio)));
    total -= at_place * power(part.length, a) * series;
  }
  sum.regular += sign * total;
}

Ball ContactForm::integral(std::size_t k, std::size_t j) const {
  Ball sum(0, set_.bits());
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    if (!set_.in_contact(segment) || slopes_of_[segment] == k) continue;
    Polynomials polynomial(j, Ball(0, set_.bits()));
    const Polynomials& difference = differences_[k][segment].coefficients;
    polynomial.insert(polynomial.end(), difference.begin(), difference.end());
    for (const ContactPanel& panel : panels_[segment]) {
      for (const ContactPanel::Node& node : panel.nodes()) {
        sum += node.weight * value_at(polynomial, set_.x(segment) + node.from_left);
      }
      sum += error(panel.remainder(panel.largest(polynomial, Ellipse::far), Ellipse::far));
    }
  }
  return sum;
}

Ball ContactForm::moment(std::size_t j) const {
  std::size_t k = slopes_of_[set_.components().front().first];
  Ball sum = -integral(k, j) / Ball::pi(set_.bits());
  const Polynomials& g = slopes_[k].coefficients;
  for (std::size_t m = 0; m < g.size(); ++m) {
    sum += g[m] * series(reciprocal_, static_cast<int>(m) - degree_ + 1 + static_cast<int>(j));
  }
  return sum;
}

Ball ContactForm::second_coefficient() const {
  Ball sum(0, set_.bits());
  for (std::size_t l = 0; l < q_.size(); ++l) {
    sum += q_[l] / Ball::pi(set_.bits()) * series(y_series_, degree_ + static_cast<int>(l) + 2);
  }
  for (int j = 0; j <= degree_ + 1; ++j) {
    sum += moment(static_cast<std::size_t>(j)) * series(y_series_, degree_ + 1 - j);
  }
  return sum;
}

Ball ContactForm::centre_of_pressure() const {
  return second_coefficient() * Ball::pi(set_.bits()) / Ball(set_.problem().load, set_.bits());
}

Ball ContactForm::profile_slope(const Place& place) const {
  return value_at(slopes_[slopes_of_[place.segment]].coefficients, coordinate(place));
}

std::size_t ContactForm::unknowns() const {
  return set_.topology().movable().size() + static_cast<std::size_t>(std::max(-degree_ - 1, 0)) +
         (set_.problem().load_at ? 1 : 0);
}

std::vector<Ball> ContactForm::conditions() const {
  const Ball pi = Ball::pi(set_.bits());
  const Ball load(set_.problem().load, set_.bits());
  std::vector<Ball> result;
  for (int j = 0; j <= degree_; ++j) {
    Ball missing = moment(static_cast<std::size_t>(j));
    if (j == degree_) missing -= load / pi;
    result.push_back(std::move(missing));
  }
  for (const ContactSet::Run& gap : set_.gaps()) result.push_back(gap_condition(gap));
  if (set_.problem().load_at) {
    result.push_back(second_coefficient() - load * Ball(*set_.problem().load_at, set_.bits()) / pi);
  }
  return result;
}

std::vector<std::vector<Ball>> ContactForm::jacobian() const {
  const Bits bits = set_.bits();
  const Ball pi = Ball::pi(bits);
  const std::vector<std::size_t> movable = set_.topology().movable();
  const auto free_coefficients = static_cast<std::size_t>(std::max(-degree_ - 1, 0));
  const bool tilts = set_.problem().load_at.has_value();
  std::vector<std::vector<Ball>> rows;

  std::vector<Ball> residues;  // rho_f for a change of log h
  for (const std::size_t f : movable) {
    residues.push_back(set_.power(f) * regular_factor_at_end(f) * set_.velocity(f));
  }
  std::vector<Ball> moments;
  for (int j = 0; j <= degree_ + (tilts ? 1 : 0); ++j) moments.push_back(moment(static_cast<std::size_t>(j)));

  for (int j = 0; j <= degree_; ++j) {
    std::vector<Ball> row;
    for (std::size_t f = 0; f < movable.size(); ++f) {
      const Ball& e = set_.x(movable[f]);
      Ball entry = residues[f] * power(e, j);
      for (int i = 0; i < j; ++i) {
        entry += set_.power(movable[f]) * set_.velocity(movable[f]) * moments[static_cast<std::size_t>(i)] *
                 power(e, j - 1 - i);
      }
      row.push_back(std::move(entry));
    }
    if (tilts) row.push_back(series(reciprocal_, 1 + j - degree_));
    rows.push_back(std::move(row));
  }

  for (const ContactSet::Run& gap : set_.gaps()) rows.push_back(gap_derivatives(gap, residues));

  if (tilts) {
    std::vector<Ball> row;
    for (std::size_t f = 0; f < movable.size(); ++f) {
      const Ball& e = set_.x(movable[f]);
      Ball entry(0, bits);
      for (int i = 0; i <= degree_ + 1; ++i) entry += residues[f] * power(e, i) * series(y_series_, degree_ + 1 - i);
      const Polynomials r = quotient(q_, e);
      for (std::size_t l = 0; l < r.size(); ++l) {
        entry -= set_.power(movable[f]) * set_.velocity(movable[f]) * r[l] / pi *
                 series(y_series_, degree_ + static_cast<int>(l) + 2);
      }
      row.push_back(std::move(entry));
    }
    for (std::size_t l = 0; l < free_coefficients; ++l) {
      row.push_back(series(y_series_, degree_ + static_cast<int>(l) + 2) / pi);
    }
    Ball entry(0, bits);
    for (int j = 0; j <= degree_ + 1; ++j) {
      entry += series(reciprocal_, 1 + j - degree_) * series(y_series_, degree_ + 1 - j);
    }
    row.push_back(std::move(entry));
    rows.push_back(std::move(row));
  }
  return rows;
}

namespace {

struct GapPart {
  std::size_t segment;
  ContactPanel::Extent extent;
  std::size_t contact;  ///< the segment in contact whose polynomial is used
};

/// Next to either end B_k takes the polynomial of the contact there, with which it is analytic up to that end.
std::vector<GapPart> parts_of(const ContactSet::Run& gap) {
  using Extent = ContactPanel::Extent;
  if (gap.first == gap.last) {
    return {{gap.first, Extent::left_half, gap.first - 1}, {gap.first, Extent::right_half, gap.last + 1}};
  }
  std::vector<GapPart> parts;
  for (std::size_t k = gap.first; k <= gap.last; ++k) {
    parts.push_back({k, Extent::whole, k < gap.last ? gap.first - 1 : gap.last + 1});
  }
  return parts;
}

}  // namespace

Ball ContactForm::bound(std::size_t k, const ContactPanel& panel, Ellipse ellipse,
                        std::optional<std::size_t> without) const {
  Ball sum = panel.largest(slopes_[k].rational, ellipse);
  const std::size_t at = panel.part().segment;
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    if (!set_.in_contact(segment) || slopes_of_[segment] == k || without == segment) continue;
    const bool to_the_right = segment > at;
    const Ball clear = (to_the_right ? set_.distance(at + 1, segment) + panel.part().from_right
                                     : set_.distance(segment + 1, at) + panel.part().from_left)
                           .at(sum.bits()) -
                       panel.reach(ellipse);
    for (const Ball& mass : differences_[k][segment].masses) sum += mass * pole_bound(clear);
  }
  return sum;
}

bool ContactForm::changes_polynomial(std::size_t j) const {
  return j > 0 && j < set_.segments() && set_.in_contact(j - 1) && set_.in_contact(j) &&
         slopes_of_[j - 1] != slopes_of_[j];
}

const ContactPanel& ContactForm::facing_panel(std::size_t c, std::size_t segment) const {
  return segment < c ? panels_[c].front() : panels_[c - 1].back();
}

Ball ContactForm::bound_beside(std::size_t c, const ContactPanel& panel) const {
  // With y, z in the ellipse E of the panel on the other side, of length D: the quotient of differences is at most
  // 2 max |G|/(their distance from E's boundary). |z| <= 9/20 D puts them into the confocal ellipse with the larger
  // semi-axis 19/10 D/2, and two of these are as far apart as their larger semi-axes differ.
  const std::size_t segment = panel.part().segment;
  const std::size_t k = slopes_of_[segment];
  const std::size_t other = segment < c ? c : c - 1;
  const ContactPanel& facing = facing_panel(c, segment);
  const Difference& difference = differences_[k][other];
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
  Ball sum = bound(k, panel, Ellipse::far, other) + largest * rest / Ball(3);
  for (std::size_t n = 0; n < panels_[other].size(); ++n) {
    const ContactPanel& beyond = panels_[other][n];
    if (&beyond == &facing) continue;
    const Ball clear =
        (segment < c ? beyond.part().from_left : beyond.part().from_right).at(bits) - panel.reach(Ellipse::far);
    sum += difference.masses[n] * pole_bound(clear);
  }
  return sum;
}

Ball ContactForm::singular_load(std::size_t c, std::size_t segment, const Ball& length) const {
  const std::size_t k = slopes_of_[segment];
  const std::size_t other = segment < c ? c : c - 1;
  Polynomials around = shifted(differences_[k][other].coefficients, set_.x(c));
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

Ball ContactForm::load_on(std::size_t segment) const {
  const Bits bits = set_.bits();
  const std::size_t k = slopes_of_[segment];
  Ball sum(0, bits);  // of |Y| B, and apart from it the singular terms
  Ball singular(0, bits);
  const auto add = [&](ContactPanel::Part part, std::optional<std::size_t> c) {
    const ContactPanel panel(set_, std::move(part), 1, std::nullopt, count_, *rules_);
    for (const ContactPanel::Node& node : panel.nodes()) {
      const LocalValue b = regular_factor(k, {segment, node.from_left, node.from_right});
      sum += node.weight * (c ? b.regular : b.value());
    }
    sum += error(panel.remainder(c ? bound_beside(*c, panel) : bound(k, panel, Ellipse::far), Ellipse::far));
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

Ball ContactForm::gap_condition(const ContactSet::Run& gap) const {
  Ball sum(0, set_.bits());
  for (std::size_t j = gap.first; j <= gap.last + 1; ++j) {
    if (!set_.point(j).beside) sum += Ball(set_.problem().anchors[set_.point(j).anchor].step, set_.bits());
  }
  for (const GapPart& part : parts_of(gap)) {
    const std::size_t k = slopes_of_[part.contact];
    const Ball sign(set_.sign(part.segment));
    for (ContactPanel::Part& piece : ContactPanel::graded(set_, part.segment, part.extent)) {
      sum += integral_over(differences_[k][part.segment].coefficients, set_.x(part.segment) + piece.from_left,
                           piece.length);
      const ContactPanel panel(set_, std::move(piece), 1, std::nullopt, count_, *rules_);
      for (const ContactPanel::Node& node : panel.nodes()) {
        sum += sign * node.weight * regular_factor(k, {part.segment, node.from_left, node.from_right}).value();
      }
      sum += error(panel.remainder(bound(k, panel, Ellipse::far), Ellipse::far));
    }
  }
  return sum;
}

std::vector<Ball> ContactForm::gap_derivatives(const ContactSet::Run& gap, const std::vector<Ball>& residues) const {
  const Bits bits = set_.bits();
  const Ball pi = Ball::pi(bits);
  const std::vector<std::size_t> movable = set_.topology().movable();
  const auto free_coefficients = static_cast<std::size_t>(std::max(-degree_ - 1, 0));

  // What multiplies Y in the derivative of profile slope - u'/c, but for the poles.
  std::vector<Polynomials> polynomials;
  for (const std::size_t f : movable) {
    Polynomials r = quotient(q_, set_.x(f));
    for (Ball& c : r) c *= set_.power(f) * set_.velocity(f) / pi;
    polynomials.push_back(std::move(r));
  }
  for (std::size_t l = 0; l < free_coefficients; ++l) {
    polynomials.emplace_back(l + 1, Ball(0, bits));
    polynomials.back()[l] = -Ball(1) / pi;
  }
  if (set_.problem().load_at) {
    polynomials.emplace_back();
    for (int i = 0; i <= -degree_; ++i) polynomials.back().push_back(series(reciprocal_, -degree_ - i));
  }

  std::vector<Ball> row(polynomials.size(), Ball(0, bits));
  for (std::size_t segment = gap.first; segment <= gap.last; ++segment) {
    const Ball sign(set_.sign(segment));
    for (ContactPanel::Part& piece : ContactPanel::graded(set_, segment)) {
      const ContactPanel panel(set_, piece, 1, std::nullopt, count_, *rules_);
      const auto pole_distance = [&](std::size_t f, const Ball& from_left, const Ball& from_right) {
        return f <= segment ? from_left + set_.distance(f, segment) : -(from_right + set_.distance(segment + 1, f));
      };
      for (std::size_t i = 0; i < polynomials.size(); ++i) {
        for (const ContactPanel::Node& node : panel.nodes()) {
          row[i] += sign * node.weight * value_at(polynomials[i], set_.x(segment) + node.from_left);
        }
        row[i] += error(panel.remainder(panel.largest(polynomials[i], Ellipse::far), Ellipse::far));
      }
      for (std::size_t i = 0; i < movable.size(); ++i) {
        const std::size_t f = movable[i];
        if (f == gap.first || f == gap.last + 1) {
          const ContactPanel lowered(set_, piece, 1, f, count_, *rules_);
          const Ball direction(f == gap.first ? 1 : -1);
          for (const ContactPanel::Node& node : lowered.nodes()) {
            row[i] -= sign * direction * residues[i] * node.weight;
          }
          row[i] += error(lowered.remainder(abs(residues[i]), Ellipse::far));
        } else {
          for (const ContactPanel::Node& node : panel.nodes()) {
            row[i] -= sign * residues[i] * node.weight / pole_distance(f, node.from_left, node.from_right);
          }
          const Ball clear = (f <= segment ? piece.from_left + set_.distance(f, segment)
                                           : piece.from_right + set_.distance(segment + 1, f)) -
                             panel.reach(Ellipse::close);
          row[i] += error(panel.remainder(abs(residues[i]) * pole_bound(clear), Ellipse::close));
        }
      }
    }
  }
  return row;
}

}  // namespace steadyslide::enclosure
