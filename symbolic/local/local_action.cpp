#include "symbolic/local/local_action.hpp"

#include <stdexcept>

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

ex factorial(int n) { return GiNaC::factorial(numeric(n)); }
ex binomial(int n, int k) { return GiNaC::binomial(numeric(n), numeric(k)); }

/// The coefficients of L^0, L^1, ... in the image of L^logs, L = log|x|, on the side of the density and on the other
/// side.
struct Image {
  std::vector<ex> same;
  std::vector<ex> other;
};

/// (d/d lambda)^logs of -C e^{lambda L} and of -S e^{lambda L}:  dC/d lambda = -pi S^2,  dS/d lambda = -pi C S.
Image fractional_image(int logs, const LocalConstants& constants) {
  const GiNaC::symbol c("C");
  const GiNaC::symbol s("S");
  const auto differentiated = [&](const ex& f) -> ex {
    return (-constants.pi * (s * s * f.diff(c) + c * s * f.diff(s))).expand();
  };
  Image image{std::vector<ex>(static_cast<std::size_t>(logs) + 1), std::vector<ex>(static_cast<std::size_t>(logs) + 1)};
  ex same = -c;
  ex other = -s;
  for (int m = 0; m <= logs; ++m) {
    const GiNaC::exmap values{{c, constants.cot}, {s, constants.cosecant}};
    image.same[static_cast<std::size_t>(logs - m)] = binomial(logs, m) * same.subs(values);
    image.other[static_cast<std::size_t>(logs - m)] = binomial(logs, m) * other.subs(values);
    same = differentiated(same);
    other = differentiated(other);
  }
  return image;
}

/// logs! times the coefficient of e^logs in -cot(pi e) e^{e L} and in -e^{e L}/sin(pi e): finite parts at an integer.
Image integer_image(int logs, const ex& pi) {
  Image image{std::vector<ex>(static_cast<std::size_t>(logs) + 2), std::vector<ex>(static_cast<std::size_t>(logs) + 2)};
  for (int k = 0; 2 * k - 1 <= logs; ++k) {
    const int m = 2 * k - 1;
    const ex four = GiNaC::pow(ex(4), k);
    const ex bernoulli = GiNaC::bernoulli(numeric(2 * k)) * GiNaC::pow(pi, m) / factorial(2 * k);
    const ex sign = k % 2 == 0 ? 1 : -1;
    const ex scale = factorial(logs) / factorial(logs - m);
    image.same[static_cast<std::size_t>(logs - m)] = -sign * four * bernoulli * scale;
    image.other[static_cast<std::size_t>(logs - m)] = sign * (four - 2) * bernoulli * scale;
  }
  return image;
}

void add_to(LocalDensity& density, const LocalMonomial& monomial, const ex& coefficient) {
  const auto [place, is_new] = density.emplace(monomial, coefficient);
  if (!is_new) place->second += coefficient;
}

void add_image(LocalDensity& result, const LocalMonomial& monomial, Side target, const std::vector<ex>& powers,
               const ex& factor) {
  for (std::size_t k = 0; k < powers.size(); ++k) {
    if (powers[k].is_zero()) continue;
    add_to(result, {target, monomial.fractional, monomial.order, static_cast<int>(k)}, factor * powers[k]);
  }
}

}  // namespace

LocalDensity& operator+=(LocalDensity& a, const LocalDensity& b) {
  for (const auto& [monomial, coefficient] : b) add_to(a, monomial, coefficient);
  return a;
}

LocalDensity act(const LocalDensity& density, const LocalConstants& constants) {
  LocalDensity result;
  for (const auto& [monomial, coefficient] : density) {
    if (monomial.logs < 0 || monomial.logs > 8) throw std::domain_error("local action: between 0 and 8 logarithms");
    const Image image =
        monomial.fractional ? fractional_image(monomial.logs, constants) : integer_image(monomial.logs, constants.pi);
    // The mirror image has the opposite sign. Writing x^n instead of |x|^n accounts for the rest.
    const ex factor = monomial.side == Side::right ? coefficient : -coefficient;
    add_image(result, monomial, monomial.side, image.same, factor);
    add_image(result, monomial, opposite(monomial.side), image.other, factor);
  }
  return result;
}

ex far_part(const LocalMonomial& monomial, const ex& lambda, const ex& x, int terms) {
  const bool right = monomial.side == Side::right;
  const ex power = monomial.fractional ? lambda : ex(0);
  ex sum = 0;
  // In y = |x| on the side of the density. The order is part of the exponent, so the series starts at x^0.
  const ex exponent = power + monomial.order;
  const ex y = right ? x : ex(-x);
  for (int k = 0; k < terms; ++k) {
    const ex gap = k - exponent;
    if (!gap.is_zero()) sum += GiNaC::pow(y, k) / GiNaC::pow(gap, monomial.logs + 1);
  }
  const ex mirrored = right || monomial.order % 2 != 0 ? 1 : -1;
  return -mirrored * factorial(monomial.logs) / GiNaC::Pi * sum;
}

}  // namespace steadyslide::symbolic
