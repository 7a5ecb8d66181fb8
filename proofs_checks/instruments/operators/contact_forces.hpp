#pragma once
// Contact conditions on nodes, decided exactly. Functions are their values at N nodes, v = u - psi; tractions are
// forces q_i of t~ with sum q = 0; t_0 has weights tau_i > 0 of sum 1, and p_i = P tau_i - q_i are the contact forces.
// Then K_0' = {q: p_i >= 0}, a simplex with the corners p = P e_j, and phi = P (max v - sum tau_i v_i).
//
// Statements for all t_hat or u_hat become finite ones. (i) is linear in t_hat: corners of K_0' decide, or exchanges of
// force between two nodes. The left side of (ii), F(w) = sum q_i w_i + phi(w), is convex and linear where the order of
// the w_i does not change: F(v) <= F everywhere if and only if it does not fall towards v + h x for the indicator x of
// any set of nodes, h small. Unrelated to that: the paper's test functions w = 0, 2 v and -e_i.

#include <algorithm>
#include <ranges>
#include <vector>

#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {

struct ContactForces {
  Rational load;
  std::vector<Rational> tau;
  std::vector<Rational> q;
  std::vector<Rational> v;

  std::size_t size() const { return tau.size(); }
  Rational force(std::size_t i) const { return load * tau[i] - q[i]; }
  /// holds(i) for every node i.
  template <class Holds>
  bool all_nodes(const Holds& holds) const {
    return std::ranges::all_of(std::views::iota(std::size_t{0}, size()), holds);
  }
  /// q in K_0'
  bool is_admissible() const {
    return all_nodes([this](std::size_t i) { return force(i) >= 0; });
  }
};

/// The three conditions as they are said: those of the paper, or wrong ones.
struct Conditions {
  bool complementary = true;  ///< in (11): t_n (u + C - psi) = 0
  bool compressive = true;    ///< in (11): t_n <= 0
  Rational contact_within;    ///< in (11): a gap of this counts as contact
  int first = 1;              ///< sign of (i)
  bool over_all = false;      ///< (i) for all t_hat of zero mean
  int functional = 1;         ///< factor of phi in (ii)
};

/// (11) for some C.
bool holds_11(const ContactForces& c, const Conditions& conditions);
bool holds_i_by_corners(const ContactForces& c, const Conditions& conditions);
bool holds_i_by_exchanges(const ContactForces& c);
bool holds_ii_by_test_functions(const ContactForces& c, const Conditions& conditions);
bool holds_ii_by_subsets(const ContactForces& c, const Conditions& conditions);

Rational phi_on_nodes(const ContactForces& c, const std::vector<Rational>& w);
Rational dot(const std::vector<Rational>& a, const std::vector<Rational>& b);
/// 1 on the nodes whose bit is set.
std::vector<Rational> indicator(std::size_t size, unsigned bits, const Rational& height = 1);

/// Solutions for k = 0 mod 6; else one thing is wrong by `step`: 1 force where there is a gap, 2 a pulling force in
/// contact, 3 a node that rises above the others without force, 4 a gap opened under a force, 5 anything.
ContactForces random_forces(Random& random, std::size_t k, const Rational& step);

}  // namespace steadyslide::proofs_checks
