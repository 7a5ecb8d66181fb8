// Forces of a solution on cells, and their errors.
//
// The difference of loads between meshes shows their error. But a single difference may be small by chance, because
// ends and jumps lie at varying positions in their cells. Errors are 1/N or less, and 1/N^2 if the contact has no edge and
// no friction jump. So the differences of the last four meshes are added, each reduced to this mesh as such an error would
// be, and doubled. For an error that is just 1/N or 1/N^2, the sum is eight times this error.
//
// These meshes do not show three errors; in each case a load may be at another place. The load of a zone of n cells has
// a relative error of about 16/n^2. A contact that ends within a cell of a friction jump may reach beyond it: then the
// load of that cell, or of the cells by which the end has moved, is under the other friction. If friction jumps twice
// within two cells, this holds for the load of all cells so close to the jump; only the worst of such jumps counts,
// because the errors of stripes finer than cells cancel. A load p that changes sides at a jump of s lifts the surface
// beyond the jump by c [s] p: other pieces and zones lose or gain up to 2 [s] p of their load.

#include <algorithm>
#include <cmath>

#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::numeric {

VariationalSolution::MeshLoads::MeshLoads(const variational::DiscreteState& state)
    : before{0}, tilt(state.tilt), approach(state.approach) {
  const double cell = 1 / static_cast<double>(state.pressure.size());
  double middle = (cell - 1) / 2;
  for (const double p : state.pressure) {
    before.push_back(before.back() + p * cell);
    centre += p * cell * middle;
    middle += cell;
  }
}

double VariationalSolution::MeshLoads::before_place(double xi) const {
  const auto cells = static_cast<double>(before.size() - 1);
  const double place = std::clamp((xi + 0.5) * cells, 0.0, cells);
  const std::size_t i = std::min(static_cast<std::size_t>(place), before.size() - 2);
  return before[i] + (place - static_cast<double>(i)) * (before[i + 1] - before[i]);
}

double VariationalSolution::MeshLoads::between(double a, double b) const {
  return std::abs(before_place(b) - before_place(a));
}

std::pair<double, double> VariationalSolution::MeshLoads::largest_average(double length) const {
  const std::size_t cells = before.size() - 1;
  const auto edge = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(cells) - 0.5; };
  std::size_t first = 0, last = cells;
  while (first < last && before[first + 1] == 0) ++first;
  while (first < last && before[last - 1] == before[cells]) --last;
  const double left = edge(first), window = std::min(length, edge(last) - left);
  std::pair<double, double> best{0, 0};
  // The load in a window is linear in its place until one of its ends passes an edge.
  for (std::size_t i = first; i <= last; ++i) {
    for (const double from : {edge(i), edge(i) - window}) {
      const double inside = std::clamp(from, left, edge(last) - window);
      const double mean = between(inside, inside + window) / window;
      if (mean > best.first) best = {mean, inside + window / 2};
    }
  }
  return best;
}

double VariationalSolution::open_error(const std::function<double(const MeshLoads&)>& on_mesh) const {
  double error = 0;
  const double growth = std::exp2(mesh_rate_);
  double weight = 2 / (growth - 1);
  double last = on_mesh(meshes_.front());
  for (std::size_t k = 1; k < meshes_.size(); ++k, weight /= growth) {
    const double next = on_mesh(meshes_[k]);
    error += weight * std::abs(next - last);
    last = next;
  }
  return error;
}

double VariationalSolution::load_in_doubt(const Run& run) const {
  constexpr double few = 16;
  const auto n = static_cast<double>(run.end - run.begin);
  return n < few ? few / (n * n) * meshes_.front().between(mesh().left(run.begin), mesh().right(run.end - 1)) : 0;
}

double VariationalSolution::load_beyond_end(double xi) const {
  double most = 0;
  const auto look = [&](const SingularPlace& end) {
    if (end.exact || std::abs(end.x - unit_ * xi) > end.moved) return;
    const double inside = end.x + (end.contact == Side::right ? end.moved : -end.moved);
    most = std::max(most, meshes_.front().between(end.x / unit_, inside / unit_));
  };
  const auto next = std::lower_bound(ends_.begin(), ends_.end(), unit_ * xi,
                                     [this](std::size_t end, double x) { return places_[end].x < x; });
  if (next != ends_.end()) look(places_[*next]);
  if (next != ends_.begin()) look(places_[*(next - 1)]);
  return most;
}

Resultants<double> VariationalSolution::resultants() const {
  const MeshLoads& fine = meshes_.front();
  std::vector<double> f;
  for (const Rational& value : problem_.friction().values()) f.push_back(to_real<double>(value));
  std::vector<double> jumps;
  for (const Rational& c : problem_.friction().jumps()) jumps.push_back(mesh().place(c));
  const auto share = [&](const MeshLoads& on, std::size_t k) {
    const double before = k == 0 ? 0 : on.before_place(jumps[k - 1]);
    return (k == jumps.size() ? on.before.back() : on.before_place(jumps[k])) - before;
  };
  const auto load = to_real<double>(problem_.load());
  std::vector<Estimate<double>> loads;
  for (std::size_t k = 0; k < f.size(); ++k) loads.push_back({load * share(fine, k), 0});
  Resultants<double> result = resultants_of(loads, problem_.friction().values());
  std::vector<Estimate<double>>& shares = result.load_share;
  Estimate<double>& mu = result.effective_friction;
  for (std::size_t k = 0; k < f.size(); ++k) {
    shares[k].error = 1e-15 + open_error([&](const MeshLoads& on) { return share(on, k); });
  }
  mu.error = 1e-15 * mu.value + open_error([&](const MeshLoads& on) {
               double sum = 0;
               for (std::size_t k = 0; k < f.size(); ++k) sum += f[k] * share(on, k);
               return sum;
             });
  // The equations of the cells are solved to about 1e-13. Symmetric contacts have no other error.
  double centre_error = 1e-13 + open_error([](const MeshLoads& on) { return on.centre; });

  // At jumps.
  std::vector<double> crossing(f.size());
  double lifting = 0;
  double at_short_pieces = 0;
  const double close = 2 * mesh().length(0);
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    const double step = std::abs(f[k + 1] - f[k]);
    const double at_end = load_beyond_end(jumps[k]);
    const bool is_short =
        (k > 0 && jumps[k] - jumps[k - 1] < close) || (k + 1 < jumps.size() && jumps[k + 1] - jumps[k] < close);
    const double in_piece = is_short ? fine.between(jumps[k] - close, jumps[k] + close) : 0;
    mu.error += at_end * step;
    lifting += at_end * step;
    at_short_pieces = std::max(at_short_pieces, in_piece * step);
    for (const std::size_t piece : {k, k + 1}) crossing[piece] += at_end + in_piece;
  }
  mu.error += at_short_pieces;
  lifting = 2 * to_real<double>(problem_.elasticity().gamma()) * (lifting + at_short_pieces);

  // In zones of few cells: one zone gains the load that others lose. The errors of zones are independent, so squares
  // are added.
  std::vector<double> in_zones(f.size());
  double in_all_zones = 0;
  double friction_in_zones = 0;
  double moment_in_zones = 0;
  for (const Run& run : runs_) {
    const double part = load_in_doubt(run);
    const double middle = (mesh().left(run.begin) + mesh().right(run.end - 1)) / 2;
    const auto piece = static_cast<std::size_t>(std::upper_bound(jumps.begin(), jumps.end(), middle) - jumps.begin());
    in_zones[piece] += part * part;
    in_all_zones += part * part;
    friction_in_zones += std::pow(part * (f[piece] - mu.value), 2);
    moment_in_zones += std::pow(part * (middle - fine.centre), 2);
    const Estimate<double> all = load_before(mesh().right(run.end - 1)) - load_before(mesh().left(run.begin));
    result.component_load.push_back(all);
    result.component_load.back().error += load * part + (runs_.size() > 1 ? lifting * all.value : 0);
  }
  for (std::size_t k = 0; k < f.size(); ++k) {
    const double part = shares[k].value;
    shares[k].error += crossing[k] + lifting * part;
    shares[k].error +=
        std::hypot(std::sqrt(in_zones[k]) * (1 - part), std::sqrt(std::max(in_all_zones - in_zones[k], 0.0)) * part);
    mu.error += lifting * part * std::abs(f[k] - mu.value);
  }
  mu.error += std::sqrt(friction_in_zones);
  centre_error += std::sqrt(moment_in_zones);
  if (lifting > 0) {
    for (std::size_t i = 0; i < mesh().size(); ++i) {
      centre_error += lifting * state().pressure[i] * mesh().length(i) * std::abs(mesh().centre(i) - fine.centre);
    }
  }
  result.normal.error = load * (found_.certificate.load + 1e-15);
  result.tangential.error = load * mu.error;
  result.centre_of_pressure = {origin_ + unit_ * fine.centre,
                               unit_ * centre_error + 1e-15 * (std::abs(origin_) + unit_)};
  return result;
}

double VariationalSolution::resultant_error() const {
  const Resultants<double> r = resultants();
  const double hull = edges_[runs_.back().end] - edges_[runs_.front().begin];
  double worst = r.centre_of_pressure.error / hull;
  for (const Estimate<double>& share : r.load_share) worst = std::max(worst, share.error);
  return worst;
}

double VariationalSolution::moved_load() const {
  const MeshLoads& fine = meshes_[0];
  const MeshLoads& coarse = meshes_[1];
  const double hull = mesh().right(runs_.back().end - 1) - mesh().left(runs_.front().begin);
  double worst = std::abs(fine.centre - coarse.centre) / hull;
  double last = 0;
  for (const Rational& c : problem_.friction().jumps()) {
    const double xi = mesh().place(c);
    const double next = fine.before_place(xi) - coarse.before_place(xi);
    worst = std::max(worst, std::abs(next - last));
    last = next;
  }
  return std::max(worst, std::abs(last));
}

AveragePressure<double> VariationalSolution::largest_average_pressure(const double& length) const {
  const double window = length / unit_;
  const auto [mean, middle] = meshes_.front().largest_average(window);
  const double mean_error =
      1e-15 * mean + open_error([&](const MeshLoads& on) { return on.largest_average(window).first; });
  const double moved = open_error([&](const MeshLoads& on) { return on.largest_average(window).second; });
  return {stress_ * Estimate<double>{mean, mean_error}, {origin_ + unit_ * middle, cell_length() + unit_ * moved}};
}

std::optional<Estimate<double>> VariationalSolution::tilt() const {
  if (!problem_.load_at()) return std::nullopt;
  return height_ / unit_ * Estimate<double>{state().tilt, open_error([](const MeshLoads& on) { return on.tilt; })};
}

Estimate<double> VariationalSolution::load_before(double xi) const {
  const auto load = to_real<double>(problem_.load());
  return load * Estimate<double>{meshes_.front().before_place(xi),
                                 1e-15 + open_error([xi](const MeshLoads& on) { return on.before_place(xi); })};
}

}  // namespace steadyslide::numeric
