#pragma once
// An indenter and the surface below it, drawn to scale.

#include "app/figures/solved.hpp"

namespace steadyslide::app {

/// A problem under one polynomial, and its solution.
struct Scene {
  ContactProblem problem;
  std::shared_ptr<const numeric::ContactSolution<double>> solution = solved(problem);

  double profile(double x) const;
  /// The height of the surface at x inside the support.
  double surface(double x) const;

  /// The curve at equal steps from one place to another.
  std::vector<Point> profile_curve(double from, double to) const { return points(&Scene::profile, from, to); }
  std::vector<Point> surface_curve(double from, double to) const { return points(&Scene::surface, from, to); }

 private:
  std::vector<Point> points(double (Scene::*height)(double) const, double from, double to) const;
};

/// Makes a unit as long upwards as across, so that angles are true. The y axis keeps its upper end.
void make_isotropic(Panel& panel, int height);

}  // namespace steadyslide::app
