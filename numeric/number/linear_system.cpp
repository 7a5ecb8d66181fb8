#include "numeric/number/linear_system.hpp"

#include <algorithm>

namespace steadyslide::numeric {

template <Real R>
std::optional<std::vector<R>> solve_linear(std::vector<std::vector<R>> rows) {
  const std::size_t n = rows.size();
  for (std::vector<R>& row : rows) {
    R largest = 0;
    for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, R(abs(row[k])));
    if (!(largest > 0)) return std::nullopt;
    for (R& entry : row) entry /= largest;
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (abs(rows[i][k]) > abs(rows[pivot][k])) pivot = i;
    }
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const R factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k + 1; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<R> x(n);
  for (std::size_t k = n; k-- > 0;) {
    x[k] = rows[k][n] / rows[k][k];
    for (std::size_t i = 0; i < k; ++i) rows[i][n] -= rows[i][k] * x[k];
  }
  return x;
}

#define STEADYSLIDE_INSTANTIATE(R) template std::optional<std::vector<R>> solve_linear(std::vector<std::vector<R>>);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
