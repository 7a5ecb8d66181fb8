#pragma once
// The discrete Fourier transform of real data of one length (FFTW, double). [FJ05]
//
//   y_k = sum_j x_j exp(-2 pi i j k/n), k = 0..n/2, the y beyond n/2 the conjugates of those before,
//
// and what is left of x when each y is multiplied by a number s_k: a convolution.

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace steadyslide::numeric::variational {

/// A length >= n whose transforms are fast: a multiple of 16 without prime factors above 5.
std::size_t fast_length(std::size_t n);

class Fourier {
 public:
  /// n even. FFTW chooses its way by the length alone, so that a result can be had again to the last digit.
  explicit Fourier(std::size_t n);
  ~Fourier();
  Fourier(Fourier&&) noexcept;
  Fourier& operator=(Fourier&&) noexcept;

  std::size_t size() const { return size_; }
  /// Room for x, n numbers, and for y, n/2 + 1 of them. One room, since transforms that have to leave the cache are up to 1.7
  /// times as fast in place: only the one that was written last is there.
  std::span<double> values() const;
  std::span<std::complex<double>> modes() const;
  /// values() to modes().
  void forward() const;
  /// The first numbers (1/n) sum_k s_k y_k exp(2 pi i j k/n), at most n, of y in modes(), which stays there. `result` may
  /// lie in values().
  void convolve(std::span<const std::complex<double>> s, std::span<double> result) const;

 private:
  struct Plans;
  std::size_t size_;
  std::unique_ptr<Plans> plans_;
};

}  // namespace steadyslide::numeric::variational
