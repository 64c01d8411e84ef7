#include <cmath>
#include <numbers>

#include "tests/kernels/reference_stage.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

double kernel(double s) {
  const auto fourth = [](double x) { return x > 0 ? x * x * x * x : 0; };
  return (fourth(2.5 - s) - 5 * fourth(1.5 - s) + 10 * fourth(0.5 - s)) / 24;
}

/// A body of plain SPH with random sigma/rho^2 and R.
template <class T, int D>
struct SphBody : Body<T, D> {
  std::array<Field<T>, symmetric_components<D>> scaled, artificial;
  SymmetricPairs<T, D> pairs{};

  SphBody() : Body<T, D>(small_box<T, D>(), T(0.1), Model::linear) {
    for (int c = 0; c < symmetric_components<D>; ++c) {
      scaled[c].assign(this->patch.slots, 0);
      artificial[c].assign(this->patch.slots, 0);
    }
    jitter(scaled, T(10), 11);
    jitter(artificial, T(3), 12);
    for (int c = 0; c < symmetric_components<D>; ++c) {
      pairs.stress[c] = scaled[c].data();
      pairs.artificial[c] = artificial[c].data();
    }
    pairs.linear = T(8);
    pairs.quadratic = T(2);
  }

  Column<D> place(std::int64_t p, const std::array<std::int32_t, D>& cell) const {
    const auto node = this->patch.node(cell);
    Column<D> x = vector_at<T, D>(this->states[0].drift, p);
    for (int i = 0; i < D; ++i) x[i] += node[i];
    return x;
  }

  /// (RP.25) and (RP.26) to (RP.27) over the cube of slots within three cells.
  void sum(std::int64_t p, const std::array<std::int32_t, D>& cell, Matrix<D>& gradient,
           Column<D>& acceleration) const {
    const State<T, D>& state = this->states[0];
    const double h = this->patch.spacing;
    const double n = D == 2 ? 2304 / (1199 * std::numbers::pi) : 6 / (5 * std::numbers::pi);
    gradient.setZero();
    acceleration.setZero();
    for (int k = 0; k < power(7, D); ++k) {
      auto other = cell;
      for (int i = 0, rest = k; i < D; ++i, rest /= 7) other[i] += rest % 7 - 3;
      const std::int64_t q = this->patch.slot(other);
      if (q == p) continue;
      const Column<D> r = place(p, cell) - place(q, other);
      const Column<D> u = vector_at<T, D>(state.velocity, p) - vector_at<T, D>(state.velocity, q);
      const double s = r.norm() / h;
      const Column<D> slope =
          -n / std::pow(h, D + 2) * reference_weight(Kernel::quartic_spline, s) * r;
      const double rho_p = this->mass[p] / state.volume[p], rho_q = this->mass[q] / state.volume[q];
      const double mu = h * u.dot(r) / (r.squaredNorm() + 0.01 * h * h);
      const double viscous =
          mu < 0 ? (-double(pairs.linear) * mu + double(pairs.quadratic) * mu * mu) /
                       (0.5 * (rho_p + rho_q))
                 : 0;
      const auto at = [](const auto& fields, std::int64_t slot) {
        return symmetric_at<T, D>(fields.data(), slot);
      };
      const Matrix<D> stress =
          at(scaled, p) + at(scaled, q) - viscous * Matrix<D>::Identity() +
          std::pow(kernel(s) / kernel(1), 4) * (at(artificial, p) + at(artificial, q));
      gradient -= state.volume[q] * u * slope.transpose();
      acceleration += this->mass[q] * stress * slope;
    }
  }
};

template <class T>
class symmetric_pairs : public testing::Test {};
TYPED_TEST_SUITE(symmetric_pairs, Dimensions);

TYPED_TEST(symmetric_pairs, rates_agree_with_the_equations_written_with_matrices) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  SphBody<T, D> body;
  const State<T, D> start = body.states[0];
  const BoxLists<D> lists(body.patch, 3);
  const NeighbourLists<D> view = lists.view();
  const T dt = T(1e-2);
  Stage<T, D> stage = body.stage(0, 0, 1, dt);
  stage.neighbours = &view;
  stage.pairs = &body.pairs;
  double largest = 0, worst_velocity = 0, worst_volume = 0;
  body.patch.for_each_interior([&](std::int64_t p, const auto& cell) {
    Matrix<D> gradient;
    Column<D> acceleration;
    body.sum(p, cell, gradient, acceleration);
    largest = std::max(largest, acceleration.norm());
  });
  baseline_table<T, D>().advance_stage(stage);
  const State<T, D> next = body.states[1];
  body.states[0] = start;
  body.patch.for_each_interior([&](std::int64_t p, const auto& cell) {
    Matrix<D> gradient;
    Column<D> acceleration;
    body.sum(p, cell, gradient, acceleration);
    for (int i = 0; i < D; ++i) {
      const double rate = (double(next.velocity[i][p]) - start.velocity[i][p]) / (dt / 2);
      worst_velocity = std::max(worst_velocity, std::abs(rate - acceleration[i]));
    }
    const double rate = (double(next.volume[p]) / start.volume[p] - 1) / (dt / 2);
    worst_volume = std::max(worst_volume, std::abs(rate - gradient.trace()));
  });
  // Rounding of the sums, amplified by the division of a difference by dt/2.
  const double rounding = 1e5 * std::numeric_limits<T>::epsilon();
  EXPECT_GT(largest, 100);
  EXPECT_LT(worst_velocity, rounding * largest);
  EXPECT_LT(worst_volume, rounding * 10);
}

}  // namespace
}  // namespace pliant::kernels::test
