#pragma once
// The solution of A t = g + tilt on a contact set, with the load P as the leading coefficient of q
// (docs/theory.md):
//
//   u'/c = g_k + tilt - Y B_k outside the contact,   t = eps cos(pi alpha) |Y| B_k on it,
//   B_k(x) = [(g_k + tilt)/Y]_poly - q(x)/pi - (1/pi) int_K eps cos(pi alpha) (g - g_k)/|Y| dx'/(x'-x),
//
// which is the same function for every polynomial g_k. B_k is used only outside the pieces of contact with another
// polynomial, so the integral is not a principal value. Its integrands are 1/|Y| times polynomials (Trapezoid).
//
// At a place x = m + D, with m the middle of a segment, a half its length, and |D| > a/0.7, moments give the sum of its
// rule:
//   sum_l d_l/(x_l - x) = -(1/D) sum_p mu_p (a/D)^p,  mu_p = sum_l d_l ((x_l - m)/a)^p,
// and the terms p >= n are together at most sum_l |d_l| |a/D|^n/(|D| - a).

#include <optional>

#include "checker/contact.hpp"
#include "checker/trapezoid.hpp"

namespace steadyslide::checker {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// |Y|^exponent d(x, extra)^-1 on the panel from `start` right of point i to `end` left of point j; `extra` is a point
/// or none. The reaches are those for Trapezoid; zero means half the neighbouring segment.
struct PowerPanel {
  const Contact& contact;
  std::size_t i;
  std::size_t j;
  Ball start = {};
  Ball end = {};
  int exponent = 1;
  std::size_t extra = none;
  std::size_t degree = 0;
  Ball length = {};  ///< length, if more accurate than the difference; otherwise 0

  Trapezoid rule(slong bits, const Ball& left_reach = {}, const Ball& right_reach = {}) const;
};

class TractionRepresentation {
 public:
  /// `bits` is the relative precision of the integrals.
  TractionRepresentation(const Contact& contact, const Unknowns& unknowns, const Problem::Loads& loads, slong bits);

  const Contact& contact() const { return *contact_; }
  /// Returns P/unit, with all loads in one ball.
  const Ball& load() const { return load_; }
  /// Returns q with the load; empty if S >= 0.
  const std::vector<Ball>& q() const { return q_; }
  slong bits() const { return bits_; }
  /// Returns the smallest distance from an anchor where the polynomial changes at which B is needed: 2^-bits of the
  /// distance of its nearer neighbour.
  Ball reach(std::size_t point) const;

  struct Value {
    Ball value;
    Ball slope;      ///< d/dx
    Ball integrals;  ///< an upper bound of (1/pi) int_K cos(pi alpha) |g - g_k|/|Y| dx'/|x'-x|
    Ball error;      ///< largest difference between the rules' sums and the integrals
  };
  /// Returns B_k at a place (or an interval of places), where k is a slope. A segment may be left out of the integrals.
  Value regular(std::size_t k, const SurfacePoint& at, std::size_t without = none) const;
  /// The same without the derivative; the integrals have an error of 2^-bits of their size with absolute values.
  Value regular_to(slong bits, std::size_t k, const SurfacePoint& at) const;
  /// The same with the rules' sums instead of the integrals.
  Value sums_to(slong bits, std::size_t k, const SurfacePoint& at) const;
  /// A segment with an integral of B_k: a lower bound of its distance from a place; an upper bound of (1/pi) int cos(pi
  /// alpha) |g - g_k|/|Y| dx' over it and of the rule's sum; the rule's relative error with a pole.
  struct Piece {
    Ball distance;
    Ball size;
    Ball relative_error;
  };
  std::vector<Piece> other_pieces(std::size_t k, const SurfacePoint& at) const;
  /// Returns the number of coefficients of [(g_k + tilt)/Y]_poly - q/pi, which is its degree plus 1.
  std::size_t terms(std::size_t k) const { return polynomials_[k].size(); }
  /// Returns B_k at an end of contact, where k is the slope of the contact.
  Ball at_end(std::size_t j) const;
  /// An upper bound of |[(g_k + tilt)/Y]_poly - q/pi| within `radius` of a place.
  Ball polynomial_bound(std::size_t k, const Ball& centre, const Ball& radius) const;
  /// Returns the first m_j in u'/(cY) = m_0/z + m_1/z^2 + ... + q/pi.
  std::vector<Ball> moments(std::size_t count) const;

  /// The data of the integral over a segment near an anchor (signs.cpp).
  struct Integral {
    Trapezoid rule;
    std::vector<std::vector<Ball>> densities;  ///< for each k, at the nodes: eps cos(pi alpha) (g - g_k)/(pi |Y|) dx'
    std::vector<Ball> bounds;                  ///< for each k, bounds of cos(pi alpha) |g - g_k|/pi in the strip
    Ball weights;                              ///< an upper bound of their sum
    /// For each k: sums over the nodes of the density times ((x' - middle)/half)^p, p = 0, 1, ...
    std::vector<std::vector<Ball>> moments;
  };
  const Integral& integral(std::size_t segment) const { return *integrals_[segment]; }
  /// Returns the polynomial g_l - g_k about anchor a.
  std::vector<Ball> difference(std::size_t l, std::size_t k, std::size_t anchor) const;

 private:
  void add_integrals(std::size_t segment, const std::vector<bool>& asked);
  /// |x' - x| is near + u over a segment on the right of a place, and near + v over a segment on the left.
  struct Near {
    Ball near;
    bool on_right;
  };
  Near near(std::size_t segment, const SurfacePoint& at) const;
  /// Adds the sum over the nodes by moments, at x = middle + D. Returns false if the place is too near or D is too
  /// wide.
  bool add_far_cauchy(std::size_t segment, std::size_t k, const Ball& near, bool on_right, slong bits,
                      Value& result) const;
  void add_cauchy(std::size_t segment, std::size_t k, const SurfacePoint& at, bool with_slope, slong bits,
                  Value& result) const;

  const Contact* contact_;
  Ball load_;
  std::vector<Ball> q_;
  slong bits_;
  std::vector<std::vector<Ball>> slopes_;       ///< g_k + tilt
  std::vector<std::vector<Ball>> polynomials_;  ///< [(g_k + tilt)/Y]_poly - q/pi
  std::vector<std::optional<Integral>> integrals_;
};

/// Returns a bound of |p| within `radius` of `centre`.
Ball bound_near(const std::vector<Ball>& p, const Ball& centre, const Ball& radius);

}  // namespace steadyslide::checker
