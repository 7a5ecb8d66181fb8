#include "proofs_checks/instruments/operators/angle_forms.hpp"

#include "numeric/quadrature/double_exponential_rule.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::UnitRule;

constexpr std::size_t form_size = highest_angle + 1;

/// Returns cos(k angle), k = 0, 1, ..., from the cosine of the angle.
template <class R>
std::vector<R> cosines(const R& cosine) {
  std::vector<R> result{R(1), cosine};
  for (int k = 2; k <= highest_angle; ++k) result.push_back(2 * cosine * result.end()[-1] - result.end()[-2]);
  return result;
}

template <class R>
constexpr int gauss_nodes = std::same_as<R, double>   ? 24
                            : std::same_as<R, Real50> ? 44
                                                      : 80;

}  // namespace

template <class R>
FormMatrix<R> log_form_by_quadrature(const R& length) {
  using std::cos, std::log, std::sin;
  const R pi = numeric::pi<R>();
  const UnitRule<R> rule = numeric::double_exponential_rule<R>();
  FormMatrix<R> form(form_size, std::vector<R>(form_size, R(0)));
  constexpr int outer = highest_angle + 1;  // exact up to cos(2 highest_angle angle)
  for (int i = 0; i < outer; ++i) {
    const R angle = pi * (2 * i + 1) / (2 * outer);
    std::vector<R> inner(form_size, R(0));
    for (const bool beyond : {false, true}) {
      const R range = beyond ? R(pi - angle) : angle;
      for (std::size_t m = 0; m < rule.size(); ++m) {
        const R apart = range * rule.from_left[m];
        const R other = beyond ? R(angle + apart) : R(angle - apart);
        // This computes |cos a - cos b| without a subtraction.
        const R distance = length * sin(apart / 2) * sin((angle + other) / 2);
        const R weight = -range * rule.weights[m] * log(distance);
        const std::vector<R> values = cosines(R(cos(other)));
        for (std::size_t k = 0; k < inner.size(); ++k) inner[k] += weight * values[k];
      }
    }
    const std::vector<R> values = cosines(R(cos(angle)));
    for (std::size_t j = 0; j < inner.size(); ++j) {
      for (std::size_t k = 0; k < inner.size(); ++k) form[j][k] += pi / outer * values[j] * inner[k];
    }
  }
  return form;
}

namespace {

template <class R>
FormMatrix<R> sign_form() {
  using std::cos;
  const R pi = numeric::pi<R>();
  const UnitRule<R> rule = numeric::jacobi_rule<R>({R(0), R(1)}, {R(0), R(1)}, gauss_nodes<R>);
  FormMatrix<R> form(form_size, std::vector<R>(form_size, R(0)));
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const R angle = pi * rule.from_left[i];
    const std::vector<R> outer = cosines(R(cos(angle)));
    for (std::size_t m = 0; m < rule.size(); ++m) {
      // If theta > phi, the point x(theta) lies left of x(phi).
      const R before = angle * rule.from_left[m];
      const R after = angle + (pi - angle) * rule.from_left[m];
      const std::vector<R> right = cosines(R(cos(before)));
      const std::vector<R> left = cosines(R(cos(after)));
      const R weight = pi * rule.weights[i] * rule.weights[m];
      for (std::size_t j = 0; j < left.size(); ++j) {
        const R inner = (pi - angle) * left[j] - angle * right[j];
        for (std::size_t k = 0; k < outer.size(); ++k) form[j][k] += weight * inner * outer[k];
      }
    }
  }
  return form;
}

}  // namespace

template <class R>
const FormMatrix<R>& sign_form_by_quadrature() {
  static const FormMatrix<R> form = sign_form<R>();
  return form;
}

#define STEADYSLIDE_INSTANTIATE(R)                         \
  template FormMatrix<R> log_form_by_quadrature(const R&); \
  template const FormMatrix<R>& sign_form_by_quadrature();
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
