#include "checker/periodic.hpp"

#include <algorithm>
#include <cmath>

#include "checker/certificate.hpp"
#include "checker/krawczyk.hpp"
#include "checker/periodic_zone.hpp"
#include "checker/reader.hpp"

namespace steadyslide::checker {
namespace {

constexpr slong derivative_bits = 48;
constexpr std::size_t most_parts = 20000;

std::array<Rational, 2> two_numbers(const Reader& at, const char* rule) {
  const std::vector<Rational> both = at.rationals();
  if (both.size() != 2 || both[0] > both[1]) at.fail("wrong numbers", rule);
  return {both[0], both[1]};
}

class Proof {
 public:
  explicit Proof(const Periodic& claim) : claim_(claim), p_(claim.problem) {
    bits_ = 64 - Ball(claim.radius, 64).exponent();
    precision_ = bits_ + 96;
    for (std::size_t end = 0; end < 2; ++end) {
      if (!claim.free[end]) continue;
      box_.push_back(
          Ball((claim.ends[end] - claim.origin) / p_.period, precision_).widened(Ball(claim.radius, precision_)));
    }
    ends_ = box_.size();
    Rational size = 0;
    for (const Rational& tau : claim.traction) size = std::max({size, tau, Rational(0) - tau});
    for (const Rational& tau : claim.traction)
      box_.push_back(Ball(tau, precision_).widened(Ball(claim.radius * size, precision_)));
  }

  PeriodicProof prove() {
    contract();
    const PeriodicZone zone(claim_, free_ends(box_), precision_);
    const Wave T = wave(box_);
    prove_pressure(zone, T);
    for (const int direction : {-1, 1}) {
      if (claim_.free[direction < 0 ? 0 : 1]) prove_gap(zone, T, direction);
    }
    prove_claims(zone, T);
    return result_;
  }

 private:
  using Matrix = std::vector<std::vector<Ball>>;
  std::vector<Ball> free_ends(const std::vector<Ball>& v) const { return {v.begin(), v.begin() + slong(ends_)}; }
  Wave wave(const std::vector<Ball>& v) const { return {v.begin() + slong(ends_), v.end()}; }
  Ball number(const Rational& q) const { return {q, precision_}; }

  /// Returns the conditions, linear in the tau_k, without their constants; or their derivatives.
  Matrix conditions(const PeriodicZone& zone, std::optional<std::size_t> moved, slong bits) const {
    Matrix rows;
    const std::vector<std::vector<Complex>> terms = zone.expansion(moved);
    for (std::size_t n = 0; n < terms.size(); ++n) {
      std::vector<Ball> re, im;
      for (const Complex& term : terms[n]) {
        re.push_back(term.re());
        im.push_back(term.im());
      }
      if (n + 1 < terms.size() || claim_.has_gap()) rows.push_back(std::move(re));
      rows.push_back(std::move(im));
    }
    if (!claim_.has_gap()) return rows;
    std::vector<Ball>& closure = rows[rows.size() - 2];
    const Rational last = p_.s(zone.piece(zone.arcs() - 1));
    for (std::size_t k = 0; k + 1 < zone.arcs(); ++k) {
      const Rational difference = p_.s(zone.piece(k)) - last;
      if (difference.sign() == 0) continue;
      for (std::size_t i = 0; i < closure.size(); ++i) {
        Wave one(closure.size());
        one[i] = 1;
        closure[i] -= number(difference) * zone.cosine(k) * zone.over_arc(k, {&one, false, moved}, bits);
      }
    }
    return rows;
  }

  /// Returns the constants that the conditions need, in their order.
  std::vector<Ball> constants(const PeriodicZone& zone) const {
    std::vector<Ball> result;
    for (int n = claim_.harmonics(); n > 0; --n) {
      const auto found = p_.harmonics.find(n);
      const Ball factor = Ball::pi(precision_) * number(Rational(n) / (p_.period * p_.compliance));
      const bool there = found != p_.harmonics.end();
      result.push_back(there ? factor * number(found->second[1]) : Ball());
      result.push_back(there ? -factor * number(found->second[0]) : Ball());
    }
    const Rational mean = p_.loads.from / p_.period;
    if (claim_.has_gap()) result.push_back(-number(p_.s(zone.piece(zone.arcs() - 1)) * mean));
    result.push_back(number(mean));
    return result;
  }

  std::vector<Ball> product(const Matrix& a, const Wave& tau) const {
    std::vector<Ball> result;
    for (const std::vector<Ball>& row : a) {
      Ball& sum = result.emplace_back(Ball().rounded(precision_));
      for (std::size_t i = 0; i < tau.size(); ++i) sum += row[i] * tau[i];
    }
    return result;
  }

  /// Krawczyk's operator; the box becomes its image.
  void contract() {
    std::vector<Ball> centre;
    for (const Ball& x : box_) centre.push_back(x.middle());
    const PeriodicZone at_centre(claim_, free_ends(centre), precision_), over(claim_, free_ends(box_), precision_);
    std::vector<Ball> F = product(conditions(at_centre, {}, bits_), wave(centre));
    const std::vector<Ball> known = constants(at_centre);
    Matrix J = conditions(over, {}, derivative_bits);
    if (F.size() != box_.size() || known.size() != box_.size())
      throw Unproved("as many conditions as unknowns are needed");
    for (std::size_t i = 0; i < F.size(); ++i) F[i] += known[i];
    std::vector<std::vector<Ball>> columns;
    for (std::size_t end = 0; end < 2; ++end) {
      if (claim_.free[end])
        columns.push_back(product(conditions(over, over.free_point(end), derivative_bits), wave(box_)));
    }
    for (std::size_t i = 0; i < J.size(); ++i) {
      for (std::size_t c = columns.size(); c-- > 0;) J[i].insert(J[i].begin(), columns[c][i]);
      J[i].push_back(0);  // the load is one number
    }
    const std::vector<Ball> K = krawczyk_image(box_, F, J, Ball().rounded(precision_), precision_);
    for (std::size_t i = 0; i < K.size(); ++i) {
      if (!box_[i].contains_inside(K[i])) {
        throw Unproved("Krawczyk's step leads out of the box: " +
                       (i < ends_ ? "a free end" : "coefficient " + std::to_string(i - ends_) + " of the traction") +
                       ", box " + box_[i].text(20) + ", step " + K[i].text(20));
      }
      const Ball moved = (K[i] - box_[i].middle()).size();
      result_.contraction = std::max(result_.contraction, (moved / box_[i].radius()).approximately());
    }
    box_ = K;
  }

  /// Decides T > 0 between two numbers. Returns the number of intervals.
  void prove_pressure(const PeriodicZone& zone, const Wave& T) {
    std::vector<Ball> open{hull(zone.point(0), zone.point(zone.arcs()))};
    while (!open.empty()) {
      const Ball at = open.back();
      open.pop_back();
      const Ball value = zone.wave(Complex(at), T).re();
      ++result_.in_contact;
      if (value.is_positive()) continue;
      if (value.is_negative() || result_.in_contact > most_parts)
        throw Unproved("the pressure is not positive at xi = " + at.text());
      open.push_back(hull(at.lower(), at.middle()).rounded(precision_));
      open.push_back(hull(at.middle(), at.upper()).rounded(precision_));
    }
  }

  /// The gap grows with |Y| T from the free end. On the way it is positive if T > 0, and at its lowest places, where T
  /// may change its sign, and at the end of the support or in the middle of the gap.
  void prove_gap(const PeriodicZone& zone, const Wave& T, int direction) {
    const std::size_t corner = direction < 0 ? 0 : zone.arcs();
    const Ball end = zone.point(corner);
    const Rational& edge = direction < 0 ? p_.left : p_.pieces.back().to;
    const Ball way = claim_.is_whole() ? (Ball(1) - (zone.point(zone.arcs()) - zone.point(0))) * Ball(0.5)
                                       : Ball(direction) * (number((edge - claim_.origin) / p_.period) - end);
    const Ball length = way.upper().rounded(precision_);
    const slong bits = std::min<slong>(bits_, 64);
    Ball reached = Ball().rounded(precision_);
    int sign = 1;
    // Decides the part from `from` to `to`, both exact.
    const auto decide = [&](const auto& self, const Ball& from, const Ball& to, int depth) -> void {
      const Ball d = hull(from, to).rounded(precision_);
      const Ball slope = zone.wave(Complex(end + Ball(direction) * d), T).re();
      ++result_.in_gap;
      if (slope.is_positive() || (slope.is_negative() && from.is_positive())) {
        sign = slope.is_positive() ? 1 : -1;
      } else if (depth < 30) {
        const Ball middle = d.middle();
        self(self, from, middle, depth + 1);
        self(self, middle, to, depth + 1);
      } else {
        const Ball height = zone.integral(corner, direction, from, {&T}, bits);
        const Ball fall = zone.value(corner, direction, d, T).size() * (to - from);
        if (!from.is_positive() || !(height - fall).is_positive())
          throw Unproved("the gap is not positive at the distance " + from.text() + " periods from a free end");
      }
      if (result_.in_gap > most_parts) throw Unproved("the gap needs too many intervals");
    };
    const int parts = 8 * (claim_.harmonics() + 1);
    for (int k = 0; k < parts; ++k) {
      const Ball next = (length * Ball(k + 1) / Ball(parts)).upper().rounded(precision_).middle();
      decide(decide, reached, next, 0);
      reached = next;
    }
    if (sign < 0 && !zone.integral(corner, direction, reached, {&T}, bits).is_positive())
      throw Unproved("the gap is not positive at the distance " + reached.text() + " periods from a free end");
  }

  void prove_claims(const PeriodicZone& zone, const Wave& T) const {
    const Ball unit = number(p_.period / p_.loads.from);  // L/P
    const auto friction = [&](std::size_t k) { return p_.friction[zone.piece(k)]; };
    const Rational& last = friction(zone.arcs() - 1);
    Ball effective = number(last), centre;
    for (std::size_t k = 0; k < zone.arcs(); ++k) {
      const Rational difference = friction(k) - last;
      const Ball factor = unit * zone.cosine(k);
      if (difference.sign() != 0) effective += number(difference) * factor * zone.over_arc(k, {&T}, bits_);
      centre += factor * zone.over_arc(k, {&T, true}, bits_);
    }
    require("the effective friction", effective, claim_.effective_friction);
    require("the centre of pressure", number(claim_.origin) + number(p_.period) * centre, claim_.centre_of_pressure);
  }

  void require(const char* what, const Ball& value, const std::array<Rational, 2>& claimed) const {
    if (!(value - number(claimed[0])).is_positive() || !(number(claimed[1]) - value).is_positive())
      throw Unproved(std::string(what) + " does not lie in the interval claimed; it is " + value.text(20));
  }

  const Periodic& claim_;
  const Problem& p_;
  slong bits_ = 0;
  slong precision_ = 0;
  std::size_t ends_ = 0;
  std::vector<Ball> box_;  ///< the free ends in xi, the coefficients of T
  PeriodicProof result_;
};

}  // namespace

Periodic Periodic::of_certificate(const Reader& at) {
  at.check_keys(
      {"certificate", "kind", "generator", "problem", "origin", "ends", "free", "traction", "radius", "claims"});
  check_heading(at);
  Periodic c;
  c.problem = Problem::of_certificate(at["problem"], true, true);
  const Problem& p = c.problem;
  for (const Problem::Piece& piece : p.pieces) {
    if (piece.profile.size() > 1 || piece.profile != p.pieces[0].profile)
      at["problem"].fail("no flat profile", "with a period the profile is flat, or a sum of harmonics");
  }
  c.origin = at["origin"].rational();
  if (c.harmonics() > 0) {
    const Rational turns = c.origin / p.period;
    if (turns.text().find('/') != std::string::npos)
      at["origin"].fail("another origin", "it is a multiple of the period");
  }
  c.ends = two_numbers(at["ends"], "[left, right]");
  const std::vector<Reader> free = at["free"].list();
  if (free.size() != 2) at["free"].fail("wrong number", "[left, right]");
  c.free = {free[0].boolean(), free[1].boolean()};
  if (c.is_whole() && c.free[0] != c.free[1]) at["free"].fail("an edge that is none", "the support has no edges");
  if ((!c.free[0] && c.ends[0] != p.left) || (!c.free[1] && c.ends[1] != p.pieces.back().to))
    at["ends"].fail("an edge that is none", "contact that is not free ends at an end of the support");
  c.traction = at["traction"].rationals();
  if (static_cast<int>(c.traction.size()) != 2 * c.harmonics() + 1 - c.m())
    at["traction"].fail("wrong number", "one coefficient for the load, two for each harmonic");
  c.radius = at["radius"].rational();
  if (c.radius < Rational(1) / Rational::parse("1e120", "") || c.radius > Rational::parse("1e-6", ""))
    at["radius"].fail("out of range", "it is at least 1e-120 and at most 1e-6");
  const Reader claims = at["claims"];
  claims.check_keys({"exists", "effective_friction", "centre_of_pressure"});
  if (!claims["exists"].boolean())
    claims["exists"].fail("nothing claimed", "a certificate claims that a solution exists");
  c.effective_friction = two_numbers(claims["effective_friction"], "[low, high]");
  c.centre_of_pressure = two_numbers(claims["centre_of_pressure"], "[low, high]");
  return c;
}

PeriodicProof prove_periodic(const Periodic& claim) { return Proof(claim).prove(); }

}  // namespace steadyslide::checker
