#include "library/problem_file/problem_file.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;

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
  CHECK(problem == ContactProblem(Elasticity(Solid(-0.2_r, 210000), Plane::stress),
                                  FrictionProfile({0, Rational(1, 3), 0.1_r}, {-0.5_r, 0.25_r}),
                                  Indenter(-2, {{0, Polynomial({0, -0.5_r})}, {1.5_r, Polynomial({1, 0, 1})}}), 2.5_r,
                                  Sliding::minus_x, Rational(1, 3)));
}

TEST_CASE("defaults") {
  const Problem problem =
      parse_problem("load = 1\nhalf_space = {poisson = 0.3}\nfriction.values = [0.1]\nindenter.profile = 'x'\n", "f");
  CHECK(problem.contact == ContactProblem(Elasticity(Solid(0.3_r, 1), Plane::strain), FrictionProfile({0.1_r}),
                                          Indenter(-1, {{1, Polynomial({0, 1})}}), 1, Sliding::plus_x));
}

TEST_CASE("reduced data and an elastic indenter") {
  const std::string rest = "load = 1\nfriction.values = [0.1]\nindenter.profile = 'x^2'\n";
  const auto elasticity = [&](const std::string& text) { return parse_problem(rest + text, "f").contact.elasticity(); };
  CHECK(elasticity("half_space.gamma = '-2/7'\n") == Elasticity::reduced(Rational(-2, 7)));
  CHECK(elasticity("half_space.poisson = 0.3\nindenter.elastic = {poisson = 0.1, young = '1/2'}\n") ==
        Elasticity(Solid(0.3_r, 1), Solid(0.1_r, 0.5_r)));
}

TEST_CASE("a key of an inline table is found on its line") {
  CHECK(thrown_by([] {
          parse_problem("load = 1\nhalf_space = {poisson = 0.6}\nfriction.values = [0.1]\nindenter.profile = 'x'\n",
                        "f");
        }) == "f:2: half_space.poisson: Poisson's ratio out of range; it lies in ]-1, 1/2[; 0.6");
}

TEST_CASE("layers from the surface down, a period, a table of symbols") {
  const auto problem = [](const std::string& half_space) {
    return parse_problem("load = 1\nfriction.values = [0.1]\nindenter.profile = '0'\n[half_space]\n" + half_space, "f")
        .contact;
  };
  const Solid soft(0.45_r, 2), hard(0, 5);
  const ContactProblem layered = problem(R"(poisson = 0.3
young = 210
plane = "stress"
layers = [ {thickness = "1/2", young = 2, poisson = 0.45}, {thickness = 2, young = 5, poisson = 0, below = "slip"} ]
)");
  CHECK(layered.elasticity() == Elasticity(soft, Plane::stress));
  CHECK(layered.body() == Body::layered({{0.5_r, soft}, {2, hard, Interface::slip}}, Solid(0.3_r, 210)));
  const std::string on_rock = "base = 'rigid'\nlayers = [ {thickness = 1, young = 2, poisson = 0.45, below = 'slip'} ]";
  CHECK(problem(on_rock).body() == Body::layered({{1, soft, Interface::slip}}, std::nullopt));
  CHECK(problem("gamma = 0.2\nperiod = 3").body() == Body::periodic(3));
  CHECK(problem("gamma = 0.2\nsymbol = \"k,W,gV\\n1,1/2,0.1\\n2,1,0.2\\n\"").body() ==
        Body::of_symbols({{1, 0.5_r, 0.1_r}, {2, 1, 0.2_r}}));
}
