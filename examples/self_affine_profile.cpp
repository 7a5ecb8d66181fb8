// A rough profile for `samples`: a parabola x^2/(2 radius) on [-1, 1] with self-affine roughness, as CSV. The roughness
// is a sum of waves with random phases and amplitudes ~ k^(-hurst - 1/2), from the longest to the shortest wavelength.
// The same parameters give the same profile everywhere: the phases come from the generator's bits alone.
//
//   self_affine_profile [points=4001] [radius=8] [hurst=0.8] [rms=0.003] [longest=0.5] [shortest=0.01] [seed=1]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  std::map<std::string, double> given{{"points", 4001}, {"radius", 8},      {"hurst", 0.8}, {"rms", 0.003},
                                      {"longest", 0.5}, {"shortest", 0.01}, {"seed", 1}};
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    const std::size_t name = std::min(argument.find('='), argument.size());
    const auto parameter = given.find(argument.substr(0, name));
    const double value = std::atof(argument.substr(name).erase(0, 1).c_str());
    if (parameter == given.end() || !(value > 0 && value < 1e6)) {
      std::fprintf(stderr, "self_affine_profile: %s: not a parameter=value; see the source's first lines\n", argv[k]);
      return 2;
    }
    parameter->second = value;
  }
  constexpr double length = 2;
  const int points = static_cast<int>(given["points"]);
  const int first = static_cast<int>(std::lround(length / given["longest"]));
  const int last = static_cast<int>(std::lround(length / given["shortest"]));
  if (points < 2 || first < 1 || last < first || last > points / 2) {
    std::fprintf(stderr, "self_affine_profile: %d points, waves %d to %d: too few for each other\n", points, first,
                 last);
    return 2;
  }

  std::mt19937_64 generator(static_cast<unsigned>(given["seed"]));
  std::vector<double> height(static_cast<std::size_t>(points));
  double power = 0;  // the mean of the squared height of all waves
  for (int k = first; k <= last; ++k) {
    const double phase = 2 * std::numbers::pi * static_cast<double>(generator() >> 11) * 0x1p-53;
    const double amplitude = std::pow(k, -given["hurst"] - 0.5);
    power += amplitude * amplitude / 2;
    for (int i = 0; i < points; ++i) {
      height[static_cast<std::size_t>(i)] += amplitude * std::cos(2 * std::numbers::pi * k * i / (points - 1) + phase);
    }
  }

  std::printf("# self-affine roughness on a parabola:");
  for (const auto& [name, value] : given) std::printf(" %s=%g", name.c_str(), value);
  std::printf("\nx,psi\n");
  for (int i = 0; i < points; ++i) {
    const double x = length * i / (points - 1) - length / 2;
    const double rough = given["rms"] / std::sqrt(power) * height[static_cast<std::size_t>(i)];
    std::printf("%.10g,%.10f\n", x, x * x / (2 * given["radius"]) + rough);
  }
}
