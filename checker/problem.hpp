#pragma once
// The contact problem as exact data, read from a certificate or from a problem file (docs/problem-file.md), and
// reduced:
//
//   A t = g + tilt on the contact, g(xi) = psi'(x)/c, int t dxi = -P/unit, xi = (x - origin)/unit, s = +-gamma f.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "checker/rational.hpp"

namespace steadyslide::checker {

class Reader;

struct Problem {
  struct Piece {
    Rational to;
    Polynomial profile;
    bool operator==(const Piece&) const = default;
  };
  /// Loads P with from <= P <= to.
  struct Loads {
    Rational from;
    Rational to;
    static Loads read(const Reader& at);
  };

  Loads loads;
  std::optional<Rational> load_at;
  bool slides_to_plus_x = true;
  Rational gamma;
  Rational compliance;
  std::vector<Rational> friction;
  std::vector<Rational> jumps;
  Rational left;
  std::vector<Piece> pieces;
  Rational period;                                   ///< 0: none
  std::map<int, std::array<Rational, 2>> harmonics;  ///< cos and sin by n; none of them has both 0

  /// Reads the problem of a certificate, for one load or for an interval of loads, and of periodic contact.
  static Problem of_certificate(const Reader& at, bool one_load, bool periodic = false);
  void read_harmonics(const Reader& at);
  /// Reads a problem file. The path of a measured trace is relative to its folder.
  static Problem of_file(const std::string& name);
  /// Throws Malformed if a datum breaks a rule of docs/problem-file.md.
  void check(const std::string& place) const;
  /// Returns the first datum in which the problem of a file, which has one load, differs from these problems; empty if
  /// none differs.
  std::string difference(const Problem& file) const;
  /// Returns +-gamma f for friction value k, with the sign of the sliding direction.
  Rational s(std::size_t k) const { return Rational(slides_to_plus_x ? 1 : -1) * gamma * friction[k]; }
  /// True if s never decreases, the profile has no step and the indenter cannot tilt. Then theorem 1 of [Bal16]
  /// applies, and the energy bounds errors.
  bool theorem_1_applies() const;
};

/// The reduced problem, exact except for the load. Anchors are the points of the data: ends of the support, friction
/// jumps, ends of pieces, from left to right. Interval k is between anchor k and the next one.
struct ReducedProblem {
  ReducedProblem(const Problem& problem, Rational origin, Rational unit);

  Rational origin;
  Rational unit;
  std::vector<Rational> places;       ///< of the anchors, in x
  std::vector<Rational> anchors;      ///< in xi
  std::vector<Rational> steps;        ///< of psi/(c unit) at the anchors, right minus left; 0 at the support's ends
  std::vector<Polynomial> slopes;     ///< the different polynomials g
  std::vector<std::size_t> slope_of;  ///< index of the slope on an interval
  std::vector<Rational> s;            ///< s on an interval
  std::optional<Rational> load_at;
};

}  // namespace steadyslide::checker
