#include "checker/signs.hpp"

#include <algorithm>
#include <cmath>

#include "checker/conditions.hpp"
#include "checker/failure.hpp"
#include "checker/interpolant.hpp"

namespace steadyslide::checker {
namespace {

using Kind = LayoutPoint::Contact;

constexpr std::size_t most_intervals = 20000;
constexpr int most_halvings = 400;

/// Returns 0 if x is certainly at most 0; otherwise x, also for NaN.
Ball positive_part(const Ball& x) { return arb_is_nonpositive(x.get()) != 0 ? Ball() : x; }

/// Returns a distance between u and v: far below v if u is 0; otherwise their mean, the geometric mean if they differ
/// in size.
Ball between(const Ball& u, const Ball& v) {
  if (u.is_zero()) return (v * Ball(0.25)).middle();
  return ((v - Ball(4) * u).is_positive() ? sqrt(u * v) : (u + v) * Ball(0.5)).middle();
}

/// The half of a segment at its point `base`, with places at the distance d from this point.
class HalfSegment {
 public:
  HalfSegment(const Contact& contact, std::size_t segment, bool from_left)
      : contact_(&contact), segment_(segment), from_left_(from_left), length_(contact.length(segment)) {}

  std::size_t segment() const { return segment_; }
  std::size_t base() const { return from_left_ ? segment_ : segment_ + 1; }
  Ball half() const { return length_ * Ball(0.5); }
  /// Returns dx/dd.
  Ball orientation() const { return from_left_ ? 1 : -1; }
  SurfacePoint at(const Ball& d) const {
    return from_left_ ? SurfacePoint{segment_, segment_ + 1, d, length_ - d}
                      : SurfacePoint{segment_, segment_ + 1, length_ - d, d};
  }
  /// Returns the left end of u <= d <= v.
  SurfacePoint leftmost(const Ball& u, const Ball& v) const { return at(from_left_ ? u : v); }
  /// Returns int (g - g_k) dx over u <= d <= v.
  Ball slope_difference(std::size_t k, const Ball& u, const Ball& v) const {
    return from_left_ ? checker::slope_difference(*contact_, segment_, k, u, v)
                      : checker::slope_difference(*contact_, segment_, k, length_ - v, length_ - u);
  }
  std::string name(const Ball& d) const {
    const ReducedProblem& problem = contact_->problem();
    const Ball x = Ball(problem.origin, 128) + Ball(problem.unit, 128) * contact_->xi(at(d));
    return "x = " + x.middle().text(8);
  }

 private:
  const Contact* contact_;
  std::size_t segment_;
  bool from_left_;
  Ball length_;
};

class Prover {
 public:
  explicit Prover(const TractionRepresentation& form) : form_(form), contact_(form.contact()) {
    result_.bits = form.bits();
  }

  Signs run() {
    for (std::size_t j = 0; j < contact_.points(); ++j) check_anchor(j);
    for (std::size_t i = 0; i < contact_.segments(); ++i) {
      if (!contact_.in_contact(i)) continue;
      for (const bool from_left : {true, false}) {
        const HalfSegment half(contact_, i, from_left);
        Ball start;
        if (contact_.changes_slope(half.base())) {
          check_local_form(half);
          start = form_.reach(half.base());
        }
        check_contact(half, start, half.half(), 0);
      }
    }
    for (const std::size_t j : contact_.layout().all(Kind::ends)) check_gap(j, 1);
    for (const std::size_t j : contact_.layout().all(Kind::begins)) check_gap(j, -1);
    return result_;
  }

 private:
  const Rational& step(std::size_t j) const { return contact_.problem().steps[contact_.layout().points[j].anchor]; }

  /// Refuses contact and ends of contact at anchors where they are impossible for any values of the unknowns.
  void check_anchor(std::size_t j) const {
    const LayoutPoint& point = contact_.layout().points[j];
    if (point.is_free()) return;
    const std::string at = "at x = " + contact_.problem().places[point.anchor].text();
    if (point.contact == Kind::interior && step(j).sign() != 0) {
      throw Refuted(at + ": contact over a step of the profile");
    }
    const bool at_support_end = j == 0 || j + 1 == contact_.points();
    const int protrudes = point.contact == Kind::ends ? 1 : -1;
    if (point.is_end() && !at_support_end && step(j).sign() != protrudes) {
      throw Refuted(at + ": contact ends at an edge where the indenter has none");
    }
  }

  void count(std::size_t& intervals, const HalfSegment& half, const Ball& u, int depth, const std::string& sign) const {
    if (++intervals > most_intervals || depth > most_halvings)
      throw Unproved(sign + " is not decided near " + half.name(u));
  }

  /// Returns B_k on u <= d <= v.
  Ball values(const HalfSegment& half, std::size_t k, const Ball& u, const Ball& v) const {
    const auto interpolant = Interpolant::of(form_, form_.bits(), k, half.leftmost(u, v), v - u);
    return interpolant ? interpolant->range() : form_.regular_to(form_.bits(), k, half.at(hull(u, v))).value;
  }

  /// Checks eps B < 0 for u <= d <= v.
  void check_contact(const HalfSegment& half, const Ball& u, const Ball& v, int depth) {
    count(result_.in_contact, half, u, depth, "t < 0");
    const std::size_t k = contact_.slope_of(half.segment());
    const Ball eps(contact_.sign(half.segment()));
    if ((eps * values(half, k, u, v)).is_negative()) return;
    const Ball middle = ((u + v) * Ball(0.5)).middle();
    const Ball centre = form_.regular_to(form_.bits(), k, half.at(middle)).value;
    if ((eps * centre).is_positive()) throw Refuted("t > 0: the contact pulls at " + half.name(middle));
    const Ball w = between(u, v);
    check_contact(half, u, w, depth + 1);
    check_contact(half, w, v, depth + 1);
  }

  /// Checks t < 0 for 0 < d <= d1 beside an anchor where the polynomial changes.
  void check_local_form(const HalfSegment& half) {
    const std::size_t c = half.base();
    const std::size_t here = half.segment();
    const std::size_t near = here == c ? c - 1 : c;
    const std::size_t anchor = contact_.layout().points[c].anchor;
    const std::size_t k = contact_.slope_of(here);
    const slong precision = contact_.precision();
    const Ball pi = Ball::pi(precision);
    const Ball d1 = form_.reach(c);
    const Ball beside = hull(Ball(), d1);
    const Ball side = half.orientation();
    const Ball eps(contact_.sign(here));

    // D, or D/d if D(c) = 0.
    std::vector<Ball> D = form_.difference(contact_.slope_of(c), contact_.slope_of(c - 1), anchor);
    const bool vanishes = D.at(0).is_zero();
    const Rational jump = contact_.s(c) - contact_.s(c - 1);
    const Ball s(contact_.s(c), precision);
    const Ball divisor = jump.sign() != 0 ? Ball(jump, precision) : pi * (Ball(1) + s * s);
    const auto amplitude = [&](const Ball& d) {
      return horner(D, side * d) / (divisor * eps * contact_.cosine(here) * contact_.modulus(half.at(d), c));
    };
    const Ball a = -contact_.power_at(c);
    const Ball singular = jump.sign() != 0 ? exp(a * log(d1)) : log(d1);
    const Ball R1 = form_.regular(k, half.at(d1)).value - amplitude(d1) * singular;
    const Ball R = eps * R1.widened(d1 * slope_of_regular_part(half, near, d1));

    // The range of the singular function phi of d is from 0 or infinity to phi(d1). Its term is S phi.
    bool blows_up = jump.sign() < 0 || jump.sign() == 0;
    Ball phi = singular;
    if (vanishes) {
      D.erase(D.begin());
      for (Ball& coefficient : D) coefficient *= side;
      blows_up = false;
      phi *= d1;
      if (!(Ball(0.25) - d1).is_positive()) throw Unproved("an anchor's neighbourhood is too wide for its local form");
    }
    const Ball S = eps * amplitude(beside) * (jump.sign() == 0 && blows_up ? Ball(-1) : Ball(1));
    if (jump.sign() == 0 && blows_up) phi = -phi;
    const Ball& leading = blows_up ? S : R;
    const std::string at = "at x = " + contact_.problem().places[anchor].text() + ": ";
    const Ball rest = contact_.modulus(half.at(Ball()), c);
    const std::string name = blows_up ? (jump.sign() != 0 ? "D/[s] < 0" : "D > 0") : "theta > 0";
    if (!leading.is_negative()) {
      const Ball theta = -rest * R;
      const Ball constant = rest * contact_.cosine(here) * S;
      const std::string number = (blows_up ? constant : theta).text();
      if (leading.is_positive()) throw Refuted(at + name + " fails, the leading term pulls; it is " + number);
      throw Unproved(at + name + " is not decided; it is " + number);
    }
    if (!negative_between(R, S, phi, blows_up)) {
      throw Unproved(at + "t < 0 is not decided where " + name + " no longer leads, at distance " + d1.text());
    }
    ++result_.in_contact;
  }

  /// Returns a bound of |R'| on 0 <= d <= d1.
  Ball slope_of_regular_part(const HalfSegment& half, std::size_t near, const Ball& d1) const {
    const std::size_t c = half.base();
    const std::size_t k = contact_.slope_of(half.segment());
    const slong precision = contact_.precision();
    const Ball pi = Ball::pi(precision);
    const Ball r = d1 * Ball(std::ldexp(1.0, static_cast<int>(form_.bits())));
    const TractionRepresentation::Integral& integral = form_.integral(near);
    Ball weights;
    for (const Trapezoid::Node& node : integral.rule.nodes()) {
      weights += node.weight / ((near == c ? node.u : node.v) + r);
    }
    const Ball turned = Ball(3) * power(sqrt(Ball(2).rounded(precision)), integral.rule.kappa()) * integral.bounds[k] *
                        Trapezoid::integral_bound(weights);

    const std::size_t anchor = contact_.layout().points[c].anchor;
    const std::vector<Ball> D = form_.difference(contact_.slope_of(c), contact_.slope_of(c - 1), anchor);
    Ball powers;
    for (std::size_t j = 0; j < contact_.points(); ++j) {
      if (j != c) powers += contact_.power_at(j).size();
    }
    const Ball G =
        bound_near(D, Ball(), r) * power(Ball(2).rounded(precision), powers) / contact_.modulus(half.at(Ball()), c);
    const Ball a = -contact_.power_at(c);
    // Not finite if a friction jump is too small for the precision.
    const Ball singular = a.is_zero() ? log(r).size() + pi : (pi / sin(pi * a)).size() * exp(a * log(r));
    const Ball M = turned + contact_.cosine(near) / pi * G * singular;
    const Ball others = form_.regular(k, half.at(hull(Ball(), d1)), near).slope;
    const Ball rest = r - d1;
    return others.size() + (M * r / (rest * rest)).size();
  }

  /// Checks the gap from an end of contact in one direction.
  void check_gap(std::size_t origin, int direction) {
    const std::size_t end = direction > 0 ? contact_.points() - 1 : 0;
    if (origin == end) return;
    // If contact begins again, the other half of the gap is checked from there.
    const Kind opposite = direction > 0 ? Kind::begins : Kind::ends;
    std::size_t stop = origin;
    do stop = direction > 0 ? stop + 1 : stop - 1;
    while (stop != end && contact_.layout().points[stop].contact != opposite);
    const bool closes = contact_.layout().points[stop].contact == opposite;
    const std::size_t cut = closes ? longest_segment(contact_, std::min(origin, stop), std::max(origin, stop)) : none;

    k_ = contact_.slope_of(direction > 0 ? origin - 1 : origin);
    origin_ = origin;
    direction_ = Ball(direction);
    gap_ = Ball();
    exact_ = true;
    for (std::size_t j = origin; j != stop; j = direction > 0 ? j + 1 : j - 1) {
      const std::size_t segment = direction > 0 ? j : j - 1;
      if (!contact_.layout().points[j].is_free()) gap_ += direction_ * Ball(step(j), contact_.precision());
      const HalfSegment near(contact_, segment, direction > 0);
      grow(near, true, Ball(), near.half(), 0);
      if (segment == cut) return;
      const HalfSegment far(contact_, segment, direction < 0);
      grow(far, false, Ball(), far.half(), 0);
    }
  }

  /// Updates gap_, which encloses the gap, over u <= d <= v: away from the base if `outwards`, otherwise towards it.
  void grow(const HalfSegment& half, bool outwards, const Ball& u, const Ball& v, int depth) {
    count(result_.in_gaps, half, u, depth, "gap > 0");
    const std::size_t base = half.base() == origin_ ? origin_ : none;
    const Ball p = base == origin_ ? contact_.power_at(origin_) : Ball();
    const SurfacePoint all = half.at(hull(u, v));
    const Ball sign = direction_ * Ball(contact_.sign(half.segment()));
    const Ball f = sign * contact_.modulus(all, base) * values(half, k_, u, v);
    const Ball weight = (power(v, p + Ball(1)) - power(u, p + Ball(1))) / (p + Ball(1));
    // (g - g_k) on the cell.
    const std::size_t own = contact_.slope_of(half.segment());
    const std::size_t anchor = contact_.layout().points[half.segment()].anchor;
    const Ball h = own == k_ ? Ball()
                             : direction_ * horner(form_.difference(own, k_, anchor),
                                                   contact_.offset(half.segment()) + all.from_left);
    const Ball change = f * weight + direction_ * half.slope_difference(k_, u, v);
    // Away from the origin the slope is f + h, and the two terms may cancel.
    const Ball fall = base == none ? (v - u) * positive_part((-(f + h)).upper())
                                   : weight * positive_part((-f).upper()) + (v - u) * positive_part((-h).upper());
    // A gap of 0 opens if it increases. Otherwise the gap minus its largest decrease must be positive.
    const bool opens = gap_.is_zero() && u.is_zero() && outwards && own == k_ && f.is_positive();
    const auto decides = [&](const Ball& gap) {
      return (opens || (gap - fall).is_positive()) && (gap + change).is_positive();
    };
    // Each cell adds the width of its intervals. If this width prevents the decision, all cells are integrated again.
    if (!decides(gap_) && !exact_ && decides(gap_.upper())) {
      gap_ = gap_at(form_, origin_, half.at(outwards ? u : v));
      exact_ = true;
      if (!gap_.is_positive()) throw Unproved("gap > 0 is not decided near " + half.name(outwards ? u : v));
    }
    const Ball after = gap_ + change;
    if (after.is_negative()) throw Refuted("gap < 0: the surface overlaps at " + half.name(outwards ? v : u));
    if (decides(gap_)) {
      gap_ = after;
      exact_ = false;
      return;
    }
    const Ball w = between(u, v);
    grow(half, outwards, outwards ? u : w, outwards ? w : v, depth + 1);
    grow(half, outwards, outwards ? w : u, outwards ? v : w, depth + 1);
  }

  const TractionRepresentation& form_;
  const Contact& contact_;
  Signs result_;
  // State of the current gap.
  std::size_t k_ = 0;
  std::size_t origin_ = 0;
  Ball direction_;
  Ball gap_;
  bool exact_ = true;  ///< true if no interval has widened gap_ since the last integration
};

}  // namespace

bool negative_between(const Ball& R, const Ball& S, const Ball& phi1, bool to_infinity) {
  return (to_infinity ? S : R).is_negative() && (R + S * phi1).is_negative();
}

Signs prove_signs(const ReducedProblem& problem, const Box& box, slong bits) {
  for (slong tried = 24;; tried *= 2) {
    try {
      const Contact contact(problem, box.layout, box.V.log_offsets, 3 * tried + 64);
      return Prover(TractionRepresentation(contact, box.V, box.loads, tried)).run();
    } catch (const Refuted&) {
      throw;
    } catch (const Unproved&) {
      if (tried >= std::max<slong>(192, bits)) throw;
    }
  }
}

}  // namespace steadyslide::checker
