// Solves on the support's cells and, if an accuracy is wanted, on cells of the part of the support that has the contact.

#include "numeric/variational/variational_inequality.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "numeric/periodic/repeated_contact.hpp"
#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::numeric {
namespace {

using Part = VariationalSolution::Part;

constexpr Part support{-0.5, 0.5};

bool is_cut(const Part& part) { return part.left > support.left || part.right < support.right; }
double length(const Part& part) { return part.right - part.left; }
Part joined(const Part& a, const Part& b) { return {std::min(a.left, b.left), std::max(a.right, b.right)}; }

/// Returns a part with a margin on both sides, inside the support. Its ends have few digits.
Part with_margin(const Part& part, double least) {
  constexpr double grid = 1 << 24;
  const double margin = std::max(length(part) / 8, least);
  return {std::max(support.left, std::floor((part.left - margin) * grid) / grid),
          std::min(support.right, std::ceil((part.right + margin) * grid) / grid)};
}

}  // namespace

std::optional<Part> VariationalSolution::contact_part() const {
  if (runs_.empty()) return std::nullopt;
  const Frame whole = variational::support_frame(problem_);
  const auto place = [&](double xi) {
    return to_real<double>((mesh().frame().origin + mesh().frame().unit * Rational(xi) - whole.origin) / whole.unit);
  };
  return Part{place(mesh().left(runs_.front().begin)), place(mesh().right(runs_.back().end - 1))};
}

std::optional<Part> VariationalSolution::penetrated_part(const variational::DiscreteProblem& support,
                                                         const variational::CellProfile& profile) const {
  const variational::CellMesh& cells = support.mesh();
  const auto ratio = to_real<double>(cells.frame().unit / mesh().frame().unit);
  const auto own = [&, origin = mesh().place(cells.frame().origin)](double xi) { return origin + ratio * xi; };
  const std::size_t n = cells.size();
  std::vector<double> pressure(n), displacement(n);
  for (std::size_t i = 0; i < n; ++i) {
    pressure[i] = meshes_.front().between(own(cells.left(i)), own(cells.right(i))) / cells.length(i);
  }
  support.galerkin_operator().multiply(pressure, displacement);
  // A kernel in another unit of length differs by a constant.
  const double constant = kernel().at(ratio / 2) - support.galerkin_operator().kernel().at(0.5) - state().approach;
  std::optional<Part> result;
  const auto look = [&](double xi, Side side) {
    if (std::abs(own(xi)) <= 0.5) return;
    const double indenter = profile(xi, side) + state().tilt * own(xi);
    const std::size_t k = std::clamp<std::size_t>(cells.cell_at(xi), 1, n - 2);
    // The displacement is known up to its change within a cell.
    if (indenter + displacement[k] + constant > std::abs(displacement[k + 1] - displacement[k - 1])) return;
    if (indenter + displacement_beyond(found_.fine, own(xi)) >= state().approach) return;
    result = joined(result.value_or(Part{xi, xi}), {xi, xi});
  };
  look(cells.left(0), Side::right);
  look(cells.right(n - 1), Side::left);
  for (std::size_t i = 0; i < n; ++i) look(cells.centre(i), Side::left);
  for (const double xi : profile.breaks()) {
    look(xi, Side::left);
    look(xi, Side::right);
  }
  return result;
}

Attempt<double> variational_inequality(const ContactProblem& given, const VariationalOptions& options) {
  if (options.cells < fewest_cells || options.cells > most_cells) throw std::invalid_argument("number of cells");
  for (std::size_t k = 0; k < given.friction().values().size(); ++k) {
    if (!std::isfinite(to_real<double>(given.coupled_friction(k))))
      return {nullptr, "friction too large for cells; gamma f is at most 1e308"};
  }
  ContactProblem problem = given;
  Frame frame = variational::support_frame(problem);
  const auto x = [&](double xi) { return Rational(frame.origin + frame.unit * Rational(xi)); };
  VariationalOptions tried = options;
  Part part = support;
  const auto solved = [&] {
    const Frame of_part = variational::frame_between(x(part.left), x(part.right));
    return std::make_shared<VariationalSolution>(problem, variational::solve_nested(problem, of_part, tried));
  };
  auto located = solved();
  const Rational begin = beginning_in_gap(given, located->zones());
  if (begin != given.indenter().left()) {
    problem = beginning_at(begin, given);
    frame = variational::support_frame(problem);
    located = solved();
  }
  auto solution = located;
  std::optional<variational::CellProfile> profile;
  std::optional<Part> penetrated;  // of all solutions so far
  while (options.accuracy > 0 && solution->failed_condition().empty()) {
    const Part contact = *solution->contact_part();
    bool is_too_short = (contact.left <= part.left && part.left > support.left) ||
                        (contact.right >= part.right && part.right < support.right);
    if (is_cut(part)) {
      if (!profile) profile.emplace(problem, frame);
      if (const auto places = solution->penetrated_part(*located->found().fine.problem, *profile)) {
        is_too_short = true;
        penetrated = joined(penetrated.value_or(*places), *places);
      }
    }
    const auto [ends, traction, resultants] = solution->estimated_error();
    const double excess = std::max(ends, resultants) / options.accuracy;
    if (!is_too_short && excess <= 1) break;
    const double two_cells = 2 * length(part) / static_cast<double>(tried.cells);
    Part next = with_margin(joined(contact, penetrated.value_or(contact)), two_cells);
    if (is_too_short) {
      next = joined(part, next);
    } else if (2 * length(next) > length(part)) {
      next = part;
    }
    if (length(next) == length(part) && tried.cells == most_cells) break;
    // The error of ends is like the length of a cell.
    const double factor = (is_too_short ? 1 : std::clamp(excess, 2.0, 64.0)) * length(next) / length(part);
    const double wanted = std::ceil(factor * static_cast<double>(tried.cells));
    tried.cells = std::bit_ceil(std::clamp<std::size_t>(static_cast<std::size_t>(wanted), 256, most_cells));
    part = next;
    solution = solved();
  }
  if (problem.elasticity().indenter() && solution->reaches_edge()) {
    return {nullptr, "the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails"};
  }
  return {repeated(given, begin, std::move(solution)), {}};
}

}  // namespace steadyslide::numeric
