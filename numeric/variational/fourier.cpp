#include "numeric/variational/fourier.hpp"

#include <fftw3.h>

#include <algorithm>
#include <mutex>
#include <thread>

namespace steadyslide::numeric::variational {
namespace {

// FFTW's planner, unlike its transforms, is not to be called from two threads.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

/// Threads of one transform: short ones are over before a second thread has begun (docs/libraries.md).
int threads(std::size_t n) {
  constexpr std::size_t longest_alone = std::size_t{1} << 18;
  return n <= longest_alone ? 1 : static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 4U));
}

}  // namespace

struct Fourier::Plans {
  double* values;
  fftw_complex* modes;  // in the same place
  fftw_plan forward;
  fftw_plan backward;

  explicit Plans(std::size_t n) {
    const std::lock_guard lock(planner());
    static const int available = fftw_init_threads();
    if (available != 0) fftw_plan_with_nthreads(threads(n));
    modes = fftw_alloc_complex(n / 2 + 1);
    if (modes == nullptr) throw std::bad_alloc();
    values = reinterpret_cast<double*>(modes);
    forward = fftw_plan_dft_r2c_1d(static_cast<int>(n), values, modes, FFTW_ESTIMATE);
    backward = fftw_plan_dft_c2r_1d(static_cast<int>(n), modes, values, FFTW_ESTIMATE);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
  ~Plans() {
    const std::lock_guard lock(planner());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
    fftw_free(modes);
  }
};

Fourier::Fourier(std::size_t n) : size_(n), plans_(std::make_unique<Plans>(n)) {}
Fourier::~Fourier() = default;
Fourier::Fourier(Fourier&&) noexcept = default;
Fourier& Fourier::operator=(Fourier&&) noexcept = default;

std::span<double> Fourier::values() const { return {plans_->values, size_}; }

std::span<std::complex<double>> Fourier::modes() const {
  // FFTW's complex numbers are laid out like C++'s.
  return {reinterpret_cast<std::complex<double>*>(plans_->modes), size_ / 2 + 1};
}

void Fourier::forward() const { fftw_execute(plans_->forward); }
void Fourier::backward() const { fftw_execute(plans_->backward); }

}  // namespace steadyslide::numeric::variational
