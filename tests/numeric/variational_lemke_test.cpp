// Lemke's method: solutions of the random list, all solutions of small problems, and what it must refuse.

#include "numeric/variational/lemke.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/random_contact.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric::variational;
using steadyslide::testing::first_listed_seed;
using steadyslide::testing::random_contact;

namespace {

void meets_its_loads(const DiscreteProblem& problem, const DiscreteState& state) {
  double load = 0;
  double moment = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const double q = state.pressure[i] * problem.mesh().length(i);
    load += q;
    moment += q * problem.mesh().centre(i);
  }
  CHECK(std::abs(load - 1) <= 1e-12);
  if (problem.load_at()) CHECK(std::abs(moment - *problem.load_at()) <= 1e-12);
}

double residual_of(const DiscreteProblem& problem, const CellSet& contact) {
  return natural_residual(problem, solve(*dense_system(problem, contact), problem).state);
}

/// Cells within `reach` of a cell of the other kind.
std::vector<std::size_t> next_to_changes(const CellSet& set, std::size_t reach) {
  CellSet near(set.size(), 0);
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (std::size_t j = i < reach ? 0 : i - reach; j <= i + reach && j < set.size(); ++j) {
      if (set[i] != set[j]) near[i] = 1;
    }
  }
  return cells_of(near);
}

ContactProblem punch(const Polynomial& profile, const Rational& f, const std::optional<Rational>& load_at,
                     Sliding sliding = Sliding::plus_x) {
  return {Elasticity::reduced(Rational(1, 2)), FrictionProfile({f}), Indenter(-1, {{1, profile}}), 1, sliding, load_at};
}

}  // namespace

TEST_CASE("problems of the random list are solved, and a wrong set is refused") {
  int tilting = 0;
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    const ContactProblem problem = random_contact(first_listed_seed + seed);
    const DiscreteProblem discrete(problem, CellMesh(problem, 64));
    const LemkeResult result = lemke(discrete, 2000);
    REQUIRE(result.reached);
    CHECK(natural_residual(discrete, result.state) <= 1e-12);
    meets_its_loads(discrete, result.state);
    tilting += discrete.load_at().has_value();

    // Control: without its most pressed cell the set is not complementary.
    CellSet wrong = result.contact;
    const auto& p = result.state.pressure;
    wrong[static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin())] = 0;
    if (std::count(wrong.begin(), wrong.end(), 1) < 2) continue;
    CHECK(residual_of(discrete, wrong) > 1e-6);
    ++refused;
  }
  CHECK(tilting >= 3);
  CHECK(refused >= 60);
}

TEST_CASE("of a few cells all sets are tried: what Lemke's method finds is a solution among them") {
  constexpr std::size_t n = 7;
  int several = 0;
  int wrong_sets = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const ContactProblem problem = random_contact(first_listed_seed + seed);
    const DiscreteProblem discrete(problem, CellMesh(problem, n));
    std::vector<CellSet> solutions;
    for (unsigned bits = 1; bits < 1U << n; ++bits) {
      CellSet set(n);
      for (unsigned i = 0; i < n; ++i) set[i] = bits >> i & 1U;
      if (discrete.load_at() && cells_of(set).size() < 2) continue;
      if (residual_of(discrete, set) <= complementary_within) {
        solutions.push_back(set);
      } else {
        ++wrong_sets;
      }
    }
    const LemkeResult result = lemke(discrete, 1000);
    CHECK(result.reached);
    CHECK(std::find(solutions.begin(), solutions.end(), result.contact) != solutions.end());
    several += solutions.size() > 1;
  }
  MESSAGE(several << " problems of more than one solution");
  CHECK(wrong_sets > 20000);
}

TEST_CASE("symmetric contacts without friction, flat faces and a centred load") {
  for (const std::optional<Rational>& load_at : {std::optional<Rational>(), std::optional<Rational>(0)}) {
    const ContactProblem flat = punch(Polynomial(), 0, load_at);
    const DiscreteProblem face(flat, CellMesh(flat, 40));
    const LemkeResult whole = lemke(face, 1000);
    REQUIRE(whole.reached);
    CHECK(cells_of(whole.contact).size() == 40);
    CHECK(std::abs(whole.state.tilt) <= 1e-12);

    const ContactProblem bump = punch(Polynomial({0, 0, 3}), 0, load_at);
    const DiscreteProblem round(bump, CellMesh(bump, 41));
    const LemkeResult part = lemke(round, 1000);
    REQUIRE(part.reached);
    CHECK(std::abs(part.state.tilt) <= 1e-12);
    CHECK(std::equal(part.contact.begin(), part.contact.end(), part.contact.rbegin()));
    CHECK(cells_of(part.contact).size() > 5);
    CHECK(cells_of(part.contact).size() < 40);
  }
  const ContactProblem eccentric = punch(Polynomial({0, 0, 3}), 0, Rational(1, 3));
  const DiscreteProblem round(eccentric, CellMesh(eccentric, 41));
  const LemkeResult result = lemke(round, 1000);
  REQUIRE(result.reached);
  CHECK(result.state.tilt < -0.1);
}

TEST_CASE("strong friction, cells of very different lengths") {
  // s = 5/2 down to cells of 1e-9, s = 10 down to 1e-3.
  for (const auto& [f, smallest] : {std::pair(5, 1e-9), {20, 1e-3}}) {
    for (const std::optional<Rational>& load_at : {std::optional<Rational>(), std::optional<Rational>({1, 3})}) {
      const ContactProblem problem = punch(Polynomial({0, 0, 3}), f, load_at);
      const CellMesh mesh(problem, Rational(0), graded_edges(-0.5, 0.5, smallest, 1.4, 0.02));
      const DiscreteProblem discrete(problem, mesh);
      const LemkeResult result = lemke(discrete, 10000);
      REQUIRE(result.reached);
      CHECK(natural_residual(discrete, result.state) <= 1e-12);
      meets_its_loads(discrete, result.state);
    }
  }
}

TEST_CASE("mirrored problems have mirrored solutions, from whichever side the path comes") {
  // Pivots after which the first path on 64 cells gives way to the next one.
  constexpr int given_up = 4 * 64 + 16;
  int longest = 0;
  for (const Rational& f : {Rational(1), Rational(20)}) {
    for (const auto& [load_at, mirrored] : {std::pair(std::optional<Rational>(), std::optional<Rational>()),
                                            {std::optional<Rational>({1, 3}), std::optional<Rational>({-1, 3})}}) {
      CAPTURE(f);
      const std::vector<double> edges = graded_edges(-0.5, 0.5, 1e-3, 1.4, 0.02);
      const ContactProblem to_right = punch(Polynomial({0, 0, 3}), f, load_at);
      const ContactProblem to_left = punch(Polynomial({0, 0, 3}), f, mirrored, Sliding::minus_x);
      const DiscreteProblem one(to_right, CellMesh(to_right, Rational(0), edges));
      const DiscreteProblem other(to_left, CellMesh(to_left, Rational(0), edges));
      const LemkeResult found = lemke(one, 10000);
      const LemkeResult reflected = lemke(other, 10000);
      REQUIRE(found.reached);
      REQUIRE(reflected.reached);
      meets_its_loads(other, reflected.state);
      CHECK(std::equal(found.contact.begin(), found.contact.end(), reflected.contact.rbegin()));
      // Control: the problem itself is not its mirror image.
      if (load_at) CHECK(found.contact != reflected.contact);
      // At most one path is given up, then comes the mirrored one.
      if (load_at) CHECK(reflected.pivots <= given_up + found.pivots);
      longest = std::max(longest, reflected.pivots);
    }
  }
  CHECK(longest > given_up);
}

TEST_CASE("contested cells find their places again, alone or around what is certain") {
  const BorderedSystemMaker dense = dense_system;
  int solved = 0;
  int around = 0;
  int tilting = 0;
  for (std::uint64_t seed = 0; seed < 160; ++seed) {
    CAPTURE(seed);
    const ContactProblem problem = random_contact(first_listed_seed + seed);
    const DiscreteProblem discrete(problem, CellMesh(problem, 64));
    const LemkeResult whole = lemke(discrete, 2000);
    const std::vector<std::size_t> contested = next_to_changes(whole.contact, 3);
    CellSet start = whole.contact;
    for (std::size_t cell : contested) start[cell] = cell % 2 == 0;
    const LemkeResult part = lemke_on(discrete, start, contested, dense, 1000);
    const bool found = part.reached && natural_residual(discrete, part.state) <= 1e-12;
    solved += found;
    CellSet certain = start;
    for (std::size_t cell : contested) certain[cell] = 0;
    if (cells_of(certain).size() >= 2 && part.pivots > 0) {
      ++around;
      if (discrete.load_at()) {
        ++tilting;
        CHECK(found);
      }
    }
    // Control: what was given to begin with is no solution.
    if (start != whole.contact) CHECK(residual_of(discrete, start) > 1e-6);

    const LemkeResult among = lemke_among(discrete, cells_of(whole.contact), 2000);
    REQUIRE(among.reached);
    CHECK(natural_residual(discrete, among.state, cells_of(whole.contact)) <= 1e-12);
  }
  CHECK(solved >= 156);
  CHECK(around >= 50);
  CHECK(tilting >= 2);
}

TEST_CASE("without enough pivots, or with a load beyond the cells, nothing is claimed") {
  const ContactProblem problem = punch(Polynomial({0, 0, 3}), 1, std::nullopt);
  CHECK_FALSE(lemke(DiscreteProblem(problem, CellMesh(problem, 64)), 2).reached);
  CHECK(lemke(DiscreteProblem(problem, CellMesh(problem, 64)), 1000).reached);
  // The last of four cells has its centre at 3/4.
  const ContactProblem outside = punch(Polynomial({0, 0, 3}), 1, Rational(7, 8));
  CHECK_FALSE(lemke(DiscreteProblem(outside, CellMesh(outside, 4)), 1000).reached);
  CHECK(lemke(DiscreteProblem(outside, CellMesh(outside, 16)), 1000).reached);
}

TEST_CASE("a natural residual that is no number is no small one") {
  const ContactProblem problem = punch(Polynomial({0, 0, 3}), 1, std::nullopt);
  const DiscreteProblem discrete(problem, CellMesh(problem, 8));
  DiscreteState state = lemke(discrete, 100).state;
  CHECK(natural_residual(discrete, state) <= complementary_within);
  state.approach = NAN;
  CHECK_FALSE(natural_residual(discrete, state) <= complementary_within);
}
