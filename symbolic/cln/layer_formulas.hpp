#pragma once
// The surface symbols of one layer on a base in closed form, for expressions and for numbers. With xi = k h, e =
// exp(-2 xi), and gamma and kappa of the layer:
//
//   bonded:    D = 1 - (K + L + 4 K xi^2) e + K L e^2,   W = (1 + 4 K xi e - K L e^2)/D,
//              gamma - gamma V = (K - L - 4 K xi^2) e/D,
//   slipping:  D = 1 + (rho (1 + 2 xi + 2 xi^2) - (1 - 2 xi + 2 xi^2)) e - rho e^2,
//              W = (1 - (1 + rho - 2 (1 - rho) xi) e + rho e^2)/D,   gamma - gamma V = 2 xi (1 + rho - (1 - rho) xi) e/D,
//
//   elastic base:  K = (1-n)/(1+n kappa),   L = (kappa_b - n kappa)/(kappa_b + n),   rho = (1-m)/(1+m),
//                  n = mu_b/mu,   m = c_b/c = (kappa_b + 1)/(n (kappa + 1)),
//   rigid base:    K = -1/kappa,   L = -kappa,   rho = 1.
//
// K and L are the constants of two layers in [Burmister, J. Appl. Phys. 16 (1945) 89]. The statements equation-layer-*
// decide the formulas (symbolic/statements/written/layers.txt).

namespace steadyslide::symbolic {

template <class T>
struct LayerFormula {
  T normal;           ///< W
  T coupling_defect;  ///< gamma - gamma V
};

template <class T>
LayerFormula<T> bonded_layer(const T& K, const T& L, const T& xi, const T& e) {
  const T below = 1 - (K + L + 4 * K * xi * xi) * e + K * L * e * e;
  return {(1 + 4 * K * xi * e - K * L * e * e) / below, (K - L - 4 * K * xi * xi) * e / below};
}

template <class T>
LayerFormula<T> slipping_layer(const T& rho, const T& xi, const T& e) {
  const T below = 1 + (rho * (1 + 2 * xi + 2 * xi * xi) - (1 - 2 * xi + 2 * xi * xi)) * e - rho * e * e;
  return {(1 - (1 + rho - 2 * (1 - rho) * xi) * e + rho * e * e) / below,
          2 * xi * (1 + rho - (1 - rho) * xi) * e / below};
}

}  // namespace steadyslide::symbolic
