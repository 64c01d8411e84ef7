#include "engine/point_based/bonds/patch_test.hpp"

#include <algorithm>
#include <cmath>

namespace pliant::point_based {

namespace {

constexpr int most_halvings = 4;
constexpr double longest_step = 1;  // of ln c
// Longer steps are those of bonds that hardly act on any force.
constexpr double far_too_long = 4;

}  // namespace

template <int D>
PatchTest<D>::PatchTest(WeightedNodes<D>& nodes, scheduler::Workers& workers, double most_change,
                        double regularisation)
    : nodes_(nodes),
      forces_(nodes, workers),
      most_change_(std::log(most_change)),
      regularisation_(regularisation),
      changes_(forces_.bonds()) {}

template <int D>
double PatchTest<D>::worst() const {
  double most = 0;
  for (std::size_t i = 0; i < forces_.nodes(); ++i) {
    const double area = std::pow(nodes_.volumes[i], (D - 1.) / D);
    most = std::max(most, forces_.unborne(i, forces_.force(i)).norm() / area);
  }
  return most;
}

/// Sum of the squared forces that no wall bears.
template <int D>
double PatchTest<D>::square() const {
  return forces_.sum_over_nodes(
      [this](std::size_t i) { return forces_.unborne(i, forces_.force(i)).squaredNorm(); });
}

template <int D>
bool PatchTest<D>::improve(double tolerance, int most_iterations) {
  const double before = square();
  double share = std::min(1., longest_step / find_step(tolerance, most_iterations));
  for (int halving = 0; halving <= most_halvings; ++halving, share /= 2) {
    move(share);
    if (square() < before) return true;
  }
  move(0);
  return false;
}

template <int D>
double PatchTest<D>::mean_of_diagonal() const {
  const double sum =
      forces_.sum_over_nodes([this](std::size_t i) { return forces_.block(i).trace(); });
  return sum / (D * static_cast<double>(forces_.nodes()));
}

/// Sets the changes of a step, and returns the longest one.
template <int D>
double PatchTest<D>::find_step(double tolerance, int most_iterations) {
  const auto longest = [this] {
    double most = 0;
    for (const Change& change : changes_) most = std::max(most, std::abs(change.step));
    return most;
  };
  if (steps_until_trial_ == 0) {
    find_change(tolerance, most_iterations, 0);
    if (regularisation_ == 0 || longest() <= far_too_long) return longest();
    pause_ = 2 * pause_ + 1;
    steps_until_trial_ = pause_;
  }
  --steps_until_trial_;
  find_change(tolerance, most_iterations, regularisation_ * mean_of_diagonal());
  return longest();
}

/// Sets the changes of a step with `added` on the diagonal of J J^T.
template <int D>
void PatchTest<D>::find_change(double tolerance, int most_iterations, double added) {
  const Vectors y = solve(tolerance, most_iterations, added);
  forces_.for_each_node([&](std::size_t i) {
    forces_.find_changes(i, y, [this](std::int64_t bond, double step) {
      changes_[bond].step = step;
      changes_[bond].start = changes_[bond].log;
    });
  });
}

/// Moves the weights from the start of a step by a share of the change.
template <int D>
void PatchTest<D>::move(double share) {
  forces_.for_each_node([&](std::size_t i) {
    auto change = changes_.begin() + forces_.first_bond(i);
    for (double& weight : nodes_.weight[i]) {
      const double log =
          std::clamp(change->start + share * change->step, -most_change_, most_change_);
      weight *= std::exp(log - change->log);
      change->log = log;
      ++change;
    }
  });
  forces_.evaluate();
}

/// Solves (J J^T + added I) y = -r by conjugate gradients; y = 0 where walls bear any force.
template <int D>
auto PatchTest<D>::solve(double tolerance, int most_iterations, double added) -> Vectors {
  using Matrix = typename PatchForces<D>::Matrix;
  const std::size_t nodes = forces_.nodes();
  Vectors y(nodes, PatchForces<D>::Vector::Zero()), rest(nodes), scaled(nodes), way(nodes),
      image(nodes);
  std::vector<Matrix> inverse(nodes);
  const auto scale = [&](std::size_t i) {
    scaled[i] = inverse[i] * rest[i];
    return scaled[i].dot(rest[i]);
  };
  double product = forces_.sum_over_nodes([&](std::size_t i) {
    inverse[i] = forces_.inverse_block(i, forces_.block(i) + added * Matrix::Identity());
    rest[i] = forces_.unborne(i, -forces_.force(i));
    return scale(i);
  });
  way = scaled;
  const double enough = tolerance * tolerance * product;
  for (int k = 0; k < most_iterations && product > enough; ++k) {
    const double curvature = forces_.apply(way, added, image);
    if (!(curvature > 0)) break;
    const double length = product / curvature, before = product;
    product = forces_.sum_over_nodes([&](std::size_t i) {
      y[i] += length * way[i];
      rest[i] -= length * image[i];
      return scale(i);
    });
    forces_.for_each_node([&](std::size_t i) { way[i] = scaled[i] + product / before * way[i]; });
  }
  return y;
}

template class PatchTest<2>;
template class PatchTest<3>;

}  // namespace pliant::point_based
