#include <algorithm>

#include "numeric/variational/fourier.hpp"

namespace steadyslide::numeric::variational {

std::size_t fast_length(std::size_t n) {
  const auto is_fast = [](std::size_t sixteenth) {
    for (const std::size_t prime : {2U, 3U, 5U}) {
      while (sixteenth % prime == 0) sixteenth /= prime;
    }
    return sixteenth == 1;
  };
  std::size_t sixteenth = std::max<std::size_t>((n + 15) / 16, 1);
  while (!is_fast(sixteenth)) ++sixteenth;
  return 16 * sixteenth;
}

}  // namespace steadyslide::numeric::variational
