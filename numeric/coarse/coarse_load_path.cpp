#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "numeric/coarse/coarse_equilibrium.hpp"

namespace steadyslide::numeric::coarse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The linear equations of a contact set that changes by one cell at a time, by their inverse. Unknowns: C, the tilt if
/// there is one, the forces; equations: the load, its moment, no gap in the cells of contact.
class BorderedInverse {
 public:
  BorderedInverse(const Mesh& mesh, const Load& load, const std::vector<double>& profile)
      : mesh_(mesh), load_(load), profile_(profile), rest_(load.at ? 2 : 1) {}

  Index rest() const { return rest_; }
  const std::vector<std::size_t>& cells() const { return cells_; }

  void start(const std::vector<std::size_t>& cells) {
    cells_ = cells;
    factorise();
  }

  void add(std::size_t cell) {
    const Index n = inverse_.rows();
    cells_.push_back(cell);
    if (++changes_ % refresh == 0) return factorise();
    const VectorXd column = inverse_ * column_of(cell);
    const Eigen::RowVectorXd row = row_of(cell) * inverse_;
    const double pivot = mesh_.column(cell)[cell] - row_of(cell).dot(column);
    MatrixXd larger(n + 1, n + 1);
    larger.topLeftCorner(n, n) = inverse_ + column * row / pivot;
    larger.topRightCorner(n, 1) = -column / pivot;
    larger.bottomLeftCorner(1, n) = -row / pivot;
    larger(n, n) = 1 / pivot;
    inverse_ = std::move(larger);
  }

  void remove(std::size_t cell) {
    const auto place = std::find(cells_.begin(), cells_.end(), cell) - cells_.begin();
    const Index last = inverse_.rows() - 1;
    inverse_.row(rest_ + place).swap(inverse_.row(last));
    inverse_.col(rest_ + place).swap(inverse_.col(last));
    std::swap(cells_[static_cast<std::size_t>(place)], cells_.back());
    cells_.pop_back();
    if (++changes_ % refresh == 0) return factorise();
    const MatrixXd smaller = inverse_.topLeftCorner(last, last) - inverse_.topRightCorner(last, 1) *
                                                                      inverse_.bottomLeftCorner(1, last) /
                                                                      inverse_(last, last);
    inverse_ = smaller;
  }

  /// The state is linear in the load: its constant part and its factor.
  VectorXd constant() const {
    VectorXd right = VectorXd::Zero(inverse_.rows());
    for (std::size_t k = 0; k < cells_.size(); ++k) right(rest_ + static_cast<Index>(k)) = -profile_[cells_[k]];
    return inverse_ * right;
  }
  VectorXd factor() const { return inverse_.col(0); }

 private:
  static constexpr int refresh = 64;

  /// Without the cell's own entry: the coefficients of its force in the equations so far, and of its own equation.
  VectorXd column_of(std::size_t cell) {
    VectorXd column(inverse_.rows());
    column(0) = 1;
    if (load_.at) column(1) = mesh_.centre(cell) - *load_.at;
    const double* all = mesh_.column(cell);
    for (Index k = rest_; k < column.size(); ++k) column(k) = all[cells_[static_cast<std::size_t>(k - rest_)]];
    return column;
  }
  Eigen::RowVectorXd row_of(std::size_t cell) {
    Eigen::RowVectorXd row(inverse_.rows());
    row(0) = -1;
    if (load_.at) row(1) = mesh_.point(cell);
    for (Index k = rest_; k < row.size(); ++k) {
      row(k) = mesh_.column(cells_[static_cast<std::size_t>(k - rest_)])[cell];
    }
    return row;
  }

  void factorise() {
    const Index n = rest_ + static_cast<Index>(cells_.size());
    inverse_.resize(n, n);
    MatrixXd matrix = MatrixXd::Zero(n, n);
    for (Index k = rest_; k < n; ++k) {
      const std::size_t cell = cells_[static_cast<std::size_t>(k - rest_)];
      matrix.col(k) = column_of(cell);
      matrix.row(k).head(rest_) = row_of(cell).head(rest_);
    }
    inverse_ = matrix.inverse();
  }

  const Mesh& mesh_;
  const Load& load_;
  const std::vector<double>& profile_;
  Index rest_;
  int changes_ = 0;
  std::vector<std::size_t> cells_;
  MatrixXd inverse_;
};

/// Cells that touch when there is no load yet: the lowest one, or the two that span the load line on the lower hull.
std::vector<std::size_t> first_contact(const Mesh& mesh, const Load& load, const std::vector<double>& psi) {
  if (!load.at) return {static_cast<std::size_t>(std::min_element(psi.begin(), psi.end()) - psi.begin())};
  std::vector<std::size_t> hull;
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const auto above = [&](std::size_t a, std::size_t b) {
      return (psi[b] - psi[a]) * (mesh.point(i) - mesh.point(a)) >= (psi[i] - psi[a]) * (mesh.point(b) - mesh.point(a));
    };
    while (hull.size() >= 2 && above(hull[hull.size() - 2], hull.back())) hull.pop_back();
    hull.push_back(i);
  }
  std::size_t k = 1;
  while (k + 1 < hull.size() && mesh.centre(hull[k]) < *load.at) ++k;
  return {hull[k - 1], hull[k]};
}

/// Flat faces and equal minima touch everywhere at once; a slight curvature, the same every time, gives them an order.
std::vector<double> with_order(const Mesh& mesh, const Load& load) {
  const std::vector<double>& edges = mesh.edges();
  const double width = edges.back() - edges.front();
  std::vector<double> psi(mesh.size());
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const double x = (mesh.point(i) - edges.front()) / width - 0.4142135;
    psi[i] = mesh.profile(i) + 1e-8 * load.force * x * x;
  }
  return psi;
}

}  // namespace

std::vector<char> load_path(const Mesh& mesh, const Load& load) {
  const std::size_t size = mesh.size();
  const std::vector<double> psi = with_order(mesh, load);
  BorderedInverse contact(mesh, load, psi);
  std::vector<char> active(size, 0);
  contact.start(first_contact(mesh, load, psi));
  for (std::size_t cell : contact.cells()) active[cell] = 1;
  double force = 0;
  double direction = 1;
  std::size_t changed = size;
  for (std::size_t pivots = 0; pivots < 20 * size + 100; ++pivots) {
    const VectorXd constant = contact.constant();
    const VectorXd factor = contact.factor();
    if (!constant.allFinite() || !factor.allFinite()) return {};
    VectorXd value(static_cast<Index>(size));
    VectorXd rate(static_cast<Index>(size));
    for (std::size_t i = 0; i < size; ++i) {
      const auto k = static_cast<Index>(i);
      value(k) = psi[i] - constant(0) + (load.at ? constant(1) * mesh.point(i) : 0);
      rate(k) = -factor(0) + (load.at ? factor(1) * mesh.point(i) : 0);
    }
    for (std::size_t k = 0; k < contact.cells().size(); ++k) {
      const Eigen::Map<const VectorXd> column(mesh.column(contact.cells()[k]), value.size());
      const Index at = contact.rest() + static_cast<Index>(k);
      value += constant(at) * column;
      rate += factor(at) * column;
    }
    for (std::size_t k = 0; k < contact.cells().size(); ++k) {
      const Index at = contact.rest() + static_cast<Index>(k);
      value(static_cast<Index>(contact.cells()[k])) = constant(at);
      rate(static_cast<Index>(contact.cells()[k])) = factor(at);
    }
    // What has just become zero has to grow now: that says where the load goes.
    if (changed < size) direction = rate(static_cast<Index>(changed)) < 0 ? -1 : 1;
    double way = direction > 0 ? load.force - force : HUGE_VAL;
    std::size_t next = size;
    for (std::size_t i = 0; i < size; ++i) {
      const auto k = static_cast<Index>(i);
      if (i == changed || direction * rate(k) >= 0) continue;
      const double until = std::max(0.0, value(k) + force * rate(k)) / -(direction * rate(k));
      if (until < way) {
        way = until;
        next = i;
      }
    }
    if (next == size) return std::isfinite(way) ? active : std::vector<char>{};
    force += direction * way;
    if (force < 0) return {};
    if (active[next]) {
      contact.remove(next);
    } else {
      contact.add(next);
    }
    active[next] = !active[next];
    changed = next;
  }
  return {};
}

}  // namespace steadyslide::numeric::coarse
