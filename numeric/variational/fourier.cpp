#include "numeric/variational/fourier.hpp"

#include <fftw3.h>

#include <algorithm>
#include <mutex>
#include <thread>

namespace steadyslide::numeric::variational {
namespace {

// FFTW's planner, unlike its transforms, is not thread-safe.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

/// Returns the number of threads of one transform. Short transforms end before a second thread has started
/// (docs/decisions.md).
int threads(std::size_t n) {
  constexpr std::size_t longest_alone = std::size_t{1} << 18;
  return n <= longest_alone ? 1 : static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 4U));
}

}  // namespace

struct Fourier::Plans {
  double* values;
  fftw_complex* modes;  // at the same address
  double* sums;         // space for another transform
  fftw_plan forward;

  explicit Plans(std::size_t n) {
    const std::lock_guard lock(planner());
    static const int available = fftw_init_threads();
    if (available != 0) fftw_plan_with_nthreads(threads(n));
    modes = fftw_alloc_complex(n / 2 + 1);
    sums = fftw_alloc_real(n + 2);
    if (modes == nullptr || sums == nullptr) {
      fftw_free(modes);
      fftw_free(sums);
      throw std::bad_alloc();
    }
    values = reinterpret_cast<double*>(modes);
    forward = fftw_plan_dft_r2c_1d(static_cast<int>(n), values, modes, FFTW_ESTIMATE);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
  ~Plans() {
    const std::lock_guard lock(planner());
    fftw_destroy_plan(forward);
    fftw_free(modes);
    fftw_free(sums);
  }
};

Fourier::Fourier(std::size_t n) : size_(n), plans_(std::make_unique<Plans>(n)) {}
Fourier::~Fourier() = default;
Fourier::Fourier(Fourier&&) noexcept = default;
Fourier& Fourier::operator=(Fourier&&) noexcept = default;

std::span<double> Fourier::values() const { return {plans_->values, size_}; }

std::span<std::complex<double>> Fourier::modes() const {
  // FFTW's complex numbers have the memory layout of C++'s.
  return {reinterpret_cast<std::complex<double>*>(plans_->modes), size_ / 2 + 1};
}

void Fourier::forward() const { fftw_execute(plans_->forward); }

void Fourier::convolve(std::span<const std::complex<double>> s, std::span<double> result) const {
  // With h_k = re(s_k y_k) + im(s_k y_k), k = 0..n-1, and H its transform, x_j = re(H_j) + im(H_j). So this is a
  // forward transform again, which takes two thirds of the time of FFTW's backward transform for data larger than the
  // cache.
  const std::span<const std::complex<double>> y = modes();
  double* const h = plans_->sums;
  const double scale = 1 / static_cast<double>(size_);
  const std::size_t half = size_ / 2;
  for (std::size_t k = 0; k <= half; ++k) {
    const double re = scale * (s[k].real() * y[k].real() - s[k].imag() * y[k].imag());
    const double im = scale * (s[k].real() * y[k].imag() + s[k].imag() * y[k].real());
    if (k > 0) h[size_ - k] = re - im;
    if (k < half) h[k] = re + im;
  }
  auto* const transformed = reinterpret_cast<fftw_complex*>(h);
  fftw_execute_dft_r2c(plans_->forward, h, transformed);
  for (std::size_t j = 0; j < result.size(); ++j) {
    const auto& mode = transformed[std::min(j, size_ - j)];
    result[j] = j <= half ? mode[0] + mode[1] : mode[0] - mode[1];
  }
}

}  // namespace steadyslide::numeric::variational
