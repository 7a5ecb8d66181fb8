#include "numeric/variational/fourier.hpp"

#include <algorithm>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace steadyslide::numeric::variational {

struct Fourier::Plans {
  std::vector<double> values;
  std::vector<std::complex<double>> modes;
  std::vector<std::complex<double>> products;
  Eigen::FFT<double> transform{Eigen::default_fft_impl<double>(),
                               static_cast<Eigen::FFT<double>::Flag>(Eigen::FFT<double>::HalfSpectrum)};
};

Fourier::Fourier(std::size_t n)
    : size_(n),
      plans_(new Plans{std::vector<double>(n), std::vector<std::complex<double>>(n / 2 + 1),
                       std::vector<std::complex<double>>(n / 2 + 1)}) {}
Fourier::~Fourier() = default;
Fourier::Fourier(Fourier&&) noexcept = default;
Fourier& Fourier::operator=(Fourier&&) noexcept = default;

std::span<double> Fourier::values() const { return plans_->values; }
std::span<std::complex<double>> Fourier::modes() const { return plans_->modes; }

void Fourier::forward() const {
  plans_->transform.fwd(plans_->modes.data(), plans_->values.data(), static_cast<Eigen::Index>(size_));
}
void Fourier::convolve(std::span<const std::complex<double>> s, std::span<double> result) const {
  for (std::size_t k = 0; k < s.size(); ++k) plans_->products[k] = s[k] * plans_->modes[k];
  plans_->transform.inv(plans_->values.data(), plans_->products.data(), static_cast<Eigen::Index>(size_));
  if (result.data() != plans_->values.data()) std::copy_n(plans_->values.begin(), result.size(), result.begin());
}

}  // namespace steadyslide::numeric::variational
