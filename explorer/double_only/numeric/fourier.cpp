#include "numeric/variational/fourier.hpp"

#include <unsupported/Eigen/FFT>
#include <vector>

namespace steadyslide::numeric::variational {

struct Fourier::Plans {
  std::vector<double> values;
  std::vector<std::complex<double>> modes;
  Eigen::FFT<double> transform{
      Eigen::default_fft_impl<double>(),
      static_cast<Eigen::FFT<double>::Flag>(Eigen::FFT<double>::HalfSpectrum | Eigen::FFT<double>::Unscaled)};
};

Fourier::Fourier(std::size_t n)
    : size_(n), plans_(new Plans{std::vector<double>(n), std::vector<std::complex<double>>(n / 2 + 1)}) {}
Fourier::~Fourier() = default;
Fourier::Fourier(Fourier&&) noexcept = default;
Fourier& Fourier::operator=(Fourier&&) noexcept = default;

std::span<double> Fourier::values() const { return plans_->values; }
std::span<std::complex<double>> Fourier::modes() const { return plans_->modes; }

void Fourier::forward() const {
  plans_->transform.fwd(plans_->modes.data(), plans_->values.data(), static_cast<Eigen::Index>(size_));
}
void Fourier::backward() const {
  plans_->transform.inv(plans_->values.data(), plans_->modes.data(), static_cast<Eigen::Index>(size_));
}

}  // namespace steadyslide::numeric::variational
