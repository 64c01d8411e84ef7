#include "engine/point_based/bonds/patch_forces.hpp"

namespace pliant::point_based {

namespace {

constexpr std::size_t most_parts = 16;
constexpr double few = 1e-6;  // relative to the largest eigenvalue of a block

/// The components a <= b of v v^T, those off the diagonal times `off_diagonal`. With 2, their
/// product with the pairs of u is (u . v)^2.
template <int D>
Eigen::Matrix<double, D*(D + 1) / 2, 1> pairs_of(const Eigen::Matrix<double, D, 1>& v,
                                                 double off_diagonal = 1) {
  Eigen::Matrix<double, D*(D + 1) / 2, 1> pairs;
  for (int a = 0, k = 0; a < D; ++a) {
    for (int b = a; b < D; ++b) pairs[k++] = (a == b ? 1 : off_diagonal) * v[a] * v[b];
  }
  return pairs;
}

template <int D>
Eigen::Matrix<double, D, D> symmetric(const Eigen::Matrix<double, D*(D + 1) / 2, 1>& pairs) {
  Eigen::Matrix<double, D, D> matrix;
  for (int a = 0, k = 0; a < D; ++a) {
    for (int b = a; b < D; ++b) matrix(a, b) = matrix(b, a) = pairs[k++];
  }
  return matrix;
}

}  // namespace

template <int D>
PatchForces<D>::PatchForces(const WeightedNodes<D>& nodes, scheduler::Workers& workers)
    : nodes_(nodes),
      workers_(workers),
      force_(nodes.positions.size()),
      block_(nodes.positions.size()) {
  make_bonds();
  make_parts();
  evaluate();
}

template <int D>
void PatchForces<D>::make_bonds() {
  first_.assign(1, 0);
  for (std::size_t i = 0; i < nodes(); ++i) {
    for (const std::int32_t j : nodes_.neighbour[i]) {
      Bond& bond = bonds_.emplace_back();
      bond.node = j;
      for (int a = 0; a < D; ++a) bond.x[a] = nodes_.positions[j][a] - nodes_.positions[i][a];
    }
    first_.push_back(static_cast<std::int64_t>(bonds_.size()));
  }
}

template <int D>
void PatchForces<D>::make_parts() {
  for (std::size_t p = 0; p < most_parts; ++p) {
    const std::size_t first = p * nodes() / most_parts, end = (p + 1) * nodes() / most_parts;
    if (first == end) continue;
    Part& part = parts_.emplace_back(Part{first, end, first, end, {}, {}});
    for (std::int64_t k = first_[first]; k < first_[end]; ++k) {
      const auto node = static_cast<std::size_t>(bonds_[k].node);
      part.lowest = std::min(part.lowest, node);
      part.beyond = std::max(part.beyond, node + 1);
    }
    part.force.resize(part.beyond - part.lowest);
    part.block.resize(part.beyond - part.lowest);
  }
}

/// Calls f(i, part) for every node, in parallel over parts, whose forces are 0 before.
template <int D>
template <class F>
void PatchForces<D>::for_each_part(F&& f) {
  workers_.for_each(static_cast<int>(parts_.size()), [&](int p) {
    Part& part = parts_[static_cast<std::size_t>(p)];
    std::ranges::fill(part.force, Vector::Zero());
    for (std::size_t i = part.first; i < part.end; ++i) f(i, part);
  });
}

/// The projection onto the directions in which no wall bears the force on node i.
template <int D>
auto PatchForces<D>::free(std::size_t i) const -> Matrix {
  if (nodes_.free.empty()) return Matrix::Identity();
  return Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(nodes_.free[i].data());
}

template <int D>
auto PatchForces<D>::unborne(std::size_t i, const Vector& force) const -> Vector {
  return nodes_.free.empty() ? force : free(i) * force;
}

template <int D>
auto PatchForces<D>::inverse_block(std::size_t i, const Matrix& block) const -> Matrix {
  const Matrix unit = Matrix::Identity(), along = free(i);
  if (along.isZero()) return Matrix::Zero();
  // The bonds of its neighbours alone may reach a node in one direction only.
  const bool has_bonds = first_[i] < first_[i + 1];
  const Matrix full = has_bonds ? block : Matrix(block + few * block.trace() * unit);
  if (nodes_.free.empty()) return full.inverse();
  return along * (along * full * along + full.trace() * (unit - along)).inverse() * along;
}

template <int D>
void PatchForces<D>::evaluate() {
  for (Part& part : parts_) std::ranges::fill(part.block, Pairs::Zero());
  for_each_part([this](std::size_t i, Part& part) {
    find_gradient(i);
    add_forces(i, part);
    add_blocks(i, part);
  });
  for_each_node([this](std::size_t i) {
    force_[i] = total_force(i) - Eigen::Map<const Vector>(nodes_.areas[i].data());
    Pairs block = Pairs::Zero();
    for (const Part& part : parts_) {
      if (part.lowest <= i && i < part.beyond) block += part.block[i - part.lowest];
    }
    block_[i] = symmetric<D>(block);
  });
}

template <int D>
auto PatchForces<D>::total_force(std::size_t i) const -> Vector {
  Vector sum = Vector::Zero();
  for (const Part& part : parts_) {
    if (part.lowest <= i && i < part.beyond) sum += part.force[i - part.lowest];
  }
  return sum;
}

template <int D>
void PatchForces<D>::find_gradient(std::size_t i) {
  Matrix moment = Matrix::Zero();
  for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
    moment += nodes_.weight[i][k - first_[i]] * bonds_[k].x * bonds_[k].x.transpose();
  }
  const Matrix inverse = moment.inverse();
  for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
    bonds_[k].u = inverse * bonds_[k].x;
    bonds_[k].weight = nodes_.volumes[i] * nodes_.weight[i][k - first_[i]];
  }
}

template <int D>
void PatchForces<D>::add_forces(std::size_t i, Part& part) const {
  for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
    const Vector force = bonds_[k].weight * bonds_[k].u;
    part.force[bonds_[k].node - part.lowest] += force;
    part.force[i - part.lowest] -= force;
  }
}

/// Adds to the diagonal blocks, sums over bonds b of (dr/dc_b)(dr/dc_b)^T. A change of c of bond b
/// of node i moves r at the end of its bond k by (delta_kb - w_k u_b . x_k) V w_b u_b, and r of
/// node i by the opposite of the sum.
template <int D>
void PatchForces<D>::add_blocks(std::size_t i, Part& part) const {
  Eigen::Matrix<double, pairs, pairs> moments = Eigen::Matrix<double, pairs, pairs>::Zero();
  Vector sum = Vector::Zero();  // of w X
  for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
    const Bond& bond = bonds_[k];
    moments += pairs_of<D>(bond.weight * bond.u) * pairs_of<D>(bond.u).transpose();
    sum += bond.weight / nodes_.volumes[i] * bond.x;
  }
  Pairs own = moments * pairs_of<D>(sum, 2);
  for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
    const Bond& bond = bonds_[k];
    const double weight = bond.weight / nodes_.volumes[i];
    const Pairs square = pairs_of<D>(bond.weight * bond.u);
    own += (1 - 2 * bond.u.dot(sum)) * square;
    part.block[bond.node - part.lowest] += weight * weight * moments * pairs_of<D>(bond.x, 2) +
                                           (1 - 2 * weight * bond.u.dot(bond.x)) * square;
  }
  part.block[i - part.lowest] += own;
}

/// Adds the forces of the bonds of node i that the change J^T y causes.
template <int D>
void PatchForces<D>::add_forces_of_change(std::size_t i, const Vectors& y, Part& part) const {
  Matrix turned = Matrix::Zero();
  Vector own = Vector::Zero();
  find_changes(i, y, [&](std::int64_t k, double change) {
    const Bond& bond = bonds_[k];
    const Vector force = change * bond.weight * bond.u;
    turned += force * bond.u.transpose();
    part.force[bond.node - part.lowest] += force;
    own -= force;
  });
  turned /= nodes_.volumes[i];
  for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
    const Vector force = bonds_[k].weight * (turned * bonds_[k].x);
    part.force[bonds_[k].node - part.lowest] -= force;
    own += force;
  }
  part.force[i - part.lowest] += own;
}

template <int D>
double PatchForces<D>::apply(const Vectors& y, double added, Vectors& result) {
  for_each_part([&](std::size_t i, Part& part) { add_forces_of_change(i, y, part); });
  return sum_over_nodes([&](std::size_t i) {
    result[i] = unborne(i, total_force(i) + added * y[i]);
    return y[i].dot(result[i]);
  });
}

template class PatchForces<2>;
template class PatchForces<3>;

}  // namespace pliant::point_based
