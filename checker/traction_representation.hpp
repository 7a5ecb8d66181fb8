#pragma once
// The solution of A t = g + tilt on a contact set, with the load P as the leading coefficient of q
// (docs/theory.md):
//
//   u'/c = g_k + tilt - Y B_k off the contact,   t = eps cos(pi alpha) |Y| B_k on it,
//   B_k(x) = [(g_k + tilt)/Y]_poly - q(x)/pi - (1/pi) int_K eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x),
//
// the same function for every polynomial g_k that is asked for. B_k is asked for off the pieces of the contact on which
// g is another polynomial: the integral has no principal value. Its integrands are 1/|Y| times polynomials (Trapezoid).
//
// At a place x = m + D, m the middle of a segment of half the length a, |D| > a/0.7, the sum of its rule is taken by moments:
//   sum_l d_l/(x_l - x) = -(1/D) sum_p mu_p (a/D)^p,  mu_p = sum_l d_l ((x_l - m)/a)^p,
// and what follows p < n is at most sum_l |d_l| |a/D|^n/(|D| - a).

#include <optional>

#include "checker/contact.hpp"
#include "checker/trapezoid.hpp"

namespace steadyslide::checker {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// |Y|^exponent d(x, extra)^-1 on the panel that reaches from `start` right of point i to `end` left of point j; `extra` is
/// a point or none. Reaches as Trapezoid has them; zero: half the neighbouring segment.
struct PowerPanel {
  const Contact& contact;
  std::size_t i;
  std::size_t j;
  Ball start = {};
  Ball end = {};
  int exponent = 1;
  std::size_t extra = none;
  std::size_t degree = 0;
  Ball length = {};  ///< where it is known better than as a difference, 0 otherwise

  Trapezoid rule(slong bits, const Ball& left_reach = {}, const Ball& right_reach = {}) const;
};

class TractionRepresentation {
 public:
  /// `bits`: of the integrals, relative.
  TractionRepresentation(const Contact& contact, const Unknowns& unknowns, const Problem::Loads& loads, slong bits);

  const Contact& contact() const { return *contact_; }
  /// P/unit, all loads in one ball.
  const Ball& load() const { return load_; }
  /// With the load; empty if S >= 0.
  const std::vector<Ball>& q() const { return q_; }
  slong bits() const { return bits_; }
  /// How close to an anchor where the polynomial changes B is asked for: 2^-bits of the nearer neighbour's distance.
  Ball reach(std::size_t point) const;

  struct Value {
    Ball value;
    Ball slope;      ///< d/dx
    Ball integrals;  ///< an upper bound of (1/pi) int_K cos(pi alpha) |g - g_k|/|Y| dx'/|x'-x|
    Ball error;      ///< by which the rules' sums differ from the integrals at most
  };
  /// B_k at a place (an interval of them), k a slope. A segment may be left out of the integrals.
  Value regular(std::size_t k, const Place& at, std::size_t without = none) const;
  /// The same without its slope, the integrals to 2^-bits of their size with absolute values.
  Value regular_to(slong bits, std::size_t k, const Place& at) const;
  /// The same with the rules' sums in place of the integrals.
  Value sums_to(slong bits, std::size_t k, const Place& at) const;
  /// A segment over which B_k has an integral: how far it is from a place at least; an upper bound of
  /// (1/pi) int cos(pi alpha) |g - g_k|/|Y| dx' over it, and of the rule's sum; the rule's relative error with a pole.
  struct Piece {
    Ball distance;
    Ball size;
    Ball relative_error;
  };
  std::vector<Piece> other_pieces(std::size_t k, const Place& at) const;
  /// The number of coefficients of [(g_k + tilt)/Y]_poly - q/pi: its degree plus 1.
  std::size_t terms(std::size_t k) const { return polynomials_[k].size(); }
  /// B_k at an end of contact, k the slope of the contact.
  Ball at_end(std::size_t j) const;
  /// An upper bound of |[(g_k + tilt)/Y]_poly - q/pi| within `radius` of a place.
  Ball polynomial_bound(std::size_t k, const Ball& centre, const Ball& radius) const;
  /// The first m_j of u'/(cY) = m_0/z + m_1/z^2 + ... + q/pi.
  std::vector<Ball> moments(std::size_t count) const;

  /// What the integral over a segment near an anchor consists of (signs.cpp).
  struct Integral {
    Trapezoid rule;
    std::vector<std::vector<Ball>> densities;  ///< for each k, at the nodes: eps cos(pi alpha) (g - g_k)/(pi |Y|) dx'
    std::vector<Ball> bounds;                  ///< for each k, of cos(pi alpha) |g - g_k|/pi in the strip
    Ball weights;                              ///< an upper bound of their sum
    /// For each k: sums over the nodes of the density times ((x' - middle)/half)^p, p = 0, 1, ...
    std::vector<std::vector<Ball>> moments;
  };
  const Integral& integral(std::size_t segment) const { return *integrals_[segment]; }
  /// The polynomial g_l - g_k about anchor a.
  std::vector<Ball> difference(std::size_t l, std::size_t k, std::size_t anchor) const;

 private:
  void add_integrals(std::size_t segment, const std::vector<bool>& asked);
  /// |x' - x| = near + u over a segment on the right of a place, near + v on the left.
  struct Near {
    Ball near;
    bool on_right;
  };
  Near near(std::size_t segment, const Place& at) const;
  /// The sum over the nodes by its moments, at x = middle + D; false where it is not far enough, or D too wide.
  bool add_far_cauchy(std::size_t segment, std::size_t k, const Ball& near, bool on_right, slong bits,
                      Value& result) const;
  void add_cauchy(std::size_t segment, std::size_t k, const Place& at, bool with_slope, slong bits,
                  Value& result) const;

  const Contact* contact_;
  Ball load_;
  std::vector<Ball> q_;
  slong bits_;
  std::vector<std::vector<Ball>> slopes_;       ///< g_k + tilt
  std::vector<std::vector<Ball>> polynomials_;  ///< [(g_k + tilt)/Y]_poly - q/pi
  std::vector<std::optional<Integral>> integrals_;
};

/// A bound of |p| within `radius` of `centre`.
Ball bound_near(const std::vector<Ball>& p, const Ball& centre, const Ball& radius);

}  // namespace steadyslide::checker
