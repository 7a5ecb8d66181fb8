// Prints the answer to a problem file, using only the library: g++ -std=c++20 answer_of_the_library.cpp $(pkg-config
// --cflags --libs steadyslide). The first argument is the file; without one, the problem in this source is solved.

#include <iostream>
#include <steadyslide/steadyslide.hpp>

int main(int argc, char** argv) try {
  const steadyslide::Problem problem =
      argc > 1 ? steadyslide::read_problem(argv[1])
               : steadyslide::ProblemData{
                     .load = 1, .friction = {"0.1", "0.5"}, .jumps = {0}, .poisson = "0.2", .profile = "0"};
  const steadyslide::Solution solution = steadyslide::solve(problem, {.digits = 50});
  if (!solution.solved()) std::cerr << "not solved: " << solution.failed_condition() << '\n';
  std::cout << "effective friction:  " << solution.effective_friction().digits << '\n'
            << "traction at x = 1/2: " << solution.traction("1/2").digits << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
