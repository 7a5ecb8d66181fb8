#include "enclosure/contact/contact_conditions.hpp"

namespace steadyslide::enclosure {

namespace {

struct SegmentPart {
  std::size_t segment;
  ContactPanel::Extent extent;
  std::size_t contact;  ///< the segment in contact whose polynomial is used
};

/// Next to each end, B_k uses the polynomial of the contact there, with which it is analytic up to that end.
std::vector<SegmentPart> parts_of(const ContactSet::Run& gap) {
  using Extent = ContactPanel::Extent;
  if (gap.first == gap.last) {
    return {{gap.first, Extent::left_half, gap.first - 1}, {gap.first, Extent::right_half, gap.last + 1}};
  }
  std::vector<SegmentPart> parts;
  for (std::size_t k = gap.first; k <= gap.last; ++k) {
    parts.push_back({k, Extent::whole, k < gap.last ? gap.first - 1 : gap.last + 1});
  }
  return parts;
}

}  // namespace

Ball ContactConditions::integral(std::size_t k, std::size_t j) const {
  Ball sum(0, set_.bits());
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    if (!set_.in_contact(segment) || form_.slope_of(segment) == k) continue;
    BallPolynomial polynomial(j, Ball(0, set_.bits()));
    const BallPolynomial& difference = form_.difference(k, segment).coefficients;
    polynomial.insert(polynomial.end(), difference.begin(), difference.end());
    for (const ContactPanel& panel : form_.panels(segment)) {
      const auto term = [&](const ContactPanel::Node& node) {
        return node.weight * value_at(polynomial, set_.x(segment) + node.from_left);
      };
      panel.add_sum(sum, term, panel.remainder(panel.largest(polynomial, Ellipse::far), Ellipse::far));
    }
  }
  return sum;
}

Ball ContactConditions::moment(std::size_t j) const {
  std::size_t k = form_.slope_of(set_.components().front().first);
  Ball sum = -integral(k, j) / Ball::pi(set_.bits());
  const BallPolynomial& g = form_.slope(k).coefficients;
  for (std::size_t m = 0; m < g.size(); ++m) {
    sum += g[m] * form_.reciprocal(static_cast<int>(m) - degree_ + 1 + static_cast<int>(j));
  }
  return sum;
}

Ball ContactConditions::second_coefficient() const {
  Ball sum(0, set_.bits());
  for (std::size_t l = 0; l < q_.size(); ++l) {
    sum += q_[l] / Ball::pi(set_.bits()) * form_.expansion(degree_ + static_cast<int>(l) + 2);
  }
  for (int j = 0; j <= degree_ + 1; ++j) {
    sum += moment(static_cast<std::size_t>(j)) * form_.expansion(degree_ + 1 - j);
  }
  return sum;
}

Ball ContactConditions::centre_of_pressure() const {
  return second_coefficient() * Ball::pi(set_.bits()) / set_.loads();
}

std::size_t ContactConditions::unknowns() const {
  return movable_.size() + free_coefficients_ + (set_.problem().load_at ? 1 : 0);
}

std::int64_t ContactConditions::work() const {
  std::size_t panels = 1;
  for (const ContactSet::Run& gap : set_.gaps()) {
    for (const SegmentPart& part : parts_of(gap)) {
      panels += ContactPanel::graded(set_, part.segment, part.extent).size();
    }
  }
  // In sums over distant segments each term needs fewer bits than the one before; on average half of the bits.
  return static_cast<std::int64_t>(panels) * form_.count() * form_.work_of_place() / 2 + form_.work_of_panels();
}

std::vector<Ball> ContactConditions::conditions() const {
  const Ball pi = Ball::pi(set_.bits());
  const Ball load = set_.loads();
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

std::vector<std::vector<Ball>> ContactConditions::jacobian() const {
  const Bits bits = set_.bits();
  const Ball pi = Ball::pi(bits);
  const bool tilts = set_.problem().load_at.has_value();
  std::vector<std::vector<Ball>> rows;

  std::vector<Ball> rates, residues;  // p_f and rho_f for a change of log h
  for (const std::size_t f : movable_) {
    rates.push_back(set_.power(f) * set_.velocity(f));
    residues.push_back(set_.power(f) * form_.regular_factor_at_end(f) * set_.velocity(f));
  }
  std::vector<Ball> moments;
  for (int j = 0; j <= degree_ + (tilts ? 1 : 0); ++j) moments.push_back(moment(static_cast<std::size_t>(j)));

  for (int j = 0; j <= degree_; ++j) {
    std::vector<Ball> row;
    for (std::size_t f = 0; f < movable_.size(); ++f) {
      const Ball& e = set_.x(movable_[f]);
      Ball entry = residues[f] * power(e, j);
      for (int i = 0; i < j; ++i) {
        entry += rates[f] * moments[static_cast<std::size_t>(i)] * power(e, j - 1 - i);
      }
      row.push_back(std::move(entry));
    }
    if (tilts) row.push_back(form_.reciprocal(1 + j - degree_));
    row.push_back(j == degree_ ? -Ball(1) / pi : Ball(0, bits));
    rows.push_back(std::move(row));
  }

  for (const ContactSet::Run& gap : set_.gaps()) rows.push_back(gap_derivatives(gap, residues));

  if (tilts) {
    std::vector<Ball> row;
    for (std::size_t f = 0; f < movable_.size(); ++f) {
      const Ball& e = set_.x(movable_[f]);
      Ball entry(0, bits);
      for (int i = 0; i <= degree_ + 1; ++i) entry += residues[f] * power(e, i) * form_.expansion(degree_ + 1 - i);
      const BallPolynomial r = quotient(q_, e);
      for (std::size_t l = 0; l < r.size(); ++l) {
        entry -= rates[f] * r[l] / pi * form_.expansion(degree_ + static_cast<int>(l) + 2);
      }
      row.push_back(std::move(entry));
    }
    for (std::size_t l = 0; l < free_coefficients_; ++l) {
      row.push_back(form_.expansion(degree_ + static_cast<int>(l) + 2) / pi);
    }
    Ball entry(0, bits);
    for (int j = 0; j <= degree_ + 1; ++j) {
      entry += form_.reciprocal(1 + j - degree_) * form_.expansion(degree_ + 1 - j);
    }
    row.push_back(std::move(entry));
    Ball by_load = -Ball(*set_.problem().load_at, bits);
    if (degree_ < 0) by_load += form_.expansion(1);
    row.push_back(by_load / pi);
    rows.push_back(std::move(row));
  }
  return rows;
}

Ball ContactConditions::gap_condition(const ContactSet::Run& gap) const {
  Ball sum(0, set_.bits());
  for (std::size_t j = gap.first; j <= gap.last + 1; ++j) sum += set_.step(j);
  for (const SegmentPart& part : parts_of(gap)) {
    const std::size_t k = form_.slope_of(part.contact);
    const std::vector<ContactPanel::Interval> pieces = ContactPanel::graded(set_, part.segment, part.extent);
    if (2 * static_cast<Bits>(pieces.size()) * form_.count() > set_.bits()) form_.prepare(k, part.segment);
    for (const ContactPanel::Interval& piece : pieces) {
      sum += form_.gap_change(piece, k);
    }
  }
  return sum;
}

Ball ContactConditions::gap_at(const SurfacePoint& place) const {
  std::size_t first = place.segment;
  std::size_t last = place.segment;
  while (first > 0 && !set_.in_contact(first - 1)) --first;
  while (last + 1 < set_.segments() && !set_.in_contact(last + 1)) ++last;
  const bool from_left = first > 0;
  const bool from_right = last + 1 < set_.segments();
  if (!from_left && !from_right) return Ball::unknown(set_.bits());
  const Ball to_left = place.from_left + set_.distance(first, place.segment);
  const Ball to_right = place.from_right + set_.distance(place.segment + 1, last + 1);
  const bool left = from_left && (!from_right || to_left.midpoint() <= to_right.midpoint());

  const std::size_t k = form_.slope_of(left ? first - 1 : last + 1);
  // Integrates over parts of segments outside the contact, from left to right.
  const auto change = [&](const std::vector<ContactPanel::Interval>& parts) {
    Ball sum(0, set_.bits());
    for (const ContactPanel::Interval& part : parts) sum += form_.gap_change(part, k);
    return sum;
  };
  Ball sum = left ? set_.step(first) : -set_.step(last + 1);
  for (std::size_t m = left ? first : last; m != place.segment; left ? ++m : --m) {
    const Ball risen = change(ContactPanel::graded(set_, m));
    sum += left ? risen + set_.step(m + 1) : -risen - set_.step(m);
  }
  const bool whole = (left ? place.from_right : place.from_left).is_zero();
  const ContactPanel::DistanceRange range{Ball(0, set_.bits()), left ? place.from_left : place.from_right};
  const Ball risen = change(whole ? ContactPanel::graded(set_, place.segment)
                                  : ContactPanel::outward(set_, place.segment, left ? Side::left : Side::right, range));
  return left ? sum + risen : sum - risen;
}

std::vector<Ball> ContactConditions::gap_derivatives(const ContactSet::Run& gap,
                                                     const std::vector<Ball>& residues) const {
  const Bits bits = set_.bits();
  const Ball pi = Ball::pi(bits);
  // The factors of Y in the derivative of profile slope - u'/c, without the poles.
  std::vector<BallPolynomial> polynomials;
  for (const std::size_t f : movable_) {
    BallPolynomial r = quotient(q_, set_.x(f));
    for (Ball& c : r) c *= set_.power(f) * set_.velocity(f) / pi;
    polynomials.push_back(std::move(r));
  }
  const auto coefficient_of_q = [&](std::size_t l) {
    BallPolynomial polynomial(l + 1, Ball(0, bits));
    polynomial[l] = -Ball(1) / pi;
    return polynomial;
  };
  for (std::size_t l = 0; l < free_coefficients_; ++l) polynomials.push_back(coefficient_of_q(l));
  if (set_.problem().load_at) {
    polynomials.emplace_back();
    for (int i = 0; i <= -degree_; ++i) polynomials.back().push_back(form_.reciprocal(-degree_ - i));
  }
  // The load is the leading coefficient of q, or it is in the moments.
  polynomials.push_back(degree_ < 0 ? coefficient_of_q(free_coefficients_) : BallPolynomial{Ball(0, bits)});

  std::vector<Ball> row(polynomials.size(), Ball(0, bits));
  for (std::size_t segment = gap.first; segment <= gap.last; ++segment) {
    const Ball sign(set_.sign(segment));
    for (ContactPanel::Interval& piece : ContactPanel::graded(set_, segment)) {
      const ContactPanel panel = form_.panel(piece);
      for (std::size_t i = 0; i < polynomials.size(); ++i) {
        const auto term = [&](const ContactPanel::Node& node) {
          return sign * node.weight * value_at(polynomials[i], set_.x(segment) + node.from_left);
        };
        panel.add_sum(row[i], term, panel.remainder(panel.largest(polynomials[i], Ellipse::far), Ellipse::far));
      }
      for (std::size_t i = 0; i < movable_.size(); ++i) {
        const std::size_t f = movable_[i];
        if (f == gap.first || f == gap.last + 1) {
          const ContactPanel lowered = form_.panel(piece, f);
          const Ball direction(f == gap.first ? 1 : -1);
          const auto term = [&](const ContactPanel::Node& node) {
            return -(sign * direction * residues[i] * node.weight);
          };
          lowered.add_sum(row[i], term, lowered.remainder(abs(residues[i]), Ellipse::far));
        } else {
          const bool on_left = f <= segment;
          const auto distance_from = [&](const auto& place) {
            return on_left ? place.from_left + set_.distance(f, segment)
                           : place.from_right + set_.distance(segment + 1, f);
          };
          const auto term = [&](const ContactPanel::Node& node) {
            return -(sign * residues[i] * node.weight / (on_left ? distance_from(node) : -distance_from(node)));
          };
          const Ball clear = distance_from(piece) - panel.reach(Ellipse::close);
          panel.add_sum(row[i], term, panel.remainder(abs(residues[i]) * pole_bound(clear), Ellipse::close));
        }
      }
    }
  }
  return row;
}

}  // namespace steadyslide::enclosure
