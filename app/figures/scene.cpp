#include "app/figures/scene.hpp"

namespace steadyslide::app {

double Scene::profile(double x) const {
  return numeric::to_real<double>(problem.indenter().pieces().front().profile(Rational(x)));
}

double Scene::surface(double x) const { return profile(x) - solution->at(Rational(x)).gap->value; }

std::vector<Point> Scene::points(double (Scene::*height)(double) const, double from, double to) const {
  constexpr int steps = 400;
  std::vector<Point> result;
  for (int i = 0; i <= steps; ++i) {
    const double x = from + (to - from) * i / steps;
    result.push_back({x, (this->*height)(x)});
  }
  return result;
}

void make_isotropic(Panel& panel, int height) {
  const Frame& frame = panel.frame;
  const double unit = 800 * (frame.right - frame.left) / (panel.x.to - panel.x.from);
  panel.y.from = panel.y.to - height * (frame.top - frame.bottom) / unit;
}

}  // namespace steadyslide::app
