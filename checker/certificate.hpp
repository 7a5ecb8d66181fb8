#pragma once
// A certificate as docs/certified.md defines it, read and found to be consistent with itself: every anchor of the
// problem once, ends of contact that begin and end in turns, as many balls as there are unknowns. Nothing is proved yet.

#include <string>
#include <vector>

#include "checker/ball.hpp"
#include "checker/problem.hpp"

namespace steadyslide::checker {

class Reader;

/// A point of the surface: an anchor, or a free end of contact at the distance h = exp(log_offset) beside one.
struct Point {
  enum class Contact { interior, outside, begins, ends };

  std::size_t anchor = 0;
  int side = 0;  ///< -1: left of the anchor, +1: right of it, 0: the anchor itself
  Contact contact = Contact::outside;

  bool is_end() const { return contact == Contact::begins || contact == Contact::ends; }
  bool is_free() const { return side != 0; }
};

/// What is known of the contact without any number: its points, and what lies between neighbours.
struct Layout {
  std::vector<Point> points;           ///< left to right
  std::vector<bool> in_contact;        ///< of segment k, between points k and k + 1
  std::vector<std::size_t> intervals;  ///< the interval between anchors in which segment k lies

  /// Points of contact's ends, "begins" or "ends", left to right.
  std::vector<std::size_t> all(Point::Contact kind) const;
  std::vector<std::size_t> free_ends() const;
  /// Free ends minus components: the degree S of Y at infinity.
  int degree_at_infinity() const;
};

/// The unknowns: what a box has balls for, in the order of list().
struct Unknowns {
  std::vector<Ball> log_offsets;  ///< of the free ends, left to right
  std::vector<Ball> q;            ///< without the leading coefficient, which is the load
  std::vector<Ball> tilt;         ///< one where the indenter may tilt, none otherwise

  std::vector<Ball> list() const;
  Unknowns with(const std::vector<Ball>& list) const;
};

/// For each of the loads one solution with this contact is claimed in V.
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
  std::vector<Box> boxes;  ///< for loads one after the other, all of the problem's
  bool unique_by_theorem_1 = false;

  /// Of kind "solution" or "loads".
  static Certificate read(const Reader& at);
};

/// The keys that certificates of every kind have: the format's version and the program that wrote it.
void check_heading(const Reader& at);

}  // namespace steadyslide::checker
