// Galerkin's operator: products are compared with sums of entries; signs; the equations of one contact set by a
// factorisation and by Krylov's method, which needs few products on any mesh. The number of products tests the
// preconditioner; only this shows whether the preconditioner has the right sign of friction.

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <numbers>
#include <random>

#include "numeric/variational/bordered_system.hpp"
#include "support/cells.hpp"

namespace {

/// The largest difference between a product and the sum of entries times pressures, and the largest sum of ∣entries∣;
/// the same without friction.
struct ProductError {
  double whole = 0, without_slip = 0;
};

ProductError product_error(const GalerkinOperator& b) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> p(b.size()), found(b.size());
  for (double& x : p) x = value(random);
  b.multiply(p, found);
  ProductError result;
  double scale = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    long double sum = 0, logarithms = 0;
    double row = 0;
    for (std::size_t j = 0; j < b.size(); ++j) {
      sum += static_cast<long double>(b.entry(i, j)) * p[j];
      logarithms += static_cast<long double>(b.kernel_entry(i, j)) * p[j];
      row += std::abs(b.entry(i, j));
    }
    result.whole = std::max(result.whole, static_cast<double>(std::abs(sum - found[i])));
    result.without_slip = std::max(result.without_slip, static_cast<double>(std::abs(logarithms - found[i])));
    scale = std::max(scale, row);
  }
  return {result.whole / scale, result.without_slip / scale};
}

CellMesh graded(const ContactProblem& problem) {
  const Rational middle = (problem.indenter().left() + problem.indenter().right()) / 2;
  return {problem, middle, graded_edges(-0.5, 0.5, 1e-9, 1.4, 0.05)};
}

/// A parabola under s up to 3/2, times `strong`. The middle three quarters of the cells are in contact.
DiscreteProblem coated(std::size_t cells, Sliding sliding, const std::optional<Rational>& load_at, int strong = 1) {
  const ContactProblem problem = reduced({0.5_r * strong, 1.5_r * strong, 1}, {Rational(-1, 3), 0},
                                         one_piece(-1, 1, {0, 0, 1}), 1, load_at, sliding);
  return {problem, CellMesh(problem, cells), FrictionRule::damped};
}

/// Contact on the cells from first to end - 1.
CellSet from_to(std::size_t cells, std::size_t first, std::size_t end) {
  CellSet contact(cells, 0);
  for (std::size_t i = first; i < end; ++i) contact[i] = 1;
  return contact;
}

CellSet middle(std::size_t cells) { return from_to(cells, cells / 8, cells - cells / 8); }

/// `zones` zones; each has between a half and four fifths of its share of the cells.
CellSet zones_apart(std::size_t cells, std::size_t zones) {
  CellSet contact(cells, 0);
  for (std::size_t i = 0; i < cells; ++i) {
    const std::size_t zone = i * zones / cells;
    contact[i] = (i * zones - zone * cells) * 20 < (10 + zone * 5 % 7) * cells;
  }
  return contact;
}

SystemSolution by_krylov(const DiscreteProblem& problem, const CellSet& contact,
                         const std::shared_ptr<ContactHull>& hull = nullptr) {
  return solve(*krylov_system(problem, contact, nothing(problem), 1e-11, hull), problem);
}

/// Solves by Krylov's method with `contact` in contact, for both directions of sliding and several frictions. Checks
/// the number of products: at most `usual` for ordinary friction, at most `stronger` for larger friction.
void check_products(std::size_t cells, const CellSet& contact, int usual, int stronger) {
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    for (const int strong : {1, 4, 20}) {
      INFO(cells, " cells, ", strong, " times as strong");
      const SystemSolution found = by_krylov(coated(cells, sliding, std::nullopt, strong), contact);
      CHECK(found.residual <= 1e-11);
      CHECK(found.products <= (strong == 1 ? usual : stronger));
    }
  }
}

}  // namespace

TEST_CASE("a contact's hull is kept for one nearly the same, and made anew for one elsewhere") {
  const DiscreteProblem problem = coated(1024, Sliding::plus_x, std::nullopt);
  const auto hull = contact_hull(problem, from_to(1024, 300, 700));
  CHECK(hull->first <= 300);
  CHECK(hull->first + hull->influence.size() >= 700);
  CHECK(contact_hull(problem, from_to(1024, 301, 701), hull) == hull);
  const auto other = contact_hull(problem, from_to(1024, 364, 764), hull);
  CHECK(other != hull);
  CHECK(other->influence.size() == hull->influence.size());
  CHECK(other->first > 300);
  CHECK(other->first <= 364);
  CHECK(contact_hull(problem, from_to(1024, 0, 1024))->influence.size() == 1024);
}

TEST_CASE("products by Fourier transforms are those of the entries") {
  double control = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const ContactProblem problem = listed_contact(seed);
    for (std::size_t n : {1U, 2U, 3U, 7U, 64U, 1000U}) {
      INFO("seed = ", seed, ", n = ", n);
      const ProductError error = product_error(on_cells(problem, n).galerkin_operator());
      CHECK(error.whole <= 1e-14);
      control = std::max(control, error.without_slip);
    }
    CHECK(product_error(DiscreteProblem(problem, graded(problem)).galerkin_operator()).whole <= 1e-14);
  }
  CHECK(control > 1e-3);
}

TEST_CASE("no entry is negative, no eigenvalue of the logarithm's circulant is, under either sense of sliding") {
  int senses = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const ContactProblem problem = listed_contact(seed);
    senses |= problem.sliding() == Sliding::plus_x ? 1 : 2;
    for (const CellMesh& mesh : {CellMesh(problem, 50), graded(problem)}) {
      const GalerkinOperator b(mesh, cell_friction(problem, mesh));
      double least = HUGE_VAL, least_on_diagonal = HUGE_VAL, least_slip_before = HUGE_VAL;
      for (std::size_t i = 0; i < b.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) least = std::min(least, b.entry(i, j));
        least_on_diagonal = std::min(least_on_diagonal, b.entry(i, i));
        // Control: counted from the other end, friction has the opposite sign.
        for (std::size_t j = 0; j < i; ++j)
          least_slip_before = std::min(least_slip_before, -b.friction_entry(i, j) - b.friction_entry(j, i));
      }
      CHECK(least >= 0);
      CHECK(least_on_diagonal > 0);
      if (std::ranges::max(problem.friction().values()) > 0) CHECK(least_slip_before < 0);
    }
  }
  CHECK(senses == 3);
  const ContactProblem problem = listed_contact(0);
  // With one cell the circulant is a constant.
  for (std::size_t n : {2U, 3U, 4U, 5U, 7U, 8U, 64U, 100U, 1000U, 4096U, 10000U}) {
    CAPTURE(n);
    const CellMesh mesh(problem, n);
    const GalerkinOperator b(mesh, cell_friction(problem, mesh));
    const Fourier circle(b.transform_size());
    const std::vector<std::complex<double>> spectrum = b.spectrum(false, mesh.length(0), circle);
    CHECK(spectrum.size() == b.transform_size() / 2 + 1);
    for (const std::complex<double>& value : spectrum) {
      CHECK(value.real() > 0);
      CHECK(std::abs(value.imag()) <= 1e-15);
    }
  }
}

TEST_CASE("equal cells given as edges make the same operator as equal cells by number") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const ContactProblem problem = listed_contact(seed);
    const CellMesh uniform(problem, 37), edges(problem, uniform.frame().origin, uniform.edges());
    CHECK(uniform.is_uniform());
    CHECK_FALSE(edges.is_uniform());
    const DiscreteProblem one(problem, uniform), other(problem, edges);
    const GalerkinOperator &a = one.galerkin_operator(), &b = other.galerkin_operator();
    double worst = 0, shifted = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      CHECK(one.profile()[i] == doctest::Approx(other.profile()[i]).epsilon(1e-12));
      for (std::size_t j = 0; j < one.size(); ++j) {
        worst = std::max(worst, std::abs(a.entry(i, j) - b.entry(i, j)));
        if (j > 0) shifted = std::max(shifted, std::abs(a.entry(i, j) - b.entry(i, j - 1)));
      }
    }
    CHECK(worst <= 1e-15 * 20);
    CHECK(shifted > 1e-4);
  }
}

TEST_CASE("the damped rule asks at the end of a cell where s is strong, and nowhere else") {
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    const ContactProblem problem =
        reduced({0.5_r, 6, 1, 3}, {-0.5_r, 0, 0.5_r}, one_piece(-1, 1, {0, 0, 1}), 1, std::nullopt, sliding);
    const bool right = sliding == Sliding::plus_x;
    const CellMesh mesh(problem, 40);
    const GalerkinOperator damped(mesh, cell_friction(problem, mesh, FrictionRule::damped));
    const GalerkinOperator means(mesh, cell_friction(problem, mesh));
    CHECK(product_error(damped).whole <= 1e-14);
    boost::math::quadrature::tanh_sinh<double> rule;
    double control = 0;
    for (std::size_t i = 0; i < 40; ++i) {
      const bool strong = (i >= 10 && i < 20) || i >= 30;
      CHECK(damped.friction().is_at_end(i) == strong);
      for (std::size_t j = 0; j < 40; ++j) {
        if (!strong) CHECK(damped.entry(i, j) == means.entry(i, j));
        if (!strong) continue;
        // The place xi is an end of the cell, and s is constant in each cell.
        const double xi = right ? mesh.right(i) : mesh.left(i);
        const double from = std::abs(mesh.centre(j) - xi) - mesh.length(j) / 2;
        const double logarithm =
            -rule.integrate([&](double u) { return std::log(std::max(from, 0.0) + u); }, 0.0, mesh.length(j)) /
            std::numbers::pi;
        const double s = std::abs(damped.friction().whole[j]);
        const bool felt = right ? mesh.centre(j) < xi : mesh.centre(j) > xi;
        CHECK(damped.entry(i, j) == doctest::Approx(logarithm + (felt ? s : 0)).epsilon(1e-12));
        control = std::max(control, std::abs(damped.entry(i, j) - means.entry(i, j)));
      }
    }
    CHECK(control > 1e-3);
    CHECK_THROWS_AS(DiscreteProblem(problem, graded(problem), FrictionRule::damped), std::invalid_argument);
  }
}

TEST_CASE("under strong friction alternating pressures push the surface by the damped rule, hardly by means") {
  const ContactProblem problem = reduced({50}, {}, one_piece(-1, 1, {0, 0, 1}), 1);
  const CellMesh mesh(problem, 1000);
  std::vector<double> p(1000), image(1000);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = i % 2 == 0 ? 1 : -1;
  const auto push = [&](FrictionRule rule) {
    GalerkinOperator(mesh, cell_friction(problem, mesh, rule)).multiply(p, image);
    return std::abs(image[501] - image[500]) / mesh.length(0) / 2;
  };
  CHECK(push(FrictionRule::damped) == doctest::Approx(50.0 / 2).epsilon(1e-3));
  CHECK(push(FrictionRule::galerkin) < 0.3);
}

TEST_CASE("a dense system meets its equations, its load and its moment") {
  int tilting = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const DiscreteProblem discrete = on_cells(listed_contact(seed), 60);
    CellSet contact = from_to(60, 10, 50);
    for (std::size_t i = 14; i < 50; i += 7) contact[i] = 0;
    const DiscreteState state = solve(*dense_system(discrete, contact), discrete).state;
    const std::vector<double> g = gaps(discrete, state);
    double height = 1, residual = 0, elsewhere = 0;
    for (std::size_t i = 0; i < 60; ++i) {
      double& largest = contact[i] ? residual : elsewhere;
      largest = std::max(largest, std::abs(g[i]));
      if (contact[i]) height = std::max({height, std::abs(discrete.profile()[i]), std::abs(state.pressure[i])});
      if (!contact[i]) CHECK(state.pressure[i] == 0);
    }
    CHECK(residual <= 1e-12 * height);
    CHECK(elsewhere > 1e-4 * height);
    const Forces forces = forces_of(discrete, state);
    CHECK(std::abs(forces.load - 1) <= 1e-12 * std::max(1.0, forces.size));
    tilting += discrete.load_at() ? 1 : 0;
    if (discrete.load_at()) {
      CHECK(std::abs(forces.moment - *discrete.load_at()) <= 1e-12 * std::max(1.0, forces.size));
    } else {
      CHECK(state.tilt == 0);
    }
  }
  CHECK(tilting > 0);
}

TEST_CASE("Krylov's method and the factorisation solve the same system") {
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    for (const auto& load_at : {std::optional<Rational>(), std::optional(0.1_r)}) {
      for (const int strong : {1, 20}) {
        const DiscreteProblem problem = coated(400, sliding, load_at, strong);
        // With 400/150 cells a zone, many zones have one cell, and some zones are combined.
        for (const CellSet& contact : {middle(400), zones_apart(400, 12), zones_apart(400, 150)}) {
          const DiscreteState dense = solve(*dense_system(problem, contact), problem).state;
          const DiscreteState found = by_krylov(problem, contact).state;
          double highest = 0, worst = 0;
          for (std::size_t i = 0; i < problem.size(); ++i) {
            highest = std::max(highest, std::abs(dense.pressure[i]));
            worst = std::max(worst, std::abs(dense.pressure[i] - found.pressure[i]));
          }
          CHECK(worst <= 1e-8 * highest);
          CHECK(std::abs(found.approach - dense.approach) <= 1e-10);
          CHECK(std::abs(found.tilt - dense.tilt) <= 1e-9);
        }
      }
    }
  }
}

TEST_CASE("Krylov's method takes few products, whatever the mesh and the sense of sliding") {
  for (const std::size_t cells : {500U, 4000U, 32000U}) check_products(cells, middle(cells), 20, 32);
}

TEST_CASE("zones apart cost Krylov's method few products more, however many they are") {
  for (const std::size_t zones : {4U, 12U, 36U}) {
    CAPTURE(zones);
    check_products(8000, zones_apart(8000, zones), 24, 40);
  }
}

TEST_CASE("what zones do to each other is found once for contacts that are nearly the same") {
  const DiscreteProblem problem = coated(8000, Sliding::plus_x, std::nullopt);
  CellSet contact = zones_apart(8000, 20);
  const auto hull = contact_hull(problem, contact);
  const int first = by_krylov(problem, contact, hull).products;
  contact[0] = 0;
  CHECK(by_krylov(problem, contact, hull).products == first - ZoneCoupling::points);
  // With another zone the result differs.
  contact[390] = 1;
  CHECK(by_krylov(problem, contact, hull).products >= first);
}

TEST_CASE("zones of contact lie between the widest gaps") {
  const auto zones = [](std::size_t most) {
    std::vector<std::array<std::size_t, 2>> result;
    for (const auto& [begin, count] : contact_zones({3, 4, 6, 10, 11, 15}, most)) result.push_back({begin, count});
    return result;
  };
  using Zones = std::vector<std::array<std::size_t, 2>>;
  CHECK(zones(4) == Zones{{3, 2}, {6, 1}, {10, 2}, {15, 1}});
  CHECK(zones(3) == Zones{{3, 4}, {10, 2}, {15, 1}});
  // If two gaps have the same width, neither is wider.
  CHECK(zones(2) == Zones{{3, 13}});
  CHECK(zones(1) == Zones{{3, 13}});
}
