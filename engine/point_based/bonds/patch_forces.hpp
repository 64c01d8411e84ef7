#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/point_based/bonds/weighted_nodes.hpp"
#include "scheduler/workers.hpp"

namespace pliant::point_based {

/// The forces r of a uniform stress on nodes with weighted bonds, and their derivative J = dr/dc
/// with respect to c = ln of the factors of the weights; see PatchTest. Functions with a node `i`
/// may be called for all nodes in parallel.
template <int D>
class PatchForces {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;
  using Matrix = Eigen::Matrix<double, D, D>;
  using Vectors = std::vector<Vector>;

  PatchForces(const WeightedNodes<D>& nodes, scheduler::Workers& workers);

  std::size_t nodes() const { return force_.size(); }
  std::size_t bonds() const { return bonds_.size(); }
  /// The first bond of a node; that of the number of nodes is the end.
  std::int64_t first_bond(std::size_t i) const { return first_[i]; }

  /// Calls f(i) for every node, in parallel.
  template <class F>
  void for_each_node(F&& f) const {
    sum_over_nodes([&f](std::size_t i) {
      f(i);
      return 0.;
    });
  }

  /// The sum of f(i) over all nodes, in parallel but in one order.
  template <class F>
  double sum_over_nodes(F&& f) const {
    constexpr std::size_t nodes_of_a_task = 256;
    const auto tasks = static_cast<int>((nodes() + nodes_of_a_task - 1) / nodes_of_a_task);
    const auto sum_of_task = [&](int task) {
      const std::size_t first = nodes_of_a_task * static_cast<std::size_t>(task);
      Sum sum;
      for (std::size_t i = first; i < std::min(nodes(), first + nodes_of_a_task); ++i) {
        sum.value += f(i);
      }
      return sum;
    };
    return workers_.sum<Sum>(tasks, sum_of_task).value;
  }

  /// Computes gradients and r of the present weights, and the diagonal blocks of J J^T.
  void evaluate();

  const Vector& force(std::size_t i) const { return force_[i]; }  ///< r
  const Matrix& block(std::size_t i) const { return block_[i]; }  ///< on the diagonal of J J^T

  /// The part of a force on node i that no wall bears.
  Vector unborne(std::size_t i, const Vector& force) const;
  /// The inverse of a diagonal block for such parts.
  Matrix inverse_block(std::size_t i, const Matrix& block) const;

  /// Calls found(bond, component of J^T y) for the bonds of node i.
  template <class Found>
  void find_changes(std::size_t i, const Vectors& y, Found&& found) const {
    Matrix slope = Matrix::Zero();
    for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
      slope += bonds_[k].weight * (y[bonds_[k].node] - y[i]) * bonds_[k].x.transpose();
    }
    slope /= nodes_.volumes[i];
    for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Bond& bond = bonds_[k];
      found(k, bond.weight * (y[bond.node] - y[i] - slope * bond.u).dot(bond.u));
    }
  }

  /// (J J^T + added I) y, without the part that walls bear. Returns its product with y.
  double apply(const Vectors& y, double added, Vectors& result);

 private:
  static constexpr int pairs = D * (D + 1) / 2;
  using Pairs = Eigen::Matrix<double, pairs, 1>;  ///< components a <= b of a symmetric matrix

  struct Bond {
    std::int32_t node;
    Vector x, u;        ///< X_ij; A^-1 X_ij
    double weight = 0;  ///< V_i w_ij
  };
  /// Nodes whose bonds one task treats.
  struct Part {
    std::size_t first, end;
    std::size_t lowest, beyond;  ///< the nodes that they reach
    Vectors force;               ///< [node - lowest]
    std::vector<Pairs> block;    ///< [node - lowest]
  };
  struct Sum {
    double value = 0;
    friend void add(Sum& sum, const Sum& part) { sum.value += part.value; }
  };

  void make_bonds();
  void make_parts();
  Matrix free(std::size_t i) const;
  void find_gradient(std::size_t i);
  void add_forces(std::size_t i, Part& part) const;
  void add_blocks(std::size_t i, Part& part) const;
  void add_forces_of_change(std::size_t i, const Vectors& y, Part& part) const;
  template <class F>
  void for_each_part(F&& f);
  Vector total_force(std::size_t i) const;

  const WeightedNodes<D>& nodes_;
  scheduler::Workers& workers_;
  std::vector<std::int64_t> first_;  ///< [node] its first bond; one more at the end
  std::vector<Bond> bonds_;          ///< [bond]
  std::vector<Part> parts_;
  Vectors force_;              ///< [node]
  std::vector<Matrix> block_;  ///< [node]
};

}  // namespace pliant::point_based
