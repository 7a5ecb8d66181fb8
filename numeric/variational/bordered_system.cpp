#include "numeric/variational/bordered_system.hpp"

#include <Eigen/Jacobi>
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>

#include "numeric/number/dense_lu.hpp"

namespace steadyslide::numeric::variational {
namespace {

using Vector = Eigen::VectorXd;
using Border = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2>;
using Load = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1>;

double largest(const Vector& v) { return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff(); }

/// The borders of B in the equations of a contact set: E, the columns 1 and -xi, and the weights W of the pressures in
/// the loads, h and h xi.
struct LoadColumns {
  Eigen::MatrixXd columns;
  Eigen::MatrixXd weights;
};

LoadColumns load_columns(const DiscreteProblem& problem, const std::vector<std::size_t>& cells) {
  const auto n = static_cast<Eigen::Index>(cells.size());
  const Eigen::Index loads = problem.load_at() ? 2 : 1;
  LoadColumns result{Eigen::MatrixXd::Ones(n, loads), Eigen::MatrixXd(n, loads)};
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t i = cells[static_cast<std::size_t>(k)];
    const double h = problem.mesh().length(i);
    result.weights(k, 0) = h;
    if (loads == 1) continue;
    result.columns(k, 1) = -problem.place(i);
    result.weights(k, 1) = h * problem.mesh().centre(i);
  }
  return result;
}

/// Returns the entries for `cells` of a vector over all cells.
Vector gathered(std::span<const double> all, const std::vector<std::size_t>& cells) {
  return Eigen::Map<const Vector>(all.data(), static_cast<Eigen::Index>(all.size()))(cells);
}

void scatter(const Vector& v, const std::vector<std::size_t>& cells, std::vector<double>& all) {
  Eigen::Map<Vector>(all.data(), static_cast<Eigen::Index>(all.size()))(cells) = v;
}

/// Returns the state of a mesh of `size` cells with these pressures on some of them; the constants are approach and
/// tilt.
DiscreteState state_on(const std::vector<std::size_t>& cells, std::size_t size, const Vector& pressure,
                       const Vector& constants) {
  DiscreteState result{std::vector<double>(size), constants(0), constants.size() == 2 ? constants(1) : 0};
  scatter(pressure, cells, result.pressure);
  return result;
}

/// Unknowns: pressures, approach, tilt. Equations: cells, load, moment.
class Dense : public BorderedSystem {
 public:
  Dense(const DiscreteProblem& problem, const CellSet& contact)
      : size_(contact.size()), cells_(cells_of(contact)), matrix_(matrix(problem)), lu_(matrix_) {}

  SystemSolution solve(std::span<const double> rhs, std::array<double, 2> loads) override {
    const auto n = static_cast<Eigen::Index>(cells_.size());
    const Eigen::Index rest = matrix_.rows() - n;
    Vector right(n + rest);
    right << gathered(rhs, cells_), Eigen::Map<const Vector>(loads.data(), rest);
    const Vector found = lu_.solve(right);
    last_ = {state_on(cells_, size_, found.head(n), found.tail(rest)),
             largest(matrix_.topRows(n) * found - right.head(n))};
    return last_;
  }

  SystemSolution refined(double) override { return last_; }

 private:
  Eigen::MatrixXd matrix(const DiscreteProblem& problem) const {
    const auto n = static_cast<Eigen::Index>(cells_.size());
    const auto [columns, weights] = load_columns(problem, cells_);
    const Eigen::Index loads = columns.cols();
    Eigen::MatrixXd result(n + loads, n + loads);
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Eigen::Index i = 0; i < n; ++i) {
        result(i, j) =
            problem.galerkin_operator().entry(cells_[static_cast<std::size_t>(i)], cells_[static_cast<std::size_t>(j)]);
      }
    }
    result.topRightCorner(n, loads) = -columns;
    result.bottomLeftCorner(loads, n) = weights.transpose();
    result.bottomRightCorner(loads, loads).setZero();
    return result;
  }

  std::size_t size_;
  std::vector<std::size_t> cells_;
  Eigen::MatrixXd matrix_;
  DenseLu lu_;
  SystemSolution last_;
};

constexpr int basis_size = 40;
constexpr int most_cycles = 12;

/// The largest number of zones that are inverted separately. Their matrix is factorised in the time of a few products.
std::size_t most_zones(std::size_t cells) {
  return static_cast<std::size_t>(8 * std::cbrt(static_cast<double>(cells))) / ZoneCoupling::points;
}

/// GMRES for B p - E c = rhs, W^T p = loads. The preconditioner is the same system with the approximate inverse M of
/// the surface in place of B^-1. So the loads are exact in every iterate, and the Krylov space contains residuals on
/// the contact cells. [SS86]
class Krylov : public BorderedSystem {
 public:
  Krylov(const DiscreteProblem& problem, const CellSet& contact, const DiscreteState& guess, double tolerance,
         std::shared_ptr<ContactHull> hull)
      : problem_(problem),
        cells_(cells_of(contact)),
        hull_(std::move(hull)),
        tolerance_(tolerance),
        whole_(hull_->influence.size(), 0.0),
        image_(whole_.size()),
        load_(load_columns(problem, cells_)),
        pressure_(gathered(guess.pressure, cells_)) {
    in_hull_ = cells_;
    for (std::size_t& i : in_hull_) i -= hull_->first;
    const Eigen::Index loads = load_.columns.cols();
    constants_ = Load::Zero(loads);
    constants_(0) = guess.approach;
    if (loads == 2) constants_(1) = guess.tilt;
    prepare_inverse();
    lifted_.resize(pressure_.size(), loads);
    for (Eigen::Index k = 0; k < loads; ++k) lifted_.col(k) = inverse(load_.columns.col(k));
    border_ = DenseLu(load_.weights.transpose() * lifted_).inverse();
  }

  SystemSolution solve(std::span<const double> rhs, std::array<double, 2> loads) override {
    right_ = gathered(rhs, cells_);
    const Load target = Eigen::Map<const Load>(loads.data(), load_.columns.cols());
    residual_ = right_ - operate(pressure_, constants_);
    correct(residual_, target - load_.weights.transpose() * pressure_);
    residual_ = right_ - operate(pressure_, constants_);
    begin_cycle();
    return solution();
  }

  SystemSolution refined(double tolerance) override {
    tolerance_ = tolerance;
    // End a cycle whose basis is nearly full.
    if (2 * static_cast<Eigen::Index>(rotations_.size()) > hessenberg_.cols()) begin_cycle();
    return solution();
  }

 private:
  Vector operate(const Vector& p, const Load& c) {
    scatter(p, in_hull_, whole_);
    hull_->influence.multiply(whole_, image_);
    ++products_;
    return gathered(image_, in_hull_) - load_.columns * c;
  }
  Vector inverse(const Vector& r) {
    scatter(r, in_hull_, whole_);
    hull_->inverse.apply(whole_, image_);
    Vector p = gathered(image_, in_hull_);
    if (coupled_) hull_->coupling->correct(p);
    return p;
  }

  /// Prepares the inverse for the contact zones and their coupling.
  void prepare_inverse() {
    const std::vector<CellRange> zones = contact_zones(in_hull_, most_zones(problem_.size()));
    hull_->inverse.restrict_to(zones);
    if (zones.size() == 1) return;
    hull_->coupling = std::make_unique<ZoneCoupling>(
        hull_->influence, problem_.mesh().length(0), in_hull_, zones,
        [this](const Vector& p) { return operate(p, Load::Zero(load_.columns.cols())); },
        [this](const Vector& r) { return inverse(r); }, hull_->coupling.get());
    coupled_ = true;
  }

  struct Correction {
    Vector p;
    Load c;
  };
  /// Solves the preconditioner's system with the residual r and the given load.
  Correction preconditioned(const Vector& r, const Load& load) {
    Vector p = inverse(r);
    const Load c = border_ * (load - load_.weights.transpose() * p);
    p.noalias() += lifted_ * c;
    return {std::move(p), c};
  }
  void correct(const Vector& r, const Load& load) {
    const Correction step = preconditioned(r, load);
    pressure_ += step.p;
    constants_ += step.c;
  }

  /// True if each entry of the cycle's residual is below the tolerance. The residual is computed only if its 2-norm
  /// does not decide this.
  bool is_small() const {
    auto k = static_cast<Eigen::Index>(rotations_.size());
    const double rest = std::abs(rest_(k));
    const double goal = tolerance_ / 2;
    if (rest <= goal) return true;
    if (rest > goal * std::sqrt(static_cast<double>(cells_.size()))) return false;
    Vector along = Vector::Zero(k + 1);
    along(k) = rest;
    for (; k-- > 0;) along.applyOnTheLeft(k, k + 1, rotations_[static_cast<std::size_t>(k)]);
    return largest(basis_.leftCols(along.size()) * along) <= goal;
  }

  /// Starts a cycle of GMRES from the current pressures.
  void begin_cycle() {
    const auto most = std::min<Eigen::Index>(basis_size, residual_.size());
    const double start = residual_.norm();
    basis_.resize(residual_.size(), most + 1);
    basis_.col(0) = residual_ / (start > 0 ? start : 1);
    hessenberg_ = Eigen::MatrixXd::Zero(most + 1, most);
    rotations_.clear();
    rest_ = Vector::Zero(most + 1);
    rest_(0) = start;
    first_pressure_ = pressure_;
    first_constants_ = constants_;
  }

  /// Makes one step of the cycle.
  void step() {
    const auto k = static_cast<Eigen::Index>(rotations_.size());
    const Correction z = preconditioned(basis_.col(k), Load::Zero(load_.columns.cols()));
    Vector image = operate(z.p, z.c);
    // Classical Gram-Schmidt; two passes are sufficient.
    for (int pass = 0; pass < 2; ++pass) {
      const Vector along = basis_.leftCols(k + 1).transpose() * image;
      image.noalias() -= basis_.leftCols(k + 1) * along;
      hessenberg_.col(k).head(k + 1) += along;
    }
    const double norm = image.norm();
    hessenberg_(k + 1, k) = norm;
    for (Eigen::Index i = 0; i < k; ++i) {
      hessenberg_.col(k).applyOnTheLeft(i, i + 1, rotations_[static_cast<std::size_t>(i)].adjoint());
    }
    Eigen::JacobiRotation<double>& rotation = rotations_.emplace_back();
    rotation.makeGivens(hessenberg_(k, k), hessenberg_(k + 1, k));
    hessenberg_.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
    rest_.applyOnTheLeft(k, k + 1, rotation.adjoint());
    basis_.col(k + 1) = image / (norm > 0 ? norm : 1);
  }

  /// Continues the cycle until its residual is small or its basis is full, and then sets pressures and residual.
  void end_cycle() {
    while (rotations_.size() < static_cast<std::size_t>(hessenberg_.cols()) && !is_small()) step();
    const auto k = static_cast<Eigen::Index>(rotations_.size());
    if (k == 0) return;
    const Vector y = hessenberg_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(rest_.head(k));
    pressure_ = first_pressure_;
    constants_ = first_constants_;
    correct(basis_.leftCols(k) * y, Load::Zero(load_.columns.cols()));
    residual_ = right_ - operate(pressure_, constants_);
  }

  /// Returns the solution of the current cycle.
  SystemSolution solution() {
    double size = largest(residual_);
    for (int cycle = 0; cycle < most_cycles && size > tolerance_; ++cycle) {
      if (cycle > 0) begin_cycle();
      end_cycle();
      const double before = size;
      size = largest(residual_);
      if (size > before / 2) break;  // only rounding remains
    }
    return {state_on(cells_, problem_.size(), pressure_, constants_), size, std::exchange(products_, 0)};
  }

  const DiscreteProblem& problem_;
  std::vector<std::size_t> cells_;
  std::vector<std::size_t> in_hull_;  // the same cells, counted from the hull's first cell
  std::shared_ptr<ContactHull> hull_;
  double tolerance_;
  std::vector<double> whole_;
  std::vector<double> image_;
  LoadColumns load_;
  Eigen::MatrixXd lifted_;
  Border border_;
  Vector right_;
  Vector pressure_;
  Load constants_;
  Vector residual_;
  // A cycle of GMRES: its start and its basis.
  Vector first_pressure_;
  Load first_constants_;
  Eigen::MatrixXd basis_;
  Eigen::MatrixXd hessenberg_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  Vector rest_;
  bool coupled_ = false;
  int products_ = 0;  // number of products since the last solution
};

}  // namespace

ContactHull::ContactHull(const DiscreteProblem& problem, std::size_t first, std::size_t count)
    : first(first),
      influence(problem.galerkin_operator().part(first, count)),
      inverse(influence, problem.mesh().length(0)) {}

std::shared_ptr<ContactHull> contact_hull(const DiscreteProblem& problem, const CellSet& contact,
                                          std::shared_ptr<ContactHull> last) {
  const auto begin = static_cast<std::size_t>(std::find(contact.begin(), contact.end(), 1) - contact.begin());
  const auto end = static_cast<std::size_t>(contact.rend() - std::find(contact.rbegin(), contact.rend(), 1));
  // A contact that grows by a few cells keeps its hull, because planning transforms of a new length costs as much as
  // several products.
  const std::size_t step = std::bit_floor(std::max<std::size_t>((end - begin) / 32, 1));
  const std::size_t first = begin - begin % step;
  const std::size_t behind = std::min((end + step - 1) / step * step, contact.size());
  if (last && last->first == first && last->influence.size() == behind - first) return last;
  last = nullptr;
  return std::make_shared<ContactHull>(problem, first, behind - first);
}

std::vector<CellRange> contact_zones(const std::vector<std::size_t>& cells, std::size_t most) {
  std::vector<std::size_t> gaps;  // 1 + cells between
  for (std::size_t k = 1; k < cells.size(); ++k) {
    if (cells[k] != cells[k - 1] + 1) gaps.push_back(cells[k] - cells[k - 1]);
  }
  std::size_t least = 2;
  if (gaps.size() >= most) {
    const auto place = gaps.begin() + static_cast<std::ptrdiff_t>(most - 1);
    std::nth_element(gaps.begin(), place, gaps.end(), std::greater<>());
    least = *place + 1;
  }
  std::vector<CellRange> zones;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k == 0 || cells[k] - cells[k - 1] >= least) zones.push_back({cells[k], 0});
    zones.back().count = cells[k] + 1 - zones.back().first;
  }
  return zones;
}

std::unique_ptr<BorderedSystem> dense_system(const DiscreteProblem& problem, const CellSet& contact) {
  return std::make_unique<Dense>(problem, contact);
}

std::unique_ptr<BorderedSystem> krylov_system(const DiscreteProblem& problem, const CellSet& contact,
                                              const DiscreteState& guess, double tolerance,
                                              std::shared_ptr<ContactHull> hull) {
  if (!hull) hull = contact_hull(problem, contact);
  return std::make_unique<Krylov>(problem, contact, guess, tolerance, std::move(hull));
}

SystemSolution solve(BorderedSystem& system, const DiscreteProblem& problem) {
  std::vector<double> rhs(problem.size());
  for (std::size_t i = 0; i < rhs.size(); ++i) rhs[i] = -problem.profile()[i];
  return system.solve(rhs, {1, problem.load_at().value_or(0)});
}

}  // namespace steadyslide::numeric::variational
