// Lemke's method: solutions of the random list, all solutions of small problems, and refusals.

#include "numeric/variational/lemke.hpp"
#include "support/cells.hpp"

namespace {

void meets_its_loads(const DiscreteProblem& problem, const DiscreteState& state) {
  const Forces forces = forces_of(problem, state);
  CHECK(std::abs(forces.load - 1) <= 1e-12);
  if (problem.load_at()) CHECK(std::abs(forces.moment - *problem.load_at()) <= 1e-12);
}

/// Lemke's method finds a solution under the problem's load.
LemkeResult solved_by_lemke(const DiscreteProblem& problem, int most_pivots) {
  const LemkeResult result = lemke(problem, most_pivots);
  REQUIRE(result.reached);
  CHECK(natural_residual(problem, result.state) <= 1e-12);
  meets_its_loads(problem, result.state);
  return result;
}

double residual_of(const DiscreteProblem& problem, const CellSet& contact) {
  return natural_residual(problem, solve(*dense_system(problem, contact), problem).state);
}

/// Returns the cells within `reach` of a cell of the other kind.
std::vector<std::size_t> next_to_changes(const CellSet& set, std::size_t reach) {
  CellSet near(set.size(), 0);
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (std::size_t j = i < reach ? 0 : i - reach; j <= i + reach && j < set.size(); ++j) {
      if (set[i] != set[j]) near[i] = 1;
    }
  }
  return cells_of(near);
}

using LineOfAction = std::optional<Rational>;
const std::vector<Rational> flat, bump{0, 0, 3};

ContactProblem punch(const std::vector<Rational>& profile, const Rational& f,
                     const LineOfAction& load_at = std::nullopt, Sliding sliding = Sliding::plus_x) {
  return reduced({f / 2}, {}, one_piece(-1, 1, profile), 1, load_at, sliding);
}

/// Cells that are shorter nearer to 0.
DiscreteProblem graded(const ContactProblem& problem, double smallest) {
  return {problem, CellMesh(problem, 0, graded_edges(-0.5, 0.5, smallest, 1.4, 0.02))};
}

}  // namespace

TEST_CASE("problems of the random list are solved, and a wrong set is refused") {
  int tilting = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    const DiscreteProblem discrete = on_cells(listed_contact(seed), 64);
    const LemkeResult result = solved_by_lemke(discrete, 2000);
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
  int several = 0, wrong_sets = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const DiscreteProblem discrete = on_cells(listed_contact(seed), n);
    std::vector<CellSet> solutions;
    for (const CellSet& set : all_sets(n)) {
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
  for (const LineOfAction& load_at : {LineOfAction(), LineOfAction(0)}) {
    for (const auto& [profile, least, most] : {std::tuple(flat, 41, 41), {bump, 6, 39}}) {
      const LemkeResult found = lemke(on_cells(punch(profile, 0, load_at), 41), 1000);
      REQUIRE(found.reached);
      CHECK(std::abs(found.state.tilt) <= 1e-12);
      CHECK(std::equal(found.contact.begin(), found.contact.end(), found.contact.rbegin()));
      CHECK(std::ssize(cells_of(found.contact)) >= least);
      CHECK(std::ssize(cells_of(found.contact)) <= most);
    }
  }
  const LemkeResult eccentric = lemke(on_cells(punch(bump, 0, Rational(1, 3)), 41), 1000);
  REQUIRE(eccentric.reached);
  CHECK(eccentric.state.tilt < -0.1);
}

TEST_CASE("strong friction, cells of very different lengths") {
  // s = 5/2 down to cells of 1e-9, s = 10 down to 1e-3.
  for (const auto& [f, smallest] : {std::pair(5, 1e-9), {20, 1e-3}}) {
    for (const LineOfAction& load_at : {LineOfAction(), LineOfAction(Rational(1, 3))}) {
      solved_by_lemke(graded(punch(bump, f, load_at), smallest), 10000);
    }
  }
}

TEST_CASE("mirrored problems have mirrored solutions, from whichever side the path comes") {
  // Number of pivots after which the first path on 64 cells is given up for the next one.
  constexpr int given_up = 4 * 64 + 16;
  int longest = 0;
  for (const int f : {1, 20}) {
    for (const LineOfAction& load_at : {LineOfAction(), LineOfAction(Rational(1, 3))}) {
      CAPTURE(f);
      const ContactProblem to_right = punch(bump, f, load_at);
      const DiscreteProblem one = graded(to_right, 1e-3), other = graded(to_right.mirrored(), 1e-3);
      const LemkeResult found = lemke(one, 10000), reflected = lemke(other, 10000);
      REQUIRE(found.reached);
      REQUIRE(reflected.reached);
      meets_its_loads(other, reflected.state);
      CHECK(std::equal(found.contact.begin(), found.contact.end(), reflected.contact.rbegin()));
      // Control: the problem is not its own mirror image.
      if (load_at) CHECK(found.contact != reflected.contact);
      // At most one path is given up; then the mirrored one follows.
      if (load_at) CHECK(reflected.pivots <= given_up + found.pivots);
      longest = std::max(longest, reflected.pivots);
    }
  }
  CHECK(longest > given_up);
}

TEST_CASE("contested cells find their places again, alone or around what is certain") {
  const BorderedSystemMaker dense = dense_system;
  int solved = 0, around = 0, tilting = 0;
  for (std::uint64_t seed = 0; seed < 160; ++seed) {
    CAPTURE(seed);
    const DiscreteProblem discrete = on_cells(listed_contact(seed), 64);
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
    // Control: the starting set is not a solution.
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
  CHECK_FALSE(lemke(on_cells(punch(bump, 1), 64), 2).reached);
  CHECK(lemke(on_cells(punch(bump, 1), 64), 1000).reached);
  // The last of four cells has its centre at 3/4.
  const ContactProblem outside = punch(bump, 1, 0.875_r);
  CHECK_FALSE(lemke(on_cells(outside, 4), 1000).reached);
  CHECK(lemke(on_cells(outside, 16), 1000).reached);
}

TEST_CASE("a natural residual that is no number is no small one") {
  const DiscreteProblem discrete = on_cells(punch(bump, 1), 8);
  DiscreteState state = lemke(discrete, 100).state;
  CHECK(natural_residual(discrete, state) <= complementary_within);
  state.approach = NAN;
  CHECK_FALSE(natural_residual(discrete, state) <= complementary_within);
}
