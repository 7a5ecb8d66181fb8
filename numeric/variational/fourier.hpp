#pragma once
// The discrete Fourier transform of real data of one length (FFTW, double). [FJ05]
//
//   y_k = sum_j x_j exp(-2 pi i j k/n), k = 0..n/2; the y beyond n/2 are conjugates of these,
//
// and the convolution of x, in which each y_k is multiplied by a number s_k.

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace steadyslide::numeric::variational {

/// Returns a length >= n with fast transforms: a multiple of 16 without prime factors above 5.
std::size_t fast_length(std::size_t n);

class Fourier {
 public:
  /// n must be even. FFTW chooses its algorithm by the length only, so results are reproducible to the last digit.
  explicit Fourier(std::size_t n);
  ~Fourier();
  Fourier(Fourier&&) noexcept;
  Fourier& operator=(Fourier&&) noexcept;

  std::size_t size() const { return size_; }
  /// Space for x, n numbers, and for y, n/2 + 1 numbers. Both share one space, because transforms larger than the cache
  /// are up to 1.7 times as fast in place. So only the data that was written last is valid.
  std::span<double> values() const;
  std::span<std::complex<double>> modes() const;
  /// Transforms values() to modes().
  void forward() const;
  /// Computes the first numbers (1/n) sum_k s_k y_k exp(2 pi i j k/n), at most n, from y in modes(), which does not
  /// change. `result` may be part of values().
  void convolve(std::span<const std::complex<double>> s, std::span<double> result) const;

 private:
  struct Plans;
  std::size_t size_;
  std::unique_ptr<Plans> plans_;
};

}  // namespace steadyslide::numeric::variational
