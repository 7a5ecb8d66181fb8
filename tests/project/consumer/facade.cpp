// The facade's header includes no header of other projects.
#include <iostream>
#include <steadyslide/steadyslide.hpp>

#if defined(BOOST_VERSION) || defined(__GNU_MP_VERSION) || defined(EIGEN_WORLD_VERSION)
#error "the facade includes headers of other projects"
#endif

int main() {
  const steadyslide::Problem problem =
      steadyslide::ProblemData{.load = 1, .friction = {"0.2"}, .poisson = "0.3", .profile = "0"};
  std::cout << "effective friction " << steadyslide::solve(problem).effective_friction().digits << '\n';
  try {
    steadyslide::Problem::from_text("load = -1");
  } catch (const steadyslide::InvalidData& invalid) {
    std::cout << invalid.what() << '\n';
  }
}
