#include "app/problem_file/problem_file.hpp"
#include "support/test.hpp"

using namespace steadyslide::app;

TEST_CASE("everything that a problem file can say") {
  const ContactProblem problem = parse_problem(R"(
load = 2.5
load_at = "1/3"
sliding = "-x"
[half_space]
poisson = "-0.2"
young = 210e3
plane = "stress"
[friction]
values = [0, "1/3", 0.1]
jumps = ["-0.5", 0.25]
[indenter]
support = [-2, "3/2"]
pieces = [{to = 0, profile = "-x/2"}, {to = "1.5", profile = "x^2 + 1"}]
)",
                                               "f")
                                     .contact;
  CHECK(problem.load() == Rational(5, 2));
  CHECK(problem.load_at() == Rational(1, 3));
  CHECK(problem.sliding() == Sliding::minus_x);
  CHECK(problem.elasticity().half_space()->poisson() == Rational(-1, 5));
  CHECK(problem.elasticity().half_space()->young() == 210000);
  CHECK(problem.elasticity().plane() == Plane::stress);
  CHECK(problem.friction().values() == std::vector<Rational>{0, Rational(1, 3), Rational(1, 10)});
  CHECK(problem.friction().jumps() == std::vector<Rational>{Rational(-1, 2), Rational(1, 4)});
  CHECK(problem.indenter().left() == -2);
  CHECK(problem.indenter().right() == Rational(3, 2));
  REQUIRE(problem.indenter().pieces().size() == 2);
  CHECK(problem.indenter().pieces()[0].profile == Polynomial({0, Rational(-1, 2)}));
  CHECK(problem.indenter().pieces()[1].profile == Polynomial({1, 0, 1}));
}

TEST_CASE("defaults") {
  const Problem problem =
      parse_problem("load = 1\nhalf_space = {poisson = 0.3}\nfriction.values = [0.1]\nindenter.profile = 'x'\n", "f");
  CHECK(problem.contact.sliding() == Sliding::plus_x);
  CHECK(problem.contact.elasticity().half_space()->young() == 1);
  CHECK(problem.contact.elasticity().plane() == Plane::strain);
  CHECK(problem.contact.indenter().left() == -1);
  CHECK(problem.contact.indenter().right() == 1);
  CHECK_FALSE(problem.contact.load_at());
}

TEST_CASE("reduced data and an elastic indenter") {
  const std::string rest = "load = 1\nfriction.values = [0.1]\nindenter.profile = 'x^2'\n";
  const Problem reduced = parse_problem(rest + "half_space.gamma = '-2/7'\n", "f");
  CHECK(reduced.contact.elasticity().gamma() == Rational(-2, 7));
  CHECK(reduced.contact.elasticity().compliance() == 1);
  const Problem elastic =
      parse_problem(rest + "half_space.poisson = 0.3\nindenter.elastic = {poisson = 0.1, young = '1/2'}\n", "f");
  CHECK(elastic.contact.elasticity().indenter()->poisson() == Rational(1, 10));
  CHECK(elastic.contact.elasticity().indenter()->young() == Rational(1, 2));
}

TEST_CASE("a key of an inline table is found on its line") {
  CHECK(thrown_by([] {
          parse_problem("load = 1\nhalf_space = {poisson = 0.6}\nfriction.values = [0.1]\nindenter.profile = 'x'\n",
                        "f");
        }) == "f:2: half_space.poisson: Poisson's ratio out of range; it lies in ]-1, 1/2[; 0.6");
}
