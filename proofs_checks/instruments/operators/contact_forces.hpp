#pragma once
// Contact conditions on nodes, decided exactly. Functions are their values at N nodes, v = u - psi; tractions are
// forces q_i of t~ with sum q = 0; t_0 has weights tau_i > 0 of sum 1, and p_i = P tau_i - q_i are the contact forces.
// Then K_0' = {q: p_i >= 0}, a simplex with the corners p = P e_j, and phi = P (max v - sum tau_i v_i).
//
// Statements for all t_hat or u_hat become finite ones. (i) is linear in t_hat: the corners of K_0' decide it, and so
// do exchanges of force between two nodes. The left side of (ii), F(w) = sum q_i w_i + phi(w), is convex, and linear as
// long as the order of the w_i does not change. Therefore F(v) <= F everywhere if and only if F does not fall from v
// towards v + h x for small h, where x is the indicator of any set of nodes. The paper's test functions w = 0, 2 v and
// -e_i give an independent check.

#include <algorithm>
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
  /// True if holds(i) is true for every node i.
  template <class Holds>
  bool all_nodes(const Holds& holds) const {
    for (std::size_t i = 0; i < size(); ++i) {
      if (!holds(i)) return false;
    }
    return true;
  }
  /// True if q is in K_0'.
  bool is_admissible() const {
    return all_nodes([this](std::size_t i) { return force(i) >= 0; });
  }
};

/// The three conditions in the paper's form, or in a wrong one.
struct Conditions {
  bool complementary = true;  ///< (11) includes t_n (u + C - psi) = 0
  bool compressive = true;    ///< (11) includes t_n <= 0
  Rational contact_within;    ///< in (11): the largest gap that counts as contact
  int first = 1;              ///< sign of (i)
  bool over_all = false;      ///< (i) for all t_hat of zero mean
  int functional = 1;         ///< factor of phi in (ii)
};

/// True if (11) holds for some C.
bool holds_11(const ContactForces& c, const Conditions& conditions);
bool holds_i_by_corners(const ContactForces& c, const Conditions& conditions);
bool holds_i_by_exchanges(const ContactForces& c);
bool holds_ii_by_test_functions(const ContactForces& c, const Conditions& conditions);
bool holds_ii_by_subsets(const ContactForces& c, const Conditions& conditions);

Rational phi_on_nodes(const ContactForces& c, const std::vector<Rational>& w);
Rational dot(const std::vector<Rational>& a, const std::vector<Rational>& b);
/// Returns a vector that is `height` on the nodes whose bit is set, and 0 on the others.
std::vector<Rational> indicator(std::size_t size, unsigned bits, const Rational& height = 1);

/// Returns a solution for k = 0 mod 6. Otherwise one condition is violated by `step`: 1 a force at a gap, 2 a pulling
/// force in contact, 3 a node that rises above the others without a force, 4 a gap under a force, 5 random changes.
ContactForces random_forces(Random& random, std::size_t k, const Rational& step);

}  // namespace steadyslide::proofs_checks
