#include "numeric/quadrature/gsl_quadrature.hpp"

#include <stdexcept>

namespace steadyslide::numeric::gsl {

Estimate<double> hilbert(const PiecewiseDensity<double>&, const PanelPoint<double>&) {
  throw std::invalid_argument("this build has no GSL");
}

}  // namespace steadyslide::numeric::gsl
