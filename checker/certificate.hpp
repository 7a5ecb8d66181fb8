#pragma once
// A certificate as defined in docs/certified.md, read and checked for consistency: every anchor of the problem once,
// ends of contact that begin and end alternately, one ball for each unknown. Nothing is proved yet.

#include <string>
#include <vector>

#include "checker/ball.hpp"
#include "checker/problem.hpp"

namespace steadyslide::checker {

class Reader;

/// A point of the surface: an anchor, or a free end of contact at the distance h = exp(log_offset) beside one.
struct LayoutPoint {
  enum class Contact { interior, outside, begins, ends };

  std::size_t anchor = 0;
  int side = 0;  ///< -1: left of the anchor, +1: right of it, 0: the anchor itself
  Contact contact = Contact::outside;

  bool is_end() const { return contact == Contact::begins || contact == Contact::ends; }
  bool is_free() const { return side != 0; }
};

/// The topology of the contact: its points, and the segments between neighbours.
struct Layout {
  std::vector<LayoutPoint> points;     ///< left to right
  std::vector<bool> in_contact;        ///< for segment k, between points k and k + 1
  std::vector<std::size_t> intervals;  ///< the interval between anchors that contains segment k

  /// Returns the points at which contact begins, or ends, from left to right.
  std::vector<std::size_t> all(LayoutPoint::Contact kind) const;
  std::vector<std::size_t> free_ends() const;
  /// Returns the number of free ends minus the number of components: the degree S of Y at infinity.
  int degree_at_infinity() const;
};

/// The unknowns, for which a box has balls, in the order of list().
struct Unknowns {
  std::vector<Ball> log_offsets;  ///< for the free ends, left to right
  std::vector<Ball> q;            ///< coefficients without the leading one, which is the load
  std::vector<Ball> tilt;         ///< one ball if the indenter may tilt, otherwise empty

  std::vector<Ball> list() const;
  Unknowns with(const std::vector<Ball>& list) const;
};

/// The claim that for each of the loads there is one solution with this contact in V.
struct Box {
  Problem::Loads loads;
  Layout layout;
  Unknowns V;
};

struct Certificate {
  Problem problem;
  Rational origin;
  Rational unit;
  int bits = 0;
  std::vector<Box> boxes;  ///< for consecutive loads, which cover all loads of the problem

  /// Reads a certificate of kind "solution" or "loads".
  static Certificate read(const Reader& at);
};

/// Checks the keys of all certificates: the version of the format and the program that wrote it.
void check_heading(const Reader& at);

}  // namespace steadyslide::checker
