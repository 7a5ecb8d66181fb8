#pragma once
// A complex number as two balls, with the precision of computations with it, like Ball.

#include <acb.h>

#include "checker/ball.hpp"

namespace steadyslide::checker {

class Complex {
 public:
  Complex(const Ball& re = 0, const Ball& im = 0) : precision_(std::min(re.precision(), im.precision())) {
    acb_init(z_);
    acb_set_arb_arb(z_, re.get(), im.get());
  }
  Complex(const acb_t z, slong precision) : Complex() {
    acb_set(z_, z);
    precision_ = precision;
  }
  Complex(const Complex& other) : Complex(other.z_, other.precision_) {}
  Complex& operator=(Complex other) noexcept {
    acb_swap(z_, other.z_);
    std::swap(precision_, other.precision_);
    return *this;
  }
  ~Complex() { acb_clear(z_); }

  acb_ptr get() { return z_; }
  acb_srcptr get() const { return z_; }
  slong precision() const { return precision_; }
  Ball re() const { return part(acb_realref(z_)); }
  Ball im() const { return part(acb_imagref(z_)); }
  Complex times_i() const { return {-im(), re()}; }

  friend Complex operator+(const Complex& a, const Complex& b) { return of(acb_add, a, b); }
  friend Complex operator-(const Complex& a, const Complex& b) { return of(acb_sub, a, b); }
  friend Complex operator*(const Complex& a, const Complex& b) { return of(acb_mul, a, b); }
  friend Complex operator/(const Complex& a, const Complex& b) { return of(acb_div, a, b); }
  friend Complex exp(const Complex& z) { return z.of(acb_exp); }
  friend Complex sin_pi(const Complex& z) { return z.of(acb_sin_pi); }
  friend Complex cos_pi(const Complex& z) { return z.of(acb_cos_pi); }
  friend Complex cot_pi(const Complex& z) { return z.of(acb_cot_pi); }
  /// Returns sin(pi z)/(pi z).
  friend Complex sinc_pi(const Complex& z) { return z.of(acb_sinc_pi); }
  /// Returns log z; NaN if it is not analytic in the whole ball.
  friend Complex log(const Complex& z) {
    Complex result(z);
    acb_log_analytic(result.z_, z.z_, 1, z.precision_);
    return result;
  }

 private:
  Ball part(arb_srcptr x) const {
    Ball result = Ball().rounded(precision_);
    arb_set(result.get(), x);
    return result;
  }
  template <class Operation>
  Complex of(Operation operation) const {
    Complex result(*this);
    operation(result.z_, z_, precision_);
    return result;
  }
  template <class Operation>
  static Complex of(Operation operation, const Complex& a, const Complex& b) {
    Complex result;
    result.precision_ = std::min(a.precision_, b.precision_);
    operation(result.z_, a.z_, b.z_, result.precision_);
    return result;
  }

  acb_t z_;
  slong precision_;
};

}  // namespace steadyslide::checker
