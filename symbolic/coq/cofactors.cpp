#include "symbolic/coq/cofactors.hpp"

namespace steadyslide::symbolic {

Cofactors cofactors(const Polynomial& polynomial, const std::vector<Root>& roots,
                    const std::vector<Inverse>& inverses) {
  Cofactors result;
  result.roots.resize(roots.size());
  result.inverses.resize(inverses.size());
  Polynomial rest = polynomial;  // times `factor`: the part that is not yet divided
  Polynomial factor(1);

  // With x = divisor * inverse, of degree m in the inverse q:
  //   sum_k p_k q^k = q^m sum_k p_k divisor^(m-k) - (x - 1) sum_k p_k q^k (1 + x + ... + x^(m-k-1)).
  for (std::size_t j = inverses.size(); j-- > 0;) {
    const auto& [q, divisor] = inverses[j];
    const int m = rest.degree(q);
    const Polynomial x = divisor * Polynomial::generator(q);
    Polynomial cleared;
    Polynomial powers;  // 1 + x + ... + x^(m-k-1)
    for (int k = m; k >= 0; --k) {
      const Polynomial p = rest.coefficient(q, k);
      cleared += p * divisor.to_the(m - k);
      result.inverses[j] += -(factor * p * Polynomial::generator(q, k) * powers);
      powers = powers * x + Polynomial(1);
    }
    factor = factor * Polynomial::generator(q, m);
    rest = cleared;
  }

  // root^n = root^(n-2) (root^2 - square) + root^(n-2) square, the highest power first.
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const auto& [root, square] = roots[k];
    for (int n = rest.degree(root); n >= 2; --n) {
      const Polynomial p = rest.coefficient(root, n) * Polynomial::generator(root, n - 2);
      result.roots[k] += factor * p;
      rest += p * square - p * Polynomial::generator(root, 2);
    }
  }
  result.remainder = factor * rest;
  return result;
}

}  // namespace steadyslide::symbolic
