#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/number/dense_lu.hpp"
#include "numeric/variational/bordered_system.hpp"
#include "numeric/variational/contact_hull.hpp"

namespace steadyslide::numeric::variational {
namespace {

using Vector = Eigen::VectorXd;
using Border = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2>;
using Load = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1>;

constexpr int basis_size = 40;
constexpr int most_cycles = 12;

/// Of zones that are inverted by themselves: their matrix is factorised in the time of some products.
std::size_t most_zones(std::size_t cells) {
  return static_cast<std::size_t>(8 * std::cbrt(static_cast<double>(cells))) / ZoneCoupling::points;
}

/// GMRES for B p - E c = rhs, W^T p = loads, E the columns 1 and -xi and W = h E up to the sign, preconditioned by the
/// same system with the surface's approximate inverse M^-1 in place of B^-1: the loads are then met exactly throughout,
/// and the Krylov space is one of residuals on the contact cells. [SS86]
class Krylov : public BorderedSystem {
 public:
  Krylov(const DiscreteProblem& problem, const CellSet& contact, const DiscreteState& guess, double tolerance,
         std::shared_ptr<ContactHull> hull)
      : problem_(problem),
        cells_(cells_of(contact)),
        hull_(std::move(hull)),
        tolerance_(tolerance),
        whole_(hull_->influence.size(), 0.0),
        image_(whole_.size()) {
    const auto n = static_cast<Eigen::Index>(cells_.size());
    const Eigen::Index loads = problem.load_at() ? 2 : 1;
    columns_.resize(n, loads);
    weights_.resize(n, loads);
    pressure_.resize(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::size_t i = cells_[static_cast<std::size_t>(k)];
      const double h = problem.mesh().length(i);
      columns_(k, 0) = 1;
      weights_(k, 0) = h;
      pressure_(k) = guess.pressure[i];
      if (loads == 1) continue;
      columns_(k, 1) = -problem.place(i);
      weights_(k, 1) = h * problem.mesh().centre(i);
    }
    constants_ = Load::Zero(loads);
    constants_(0) = guess.approach;
    if (loads == 2) constants_(1) = guess.tilt;
    prepare_inverse();
    lifted_.resize(n, loads);
    for (Eigen::Index k = 0; k < loads; ++k) lifted_.col(k) = inverse(columns_.col(k));
    border_ = DenseLu(weights_.transpose() * lifted_).inverse();
  }

  SystemSolution solve(std::span<const double> rhs, std::array<double, 2> loads) override {
    right_.resize(pressure_.size());
    for (Eigen::Index k = 0; k < right_.size(); ++k) right_(k) = rhs[cells_[static_cast<std::size_t>(k)]];
    const Load target = Eigen::Map<const Load>(loads.data(), columns_.cols());
    residual_ = right_ - operate(pressure_, constants_);
    correct(residual_, target - weights_.transpose() * pressure_);
    residual_ = right_ - operate(pressure_, constants_);
    begin_cycle();
    return solution();
  }

  SystemSolution refined(double tolerance) override {
    tolerance_ = tolerance;
    // A cycle that has little room left ends here.
    if (2 * static_cast<Eigen::Index>(rotations_.size()) > hessenberg_.cols()) begin_cycle();
    return solution();
  }

 private:
  static double largest(const Vector& v) { return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff(); }

  void scatter(const Vector& v) {
    for (Eigen::Index k = 0; k < v.size(); ++k) whole_[cells_[static_cast<std::size_t>(k)] - hull_->first] = v(k);
  }
  Vector gathered() const {
    Vector v(static_cast<Eigen::Index>(cells_.size()));
    for (Eigen::Index k = 0; k < v.size(); ++k) v(k) = image_[cells_[static_cast<std::size_t>(k)] - hull_->first];
    return v;
  }

  Vector operate(const Vector& p, const Load& c) {
    scatter(p);
    hull_->influence.multiply(whole_, image_);
    ++products_;
    return gathered() - columns_ * c;
  }
  Vector inverse(const Vector& r) {
    scatter(r);
    hull_->inverse.apply(whole_, image_);
    Vector p = gathered();
    if (coupled_) hull_->coupling->correct(p);
    return p;
  }

  /// The inverse is made for the contact's zones, and what they do to each other.
  void prepare_inverse() {
    std::vector<std::size_t> cells = cells_;
    for (std::size_t& i : cells) i -= hull_->first;
    const std::vector<CellRange> zones = contact_zones(cells, most_zones(problem_.size()));
    hull_->inverse.restrict_to(zones);
    if (zones.size() == 1) return;
    hull_->coupling = std::make_unique<ZoneCoupling>(
        hull_->influence, problem_.mesh().length(0), cells, zones,
        [this](const Vector& p) { return operate(p, Load::Zero(columns_.cols())); },
        [this](const Vector& r) { return inverse(r); }, hull_->coupling.get());
    coupled_ = true;
  }

  struct Correction {
    Vector p;
    Load c;
  };
  /// M p - E c = r, W^T p = load.
  Correction preconditioned(const Vector& r, const Load& load) {
    Vector p = inverse(r);
    const Load c = border_ * (load - weights_.transpose() * p);
    p.noalias() += lifted_ * c;
    return {std::move(p), c};
  }
  void correct(const Vector& r, const Load& load) {
    const Correction step = preconditioned(r, load);
    pressure_ += step.p;
    constants_ += step.c;
  }

  /// Is the cycle's residual below the tolerance in each of its entries? It is formed only where its 2-norm leaves that open.
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

  /// GMRES starts from here.
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

  /// One step of the cycle.
  void step() {
    const auto k = static_cast<Eigen::Index>(rotations_.size());
    const Correction z = preconditioned(basis_.col(k), Load::Zero(columns_.cols()));
    Vector image = operate(z.p, z.c);
    // Twice is enough: Gram-Schmidt with all vectors at once.
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

  /// The cycle goes on until its residual is small or its basis full; then pressures and residual are those of its end.
  void end_cycle() {
    while (rotations_.size() < static_cast<std::size_t>(hessenberg_.cols()) && !is_small()) step();
    const auto k = static_cast<Eigen::Index>(rotations_.size());
    if (k == 0) return;
    const Vector y = hessenberg_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(rest_.head(k));
    pressure_ = first_pressure_;
    constants_ = first_constants_;
    correct(basis_.leftCols(k) * y, Load::Zero(columns_.cols()));
    residual_ = right_ - operate(pressure_, constants_);
  }

  /// From the cycle that was begun.
  SystemSolution solution() {
    double size = largest(residual_);
    for (int cycle = 0; cycle < most_cycles && size > tolerance_; ++cycle) {
      if (cycle > 0) begin_cycle();
      end_cycle();
      const double before = size;
      size = largest(residual_);
      if (size > before / 2) break;  // rounding, or no more to be had
    }
    SystemSolution result;
    result.state.pressure.assign(problem_.size(), 0);
    for (Eigen::Index k = 0; k < pressure_.size(); ++k) {
      result.state.pressure[cells_[static_cast<std::size_t>(k)]] = pressure_(k);
    }
    result.state.approach = constants_(0);
    if (constants_.size() == 2) result.state.tilt = constants_(1);
    result.residual = size;
    result.products = std::exchange(products_, 0);
    return result;
  }

  const DiscreteProblem& problem_;
  std::vector<std::size_t> cells_;
  std::shared_ptr<ContactHull> hull_;
  double tolerance_;
  std::vector<double> whole_;
  std::vector<double> image_;
  Eigen::MatrixXd columns_;
  Eigen::MatrixXd weights_;
  Eigen::MatrixXd lifted_;
  Border border_;
  Vector right_;
  Vector pressure_;
  Load constants_;
  Vector residual_;
  // A cycle of GMRES: where it began, and what it has found.
  Vector first_pressure_;
  Load first_constants_;
  Eigen::MatrixXd basis_;
  Eigen::MatrixXd hessenberg_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  Vector rest_;
  bool coupled_ = false;
  int products_ = 0;  // since the last solution
};

}  // namespace

std::unique_ptr<BorderedSystem> krylov_system(const DiscreteProblem& problem, const CellSet& contact,
                                              const DiscreteState& guess, double tolerance,
                                              std::shared_ptr<ContactHull> hull) {
  if (!hull) hull = contact_hull(problem, contact);
  return std::make_unique<Krylov>(problem, contact, guess, tolerance, std::move(hull));
}

}  // namespace steadyslide::numeric::variational
