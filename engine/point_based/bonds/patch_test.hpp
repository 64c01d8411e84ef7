#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/point_based/bonds/weighted_nodes.hpp"

/// Weights with which moving least squares pass the patch test.
///
/// A uniform stress P exerts P r_i on node i, apart from the load on its share of the surface,
/// where r_i = sum_j (V_j g_ji - V_i g_ij) - a_i. There are many more bonds than components of r.
/// Of all changes of the weights that make r vanish, the smallest is computed. With c = ln of the
/// factors and J = dr/dc, each step solves (J J^T + a I) y = -r by conjugate gradients and adds J^T
/// y to c; a = 0 makes it a Gauss-Newton step. Gradients still follow from the weights: they stay
/// exact for linear fields, and a step costs the same.
namespace pliant::point_based {

/// The forces of a uniform stress on nodes with weighted bonds, and steps that reduce them.
template <int D>
class PatchTest {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;
  using Matrix = Eigen::Matrix<double, D, D>;
  using Vectors = std::vector<Vector>;

  /// No weight changes by more than the factor `most_change`, or its inverse. Steps that are far
  /// too long become those of Levenberg and Marquardt, with `regularisation` times the mean of the
  /// diagonal.
  explicit PatchTest(WeightedNodes<D>& nodes,
                     double most_change = std::numeric_limits<double>::infinity(),
                     double regularisation = 0)
      : nodes_(nodes),
        most_change_(std::log(most_change)),
        regularisation_(regularisation),
        all_(nodes.positions.size()) {
    force_.resize(all_.size());
    scale_.resize(all_.size());
    block_.resize(all_.size());
    for (std::size_t i = 0; i < all_.size(); ++i) {
      for (const std::int32_t j : nodes.neighbour[i]) {
        Bond& bond = all_[i].bonds.emplace_back();
        bond.node = j;
        for (int a = 0; a < D; ++a) bond.x[a] = nodes.positions[j][a] - nodes.positions[i][a];
      }
    }
    evaluate();
  }

  double worst() const {
    double most = 0;
    for (std::size_t i = 0; i < force_.size(); ++i) {
      const double area = std::pow(nodes_.volumes[i], (D - 1.) / D);
      most = std::max(most, unborne(i, force_[i]).norm() / area);
    }
    return most;
  }

  /// Sum of the squared forces that no wall bears.
  double square() const {
    double sum = 0;
    for (std::size_t i = 0; i < force_.size(); ++i) sum += unborne(i, force_[i]).squaredNorm();
    return sum;
  }

  /// One step; its equations are solved to `tolerance`. A step that increases the sum of the
  /// squares is halved. Returns whether any decreases it; if none does, the weights stay.
  bool improve(double tolerance, int most_iterations) {
    const double before = square();
    double longest = find_change(tolerance, most_iterations, 0);
    if (longest > far_too_long && regularisation_ > 0) {
      longest = find_change(tolerance, most_iterations, regularisation_ * mean_of_diagonal());
    }
    double share = std::min(1., longest_step / longest);
    for (int halving = 0; halving <= most_halvings; ++halving, share /= 2) {
      move(share);
      if (square() < before) return true;
    }
    move(0);
    return false;
  }

 private:
  static constexpr int most_halvings = 4;
  static constexpr double longest_step = 1;  // of ln c
  // Longer steps are those of bonds that hardly act on any force.
  static constexpr double far_too_long = 4;
  static constexpr double few = 1e-6;  // relative to the largest eigenvalue of a block

  struct Bond {
    std::int32_t node;
    Vector x, u;            ///< X_ij; A^-1 X_ij
    double weight, change;  ///< V_i w_ij; change of ln c
    double log = 0;         ///< ln c
    double start = 0;       ///< ln c at the start of a step
  };
  struct Node {
    std::vector<Bond> bonds;
  };

  static Matrix unit() { return Matrix::Identity(); }

  double mean_of_diagonal() const {
    double sum = 0;
    for (const Matrix& block : block_) sum += block.trace();
    return sum / (D * static_cast<double>(block_.size()));
  }

  /// Sets the changes of a step with `added` on the diagonal of J J^T. Returns the longest one.
  double find_change(double tolerance, int most_iterations, double added) {
    added_ = added;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      scale_[i] = inverse_block(i, block_[i] + added_ * unit());
    }
    const Vectors y = solve(tolerance, most_iterations);
    double longest = 0;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      change(i, y);
      for (Bond& bond : all_[i].bonds) {
        bond.start = bond.log;
        longest = std::max(longest, std::abs(bond.change));
      }
    }
    return longest;
  }

  /// Moves the weights from the start of a step by a share of the change.
  void move(double share) {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      for (std::size_t k = 0; k < all_[i].bonds.size(); ++k) {
        Bond& bond = all_[i].bonds[k];
        const double log =
            std::clamp(bond.start + share * bond.change, -most_change_, most_change_);
        nodes_.weight[i][k] *= std::exp(log - bond.log);
        bond.log = log;
      }
    }
    evaluate();
  }

  /// The projection onto the directions in which no wall bears the force on node i.
  Matrix free(std::size_t i) const {
    if (nodes_.free.empty()) return unit();
    return Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(nodes_.free[i].data());
  }

  /// The part of a force on node i that no wall bears.
  Vector unborne(std::size_t i, const Vector& force) const {
    return nodes_.free.empty() ? force : free(i) * force;
  }

  /// The inverse of a diagonal block for such parts.
  Matrix inverse_block(std::size_t i, const Matrix& block) const {
    if (free(i).isZero()) return Matrix::Zero();
    // The bonds of its neighbours alone may reach a node in one direction only.
    if (all_[i].bonds.empty()) return inverse_block_along(i, block + few * block.trace() * unit());
    return inverse_block_along(i, block);
  }

  Matrix inverse_block_along(std::size_t i, const Matrix& block) const {
    if (nodes_.free.empty()) return block.inverse();
    const Matrix along = free(i);
    return along * (along * block * along + block.trace() * (unit() - along)).inverse() * along;
  }

  /// Computes gradients and r of the present weights, and the diagonal blocks of J J^T.
  void evaluate() {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      force_[i] = -Eigen::Map<const Vector>(nodes_.areas[i].data());
      block_[i].setZero();
    }
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Matrix moment = Matrix::Zero();
      for (std::size_t k = 0; k < all_[i].bonds.size(); ++k) {
        const Bond& bond = all_[i].bonds[k];
        moment += nodes_.weight[i][k] * bond.x * bond.x.transpose();
      }
      const Matrix inverse = moment.inverse();
      for (std::size_t k = 0; k < all_[i].bonds.size(); ++k) {
        Bond& bond = all_[i].bonds[k];
        bond.u = inverse * bond.x;
        bond.weight = nodes_.volumes[i] * nodes_.weight[i][k];
        force_[bond.node] += bond.weight * bond.u;
        force_[i] -= bond.weight * bond.u;
      }
      add_to_diagonal(i);
    }
  }

  void add_to_diagonal(std::size_t i) {
    const double volume = nodes_.volumes[i];
    Vector sum = Vector::Zero();  // sum of w X
    for (const Bond& bond : all_[i].bonds) sum += bond.weight / volume * bond.x;
    for (const Bond& by : all_[i].bonds) {
      const Matrix square = by.weight * by.weight * by.u * by.u.transpose();
      block_[i] += std::pow(1 - by.u.dot(sum), 2) * square;
      for (const Bond& on : all_[i].bonds) {
        const double own = &on == &by ? 1 : 0;
        block_[on.node] += std::pow(own - on.weight / volume * by.u.dot(on.x), 2) * square;
      }
    }
  }

  /// Sets J^T y for the bonds of node i.
  void change(std::size_t i, const Vectors& y) {
    Matrix slope = Matrix::Zero();
    for (const Bond& bond : all_[i].bonds) {
      slope += bond.weight / nodes_.volumes[i] * (y[bond.node] - y[i]) * bond.x.transpose();
    }
    for (Bond& bond : all_[i].bonds) {
      bond.change = bond.weight * ((y[bond.node] - y[i]).dot(bond.u) - bond.u.dot(slope * bond.u));
    }
  }

  /// result = (J J^T + added_ I) y.
  void apply(const Vectors& y, Vectors& result) {
    for (std::size_t i = 0; i < y.size(); ++i) result[i] = added_ * y[i];
    for (std::size_t i = 0; i < all_.size(); ++i) {
      change(i, y);
      Matrix turned = Matrix::Zero();
      for (const Bond& bond : all_[i].bonds) {
        turned += bond.change * bond.weight / nodes_.volumes[i] * bond.u * bond.u.transpose();
      }
      for (const Bond& bond : all_[i].bonds) {
        const Vector moved = bond.weight * (bond.change * bond.u - turned * bond.x);
        result[bond.node] += moved;
        result[i] -= moved;
      }
    }
  }

  /// Solves (J J^T + added_ I) y = -r by conjugate gradients; y = 0 where walls bear any force.
  Vectors solve(double tolerance, int most_iterations) {
    Vectors y(all_.size(), Vector::Zero()), rest = force_, scaled(all_.size()), way, image = force_;
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = unborne(i, -force_[i]);
    const auto scale = [&] {
      double product = 0;
      for (std::size_t i = 0; i < rest.size(); ++i) {
        scaled[i] = scale_[i] * rest[i];
        product += scaled[i].dot(rest[i]);
      }
      return product;
    };
    double product = scale();
    way = scaled;
    const double enough = tolerance * tolerance * product;
    for (int k = 0; k < most_iterations && product > enough; ++k) {
      apply(way, image);
      for (std::size_t i = 0; i < way.size(); ++i) image[i] = unborne(i, image[i]);
      double curvature = 0;
      for (std::size_t i = 0; i < way.size(); ++i) curvature += way[i].dot(image[i]);
      if (!(curvature > 0)) break;
      const double length = product / curvature;
      for (std::size_t i = 0; i < way.size(); ++i) {
        y[i] += length * way[i];
        rest[i] -= length * image[i];
      }
      const double before = product;
      product = scale();
      for (std::size_t i = 0; i < way.size(); ++i) way[i] = scaled[i] + product / before * way[i];
    }
    return y;
  }

  WeightedNodes<D>& nodes_;
  double most_change_;  ///< of ln c
  double regularisation_;
  double added_ = 0;  ///< to the diagonal of J J^T
  std::vector<Node> all_;
  Vectors force_;              ///< r
  std::vector<Matrix> block_;  ///< diagonal blocks of J J^T
  std::vector<Matrix> scale_;  ///< inverse of these, with what is added
};

}  // namespace pliant::point_based
