#pragma once
// A smooth slope as Chebyshev series on panels of the support, and as polynomials of low degree on many pieces. The
// Riemann-Hilbert method extends the polynomial of each piece to the whole contact, where its terms grow like
// (distance/r)^degree, with r the distance of the slope's nearest singularity. So the pieces are as long as possible for
// the degree at which truncation and these terms lose the same number of digits.

#include <functional>
#include <vector>

#include "model/contact_problem.hpp"

namespace steadyslide::numeric {

class SmoothSlope {
 public:
  /// Makes the panels for a slope on the support with singularities at the distance radius(x) from x. The contact lies
  /// in [left, right]. Without panels and nodes if a radius is not positive and finite.
  SmoothSlope(const Indenter& indenter, double left, double right, const std::function<double(double)>& radius);

  /// Returns the places at which the slope is given.
  const std::vector<double>& nodes() const { return nodes_; }
  /// Sets the slope by its values at the nodes.
  void set(std::vector<double> values);
  /// Few pieces for a fast solution, or many for a good one.
  enum class Detail { rough, fine };
  /// Returns the problem on the half-plane with `factor` times the slope added to psi'.
  ContactProblem added_to(const ContactProblem& problem, const Rational& factor, Detail detail) const;
  /// Returns the estimated error of the polynomials in a contact, relative to the largest value.
  double relative_error(Detail detail) const { return detail == Detail::rough ? rough_error_ : fine_error_; }

 private:
  struct Division {
    int pieces = 1;
    int degree = 0;
    double error = 1;
  };
  struct Panel {
    double left;
    double right;
    Division rough;
    Division fine;
    std::vector<double> series;  ///< coefficients of Chebyshev's polynomials

    double at(double x) const;
  };

  /// Returns the best division of a panel into at most `most` pieces.
  static Division division(double length, double distance, double radius, int most);

  std::vector<Panel> panels_;
  std::vector<double> nodes_;
  double rough_error_ = 0;
  double fine_error_ = 0;
};

}  // namespace steadyslide::numeric
