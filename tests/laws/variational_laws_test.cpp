// Laws of the unilateral problem on cells that the ledger's claims on random problems (vi-...) do not cover: smooth
// densities, all contact sets of a few cells, and loading paths.

#include <Eigen/LU>

#include "numeric/variational/lemke.hpp"
#include "support/cells.hpp"

namespace {

using std::numbers::pi;

/// Support [-1, 1]; s in tenths, with one jump at 0.
ContactProblem problem_of(int left, int right, const std::vector<Rational>& profile, const Rational& load,
                          const std::optional<Rational>& load_at = std::nullopt) {
  return reduced({Rational(left, 10), Rational(right, 10)}, {0}, one_piece(-1, 1, profile), load, load_at);
}

/// Returns t.Bt on N equal cells. The forces are those of cos(n theta)/(pi sin(theta)), x = 2 xi = cos(theta),
/// integrated exactly.
double energy_of_chebyshev(std::size_t cells, int n, int left, int right) {
  const DiscreteProblem discrete = on_cells(problem_of(left, right, {}, 1), cells);
  const CellMesh& mesh = discrete.mesh();
  const auto primitive = [n](double xi) { return -std::sin(n * std::acos(std::clamp(2 * xi, -1.0, 1.0))) / (n * pi); };
  std::vector<double> p(cells), product(cells);
  for (std::size_t i = 0; i < cells; ++i) p[i] = (primitive(mesh.right(i)) - primitive(mesh.left(i))) / mesh.length(i);
  discrete.galerkin_operator().multiply(p, product);
  double sum = 0;
  for (std::size_t i = 0; i < cells; ++i) sum += p[i] * product[i] * mesh.length(i);
  return sum;
}

/// The punch of a contact set: its least pressure on the set, and the largest B x outside.
struct Punch {
  double least_pressure;
  double most_outside;  ///< largest B x outside of the set; it is 1 on the set
};

Punch punch_of(const GalerkinOperator& b, const CellSet& set) {
  const std::vector<std::size_t> contact = cells_of(set);
  const auto n = static_cast<Eigen::Index>(contact.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      matrix(i, j) = b.entry(contact[static_cast<std::size_t>(i)], contact[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::VectorXd x = matrix.partialPivLu().solve(Eigen::VectorXd::Ones(n));
  Punch punch{x.minCoeff(), 0};
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (set[i]) continue;
    double sum = 0;
    for (Eigen::Index j = 0; j < n; ++j) sum += b.entry(i, contact[static_cast<std::size_t>(j)]) * x(j);
    punch.most_outside = std::max(punch.most_outside, sum);
  }
  return punch;
}

/// The worst over all sets.
Punch worst_punch(const GalerkinOperator& b) {
  Punch worst{HUGE_VAL, -HUGE_VAL};
  for (const CellSet& set : all_sets(b.size())) {
    const Punch punch = punch_of(b, set);
    worst = {std::min(worst.least_pressure, punch.least_pressure), std::max(worst.most_outside, punch.most_outside)};
  }
  return worst;
}

std::ptrdiff_t solutions(const DiscreteProblem& problem) {
  return std::ranges::count_if(all_sets(problem.size()), [&](const CellSet& set) {
    return natural_residual(problem, solve(*dense_system(problem, set), problem).state) <= 1e-10;
  });
}

/// Returns the number of cells that lose contact, or pressure, from a load to the next one.
int losses(int left, int right, const std::vector<Rational>& profile, const std::vector<Rational>& loads,
           const std::optional<Rational>& load_at = std::nullopt) {
  constexpr std::size_t cells = 32;
  int count = 0;
  std::vector<double> before(cells, 0);
  for (const Rational& load : loads) {
    const LemkeResult result = lemke(on_cells(problem_of(left, right, profile, load, load_at), cells), 3200);
    REQUIRE(result.reached);
    for (std::size_t i = 0; i < cells; ++i) {
      const double p = result.state.pressure[i] * load.convert_to<double>();
      count += p < before[i] - 1e-10;
      before[i] = p;
    }
  }
  return count;
}

const std::vector<Rational> parabola{0, 0, 1};
const std::vector<Rational> two_bumps{0, 0, -0.9_r, 0, 1};
const std::vector<Rational> lopsided{0, 0.1_r, -1, 0.2_r, 1};

}  // namespace

TEST_CASE("Chebyshev's densities have the energy 1/(2 pi n), to the first power of the cells' length") {
  // int T_n(y) log|x-y|/sqrt(1-y^2) dy = -(pi/n) T_n(x); a jump of s at 0 adds half of it times sin^2(n pi/2)/(n pi)^2.
  for (const int n : {1, 2, 3}) {
    for (const auto& s : {std::pair(0, 0), {0, 10}, {10, 0}}) {
      const auto left = s.first, right = s.second;
      CAPTURE(n);
      CAPTURE(right - left);
      const double jump = (right - left) / 10.0 * std::pow(std::sin(n * pi / 2) / (n * pi), 2) / 2;
      const double expected = 1 / (2 * pi * n) + jump;
      const double coarse = energy_of_chebyshev(16384, n, left, right) - expected;
      const double fine = energy_of_chebyshev(32768, n, left, right) - expected;
      CHECK(std::abs(fine) < 1e-3 * expected);
      CHECK(std::log2(coarse / fine) == doctest::Approx(1).epsilon(0.05));
      // Control: the jump with the opposite sign.
      if (jump != 0 && n % 2 == 1) CHECK(std::abs(fine + 2 * jump) > 0.02 * expected);
    }
  }
}

TEST_CASE("on equal cells every punch presses everywhere and penetrates nothing, for s up to 1/2") {
  for (const auto& s : {std::pair(0, 0), {5, 5}, {0, 5}, {5, 0}, {2, 4}}) {
    const auto left = s.first, right = s.second;
    INFO("left = ", left, ", right = ", right);
    const Punch punch = worst_punch(on_cells(problem_of(left, right, parabola, 1), 10).galerkin_operator());
    CHECK(punch.least_pressure > 0);
    CHECK(punch.most_outside < 1);
  }
  // Controls: s falls by 3/5; cells of alternating lengths.
  const Punch strong = worst_punch(on_cells(problem_of(6, 0, parabola, 1), 10).galerkin_operator());
  CHECK(strong.least_pressure < 0);
  CHECK(strong.most_outside > 1);
  const ContactProblem problem = problem_of(0, 0, parabola, 1);
  std::vector<double> edges{-0.5};
  for (int i = 0; i < 8; ++i) edges.push_back(edges.back() + (i % 2 == 0 ? 5.0 : 0.25) / 21);
  edges.back() = 0.5;
  const DiscreteProblem alternating(problem, CellMesh(problem, 0_r, edges));
  CHECK(worst_punch(alternating.galerkin_operator()).least_pressure < 0);
}

TEST_CASE("of all sets of eight cells one is complementary, where s rises and where it falls by 1/2") {
  for (const auto& s : {std::pair(0, 0), {0, 5}, {5, 0}, {0, 50}, {20, 30}}) {
    const auto left = s.first, right = s.second;
    for (const auto& profile : {parabola, two_bumps, lopsided}) {
      for (const Rational& load : {0.1_r, 0.5_r, 3_r}) {
        INFO("left = ", left, ", right = ", right);
        CHECK(solutions(on_cells(problem_of(left, right, profile, load), 8)) == 1);
      }
    }
  }
  // Control: s falls by 5.
  CHECK(solutions(on_cells(problem_of(50, 0, parabola, 0.5_r), 8)) == 3);
}

TEST_CASE("contact and pressures grow with the load, unless the indenter tilts") {
  std::vector<Rational> loads;
  for (int k = 1; k <= 12; ++k) loads.emplace_back(k * k, 30);
  for (const auto& [left, right] : {std::pair(0, 0), {0, 5}, {5, 0}, {3, 4}}) {
    for (const auto& profile : {parabola, two_bumps, lopsided}) CHECK(losses(left, right, profile, loads) == 0);
  }
  CHECK(losses(0, 0, two_bumps, {1.3_r, 3.9_r}, 0.625_r) > 0);
  CHECK(losses(0, 0, two_bumps, {1.3_r, 3.9_r}) == 0);
  std::reverse(loads.begin(), loads.end());
  CHECK(losses(0, 0, parabola, loads) > 0);
}
