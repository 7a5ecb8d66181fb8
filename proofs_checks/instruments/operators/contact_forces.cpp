#include "proofs_checks/instruments/operators/contact_forces.hpp"

#include <algorithm>
#include <numeric>

namespace steadyslide::proofs_checks {
namespace {

std::vector<Rational> plus(std::vector<Rational> a, const std::vector<Rational>& b, const Rational& factor = 1) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
  return a;
}

/// Returns sum q w + phi(w).
Rational functional_ii(const ContactForces& c, const std::vector<Rational>& w, const Conditions& conditions) {
  return dot(c.q, w) + conditions.functional * phi_on_nodes(c, w);
}

}  // namespace

Rational dot(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), Rational(0));
}

std::vector<Rational> indicator(std::size_t size, unsigned bits, const Rational& height) {
  std::vector<Rational> w(size, Rational(0));
  for (std::size_t i = 0; i < size; ++i) {
    if ((bits >> i & 1U) != 0) w[i] = height;
  }
  return w;
}

Rational phi_on_nodes(const ContactForces& c, const std::vector<Rational>& w) {
  return c.load * (*std::ranges::max_element(w) - dot(c.tau, w));
}

bool holds_11(const ContactForces& c, const Conditions& conditions) {
  // Some force is positive, because their sum is positive. Therefore C must have this value.
  const Rational top = *std::ranges::max_element(c.v);
  return (!conditions.compressive || c.is_admissible()) &&
         (!conditions.complementary ||
          c.all_nodes([&](std::size_t i) { return c.force(i) == 0 || top - c.v[i] <= conditions.contact_within; }));
}

bool holds_i_by_corners(const ContactForces& c, const Conditions& conditions) {
  if (!c.is_admissible()) return false;
  if (conditions.over_all) {
    // A linear function that is bounded below is zero: v is constant.
    return std::ranges::all_of(c.v, [&](const Rational& v) { return v == c.v[0]; });
  }
  const Rational here = dot(c.q, c.v);
  const Rational mean = dot(c.tau, c.v);
  return std::ranges::all_of(c.v,
                             [&](const Rational& v) { return conditions.first * (c.load * (mean - v) - here) >= 0; });
}

bool holds_i_by_exchanges(const ContactForces& c) {
  return c.is_admissible() && c.all_nodes([&](std::size_t i) {
    return c.all_nodes([&](std::size_t j) { return c.force(i) == 0 || c.v[j] <= c.v[i]; });
  });
}

bool holds_ii_by_test_functions(const ContactForces& c, const Conditions& conditions) {
  const Rational here = functional_ii(c, c.v, conditions);
  std::vector<std::vector<Rational>> tests{std::vector<Rational>(c.size(), Rational(0)), plus(c.v, c.v)};
  for (std::size_t i = 0; i < c.size(); ++i) tests.push_back(indicator(c.size(), 1U << i, -1));
  return std::ranges::all_of(tests, [&](const auto& w) { return functional_ii(c, w, conditions) >= here; });
}

bool holds_ii_by_subsets(const ContactForces& c, const Conditions& conditions) {
  Rational step = 1;
  for (const Rational& a : c.v) {
    for (const Rational& b : c.v) {
      if (a < b) step = std::min(step, Rational(b - a));
    }
  }
  const Rational here = functional_ii(c, c.v, conditions);
  for (unsigned bits = 0; bits < 1U << c.size(); ++bits) {
    if (functional_ii(c, plus(c.v, indicator(c.size(), bits, step / 2)), conditions) < here) return false;
  }
  return true;
}

ContactForces random_forces(Random& random, std::size_t k, const Rational& step) {
  const std::size_t n = 3 + random.below(4);
  ContactForces c{random.between(Rational(1, 2), 3), {}, {}, {}};
  Rational sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    c.tau.push_back(random.between(Rational(1, 5), 1));
    sum += c.tau.back();
  }
  for (Rational& tau : c.tau) tau /= sum;

  // Forces in contact, some of them zero, and gaps elsewhere. Node 0 is in contact, the last node is not.
  std::vector<Rational> p(n, Rational(0));
  const Rational height = random.between(-2, 2);
  sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool contact = i == 0 || (i + 1 < n && random.below(2) == 0);
    c.v.push_back(contact ? height : Rational(height - random.between(0, 2)));
    if (contact && (i == 0 || random.below(4) != 0)) p[i] = random.between(0, 1);
    sum += p[i];
  }
  for (Rational& force : p) force *= c.load / sum;
  switch (k % 6) {
    case 1:
      p[n - 1] += step * p[0];
      p[0] -= step * p[0];
      break;
    case 2:
      c.v[n - 1] = height;
      p[0] += step;
      p[n - 1] -= step;
      break;
    case 3: c.v[n - 1] = height + step; break;
    case 4:
      c.v[0] -= step;
      // Another node stays in contact.
      c.v[1] = height;
      break;
    case 5:
      for (Rational& v : c.v) v = random.between(-1, 1);
      for (std::size_t i = 1; i < n; ++i) {
        const Rational moved = random.between(-1, 1);
        p[i] += moved;
        p[0] -= moved;
      }
      break;
    default: break;
  }
  for (std::size_t i = 0; i < n; ++i) c.q.push_back(c.load * c.tau[i] - p[i]);
  return c;
}

}  // namespace steadyslide::proofs_checks
