#include "checker/krawczyk.hpp"

#include <arb_mat.h>

#include <algorithm>

#include "checker/failure.hpp"

namespace steadyslide::checker {
namespace {

/// This number of bits of F'(V) is sufficient for a contraction.
constexpr slong jacobian_bits = 48;

using Matrix = std::vector<std::vector<Ball>>;

/// Returns an approximate inverse of the centre of a. Any matrix is admissible, but a bad one proves nothing.
Matrix inverse_of_centre(const Matrix& a, slong precision) {
  const auto n = static_cast<slong>(a.size());  // the last column, for the load, is left out
  Matrix result(a.size(), std::vector<Ball>(a.size(), Ball().rounded(precision)));
  arb_mat_t matrix;
  arb_mat_init(matrix, n, n);
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < a.size(); ++j) {
        visit(arb_mat_entry(matrix, static_cast<slong>(i), static_cast<slong>(j)), i, j);
      }
    }
  };
  // Rows that differ by powers of ten give bad pivots. So each row is scaled to a largest entry near 1.
  std::vector<slong> sizes(a.size(), -(slong(1) << 40));
  each([&](arb_ptr, std::size_t i, std::size_t j) { sizes[i] = std::max(sizes[i], a[i][j].exponent()); });
  each([&](arb_ptr entry, std::size_t i, std::size_t j) { arb_mul_2exp_si(entry, a[i][j].middle().get(), -sizes[i]); });
  const bool regular = arb_mat_inv(matrix, matrix, precision) != 0;
  each([&](arb_ptr entry, std::size_t i, std::size_t j) {
    arb_mul_2exp_si(entry, entry, -sizes[j]);
    arb_get_mid_arb(result[i][j].get(), entry);
  });
  arb_mat_clear(matrix);
  if (!regular) throw Unproved("the conditions' derivative is singular as far as can be seen");
  return result;
}

std::string name_of(std::size_t unknown, const Layout& layout) {
  const std::vector<std::size_t> free = layout.free_ends();
  if (unknown < free.size()) return "the free end at point " + std::to_string(free[unknown]);
  return "coefficient " + std::to_string(unknown - free.size()) + " of q, tilt";
}

Matrix jacobian_over(const ReducedProblem& problem, const Box& box, slong precision) {
  const Contact contact(problem, box.layout, box.V.log_offsets, precision);
  return jacobian(TractionRepresentation(contact, box.V, box.loads, jacobian_bits));
}

/// Returns the conditions at the middle load.
std::vector<Ball> conditions_at(const ReducedProblem& problem, const Box& box, const std::vector<Ball>& v, slong bits,
                                slong precision) {
  const Unknowns at = box.V.with(v);
  const Contact contact(problem, box.layout, at.log_offsets, precision);
  const Rational p = (box.loads.from + box.loads.to) / 2;
  return conditions(TractionRepresentation(contact, at, {p, p}, bits));
}

/// Returns the number of bits of F(v) that the box needs: the error of C F(v) is then 2^-12 of the box. `F` has
/// jacobian_bits.
slong bits_for(const std::vector<Ball>& V, const std::vector<Ball>& F, const Matrix& C) {
  slong bits = 24;
  for (std::size_t i = 0; i < V.size(); ++i) {
    Ball open;
    for (std::size_t k = 0; k < F.size(); ++k) open += (C[i][k] * F[k].radius()).size();
    if (!open.is_finite()) throw Unproved("a condition that is not finite");
    if (open.is_positive()) bits = std::max(bits, jacobian_bits + 12 + open.exponent() - V[i].radius().exponent());
  }
  if (bits > 5000) throw Unproved("a box that wants integrals to 2^-5000");
  return bits;
}

}  // namespace

std::vector<Ball> krawczyk_image(const std::vector<Ball>& V, const std::vector<Ball>& F, const Matrix& derivative,
                                 const Ball& loads, slong precision) {
  const std::size_t n = V.size();
  const Matrix C = inverse_of_centre(derivative, precision);
  std::vector<Ball> deviations;  // V - v, followed by P - p
  for (const Ball& x : V) deviations.push_back(x.rounded(precision) - x.rounded(precision).middle());
  deviations.push_back(loads);
  std::vector<Ball> result;
  for (std::size_t i = 0; i < n; ++i) {
    Ball K = V[i].rounded(precision).middle();
    for (std::size_t k = 0; k < n; ++k) K -= C[i][k] * F[k];
    for (std::size_t k = 0; k <= n; ++k) {
      Ball entry = i == k ? 1 : 0;
      for (std::size_t j = 0; j < n; ++j) entry -= C[i][j] * derivative[j][k];
      K += entry * deviations[k];
    }
    result.push_back(K);
  }
  return result;
}

Krawczyk prove_zero(const ReducedProblem& problem, const Box& box, slong least_precision) {
  const std::vector<Ball> V = box.V.list();
  const std::size_t n = V.size();
  Krawczyk result{box};
  for (const Ball& x : V) {
    if (!x.radius().is_positive()) throw Unproved("a box without interior proves no zero");
  }
  const auto centre = [&](slong precision) {
    std::vector<Ball> v;
    for (const Ball& x : V) v.push_back(x.rounded(precision).middle());
    return v;
  };
  const slong first_precision = std::max(least_precision, jacobian_bits + 96);
  const std::vector<Ball> first = conditions_at(problem, box, centre(first_precision), jacobian_bits, first_precision);
  if (first.size() != n) throw Unproved("as many conditions as unknowns are needed");
  if (n == 0) return result;
  const Matrix J = jacobian_over(problem, box, first_precision);
  result.bits = bits_for(V, first, inverse_of_centre(J, first_precision));
  const slong precision = std::max(least_precision, result.bits + 96);
  const std::vector<Ball> F = conditions_at(problem, box, centre(precision), result.bits, precision);
  const Ball width = Ball((box.loads.to - box.loads.from) / problem.unit, precision);
  const Ball loads = Ball().widened(width * Ball(0.5)).rounded(precision);
  const std::vector<Ball> K = krawczyk_image(V, F, J, loads, precision);
  for (std::size_t i = 0; i < n; ++i) {
    if (!V[i].contains_inside(K[i])) {
      throw Unproved("Krawczyk's step leads out of the box: " + name_of(i, box.layout) + ", box " + V[i].text(20) +
                     ", step " + K[i].text(20));
    }
    const Ball moved = (K[i] - V[i].rounded(precision).middle()).size();
    result.contraction = std::max(result.contraction, (moved / V[i].radius()).approximately());
  }
  result.image.V = box.V.with(K);
  return result;
}

}  // namespace steadyslide::checker
