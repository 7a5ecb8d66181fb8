#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>

#include "numeric/number/dense_lu.hpp"
#include "numeric/variational/bordered_system.hpp"
#include "numeric/variational/surface_inverse.hpp"

namespace steadyslide::numeric::variational {
namespace {

using Vector = Eigen::VectorXd;
using Border = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2>;
using Load = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1>;

constexpr int basis_size = 40;
constexpr int most_restarts = 12;

/// GMRES for B p - E c = rhs, W^T p = loads, E the columns 1 and -xi and W = h E up to the sign, preconditioned by the
/// same system with the surface's approximate inverse M^-1 in place of B^-1: the loads are then met exactly throughout,
/// and the Krylov space is one of residuals on the contact cells. [SS86]
class Krylov : public BorderedSystem {
 public:
  /// `contact`: not empty. Transforms need not be longer than from its first cell to its last one.
  Krylov(const DiscreteProblem& problem, const CellSet& contact, const DiscreteState& guess, double tolerance)
      : problem_(problem),
        cells_(cells_of(contact)),
        influence_(problem.galerkin_operator().part(cells_.front(), cells_.back() + 1 - cells_.front())),
        inverse_(influence_, problem.mesh().length(0)),
        tolerance_(tolerance),
        whole_(influence_.size(), 0.0),
        image_(influence_.size()) {
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
      columns_(k, 1) = -problem.mesh().centre(i);
      weights_(k, 1) = h * problem.mesh().centre(i);
    }
    constants_ = Load::Zero(loads);
    constants_(0) = guess.approach;
    if (loads == 2) constants_(1) = guess.tilt;
    lifted_.resize(n, loads);
    for (Eigen::Index k = 0; k < loads; ++k) lifted_.col(k) = inverse(columns_.col(k));
    border_ = DenseLu(weights_.transpose() * lifted_).inverse();
  }

  SystemSolution solve(std::span<const double> rhs, std::array<double, 2> loads) override {
    const Eigen::Index n = pressure_.size();
    Vector right(n);
    for (Eigen::Index k = 0; k < n; ++k) right(k) = rhs[cells_[static_cast<std::size_t>(k)]];
    const Load target = Eigen::Map<const Load>(loads.data(), columns_.cols());

    products_ = 0;
    Vector residual = right - operate(pressure_, constants_);
    correct(residual, target - weights_.transpose() * pressure_);
    residual = right - operate(pressure_, constants_);
    double size = largest(residual);
    for (int restart = 0; restart < most_restarts && size > tolerance_; ++restart) {
      cycle(residual);
      residual = right - operate(pressure_, constants_);
      const double before = size;
      size = largest(residual);
      if (size > before / 2) break;  // rounding, or no more to be had
    }

    SystemSolution result;
    result.state.pressure.assign(problem_.size(), 0);
    for (Eigen::Index k = 0; k < n; ++k) result.state.pressure[cells_[static_cast<std::size_t>(k)]] = pressure_(k);
    result.state.approach = constants_(0);
    if (constants_.size() == 2) result.state.tilt = constants_(1);
    result.residual = size;
    result.products = products_;
    return result;
  }

 private:
  static double largest(const Vector& v) { return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff(); }

  void scatter(const Vector& v) {
    for (Eigen::Index k = 0; k < v.size(); ++k) whole_[cells_[static_cast<std::size_t>(k)] - cells_.front()] = v(k);
  }
  Vector gathered() const {
    Vector v(static_cast<Eigen::Index>(cells_.size()));
    for (Eigen::Index k = 0; k < v.size(); ++k) v(k) = image_[cells_[static_cast<std::size_t>(k)] - cells_.front()];
    return v;
  }

  Vector operate(const Vector& p, const Load& c) {
    scatter(p);
    influence_.multiply(whole_, image_);
    ++products_;
    return gathered() - columns_ * c;
  }
  Vector inverse(const Vector& r) {
    scatter(r);
    inverse_.apply(whole_, image_);
    return gathered();
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

  /// One cycle of GMRES from the residual given.
  void cycle(const Vector& residual) {
    const Eigen::Index n = residual.size();
    const auto most = static_cast<int>(std::min<Eigen::Index>(basis_size, n));
    const Load none = Load::Zero(columns_.cols());
    const double start = residual.norm();
    const double goal = tolerance_ / 4 * std::min(1.0, start / largest(residual));
    basis_.resize(n, most + 1);
    basis_.col(0) = residual / start;
    Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most + 1, most);
    std::vector<Eigen::JacobiRotation<double>> rotations;
    Vector right = Vector::Zero(most + 1);
    right(0) = start;
    int k = 0;
    while (k < most && std::abs(right(k)) > goal) {
      const Correction z = preconditioned(basis_.col(k), none);
      Vector image = operate(z.p, z.c);
      // Twice is enough: Gram-Schmidt with all vectors at once.
      for (int pass = 0; pass < 2; ++pass) {
        const Vector along = basis_.leftCols(k + 1).transpose() * image;
        image.noalias() -= basis_.leftCols(k + 1) * along;
        hessenberg.col(k).head(k + 1) += along;
      }
      const double rest = image.norm();
      hessenberg(k + 1, k) = rest;
      for (int i = 0; i < k; ++i) {
        hessenberg.col(k).applyOnTheLeft(i, i + 1, rotations[static_cast<std::size_t>(i)].adjoint());
      }
      Eigen::JacobiRotation<double> rotation;
      rotation.makeGivens(hessenberg(k, k), hessenberg(k + 1, k));
      rotations.push_back(rotation);
      hessenberg.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
      right.applyOnTheLeft(k, k + 1, rotation.adjoint());
      ++k;
      if (rest == 0) break;
      basis_.col(k) = image / rest;
    }
    if (k == 0) return;
    const Vector y = hessenberg.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(right.head(k));
    correct(basis_.leftCols(k) * y, none);
  }

  const DiscreteProblem& problem_;
  std::vector<std::size_t> cells_;
  GalerkinOperator influence_;
  SurfaceInverse inverse_;
  double tolerance_;
  std::vector<double> whole_;
  std::vector<double> image_;
  Eigen::MatrixXd columns_;
  Eigen::MatrixXd weights_;
  Eigen::MatrixXd lifted_;
  Border border_;
  Eigen::MatrixXd basis_;
  Vector pressure_;
  Load constants_;
  int products_ = 0;
};

}  // namespace

std::unique_ptr<BorderedSystem> krylov_system(const DiscreteProblem& problem, const CellSet& contact,
                                              const DiscreteState& guess, double tolerance) {
  return std::make_unique<Krylov>(problem, contact, guess, tolerance);
}

}  // namespace steadyslide::numeric::variational
