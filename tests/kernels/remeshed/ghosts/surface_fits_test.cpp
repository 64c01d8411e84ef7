#include "kernels/remeshed/ghosts/fit_coefficients.hpp"
#include "tests/kernels/half_space_of_particles.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class surface_fits : public testing::Test {};
TYPED_TEST_SUITE(surface_fits, Dimensions);

using Fit = FitCoefficients<double>;

template <class T, int D, class F>
double sum(const HalfSpaceOfParticles<T, D>& space, double Fit::*fit, int lane, const F& f) {
  const FitTerms<double, D> terms = space.terms(lane);
  double total = 0;
  for (int k = 0; k < space.length; ++k) {
    const double distance = space.distance[k * space.pack + lane];
    const std::array<double, D> x = space.place(k, lane);
    double r[D];
    for (int a = 0; a < D; ++a) r[a] = x[a];
    total += fit_coefficients(terms, r, distance).*fit * f(x, distance);
  }
  return total;
}

TYPED_TEST(surface_fits, linear_fields_are_exact_at_the_ghost_and_at_its_foot) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  HalfSpaceOfParticles<T, D> space;
  baseline_table<T, D>().fit_surface(space.arguments());
  const auto f = [](const std::array<double, D>& x, double) { return 3 + 2 * x[0] - x[D - 1]; };
  for (int l = 0; l < space.pack; ++l) {
    ASSERT_EQ(space.fitted[l], 1);
    const double at_ghost = 3 + 2 * space.ghost[0][l] - space.ghost[D - 1][l];
    EXPECT_NEAR(sum(space, &Fit::linear, l, f), at_ghost, 10 * exact<T>);
    EXPECT_NEAR(sum(space, &Fit::surface, l, f), 3, 10 * exact<T>);
  }
}

TYPED_TEST(surface_fits, what_vanishes_on_the_surface_is_exact_to_the_order_that_is_wanted) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  HalfSpaceOfParticles<T, D> space;
  baseline_table<T, D>().fit_surface(space.arguments());
  for (int l = 0; l < space.pack; ++l) {
    const double curvature = space.curved[l] != 0 ? 0.5 : 0;
    // d (2 + t.x + curvature d), t = e_x - n_x n
    const auto f = [&](const std::array<double, D>& x, double d) {
      double n_x = 0;
      for (int a = 0; a < D; ++a) n_x += space.normal[a][l] * x[a];
      return d * (2 + x[0] - n_x * space.normal[0][l] + curvature * d);
    };
    std::array<double, D> ghost;
    for (int a = 0; a < D; ++a) ghost[a] = space.ghost[a][l];
    EXPECT_NEAR(sum(space, &Fit::constrained, l, f), f(ghost, space.ghost_distance[l]),
                10 * exact<T>);
    const auto one = [](const std::array<double, D>&, double) { return 1.; };
    EXPECT_NEAR(space.constrained_sum[l], sum(space, &Fit::constrained, l, one), 10 * exact<T>);
  }
}

TYPED_TEST(surface_fits, a_share_of_the_last_term_is_a_mean_of_the_fits_with_and_without_it) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  const auto cube = [](const std::array<double, D>&, double d) { return d * d * d; };
  std::array<std::vector<double>, 3> found;
  for (const int share : {0, 1, 2}) {
    HalfSpaceOfParticles<T, D> space;
    for (T& curved : space.curved) curved = T(share) / 2;
    baseline_table<T, D>().fit_surface(space.arguments());
    for (int l = 0; l < space.pack; ++l) {
      ASSERT_EQ(space.fitted[l], 1);
      found[share].push_back(sum(space, &Fit::constrained, l, cube));
    }
  }
  for (std::size_t l = 0; l < found[0].size(); ++l) {
    EXPECT_NEAR(found[1][l], (found[0][l] + found[2][l]) / 2, 10 * exact<T>);
    EXPECT_GT(std::abs(found[0][l] - found[2][l]), 0.1);
  }
}

TYPED_TEST(surface_fits, particles_out_of_reach_count_nothing_and_too_few_are_told) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  HalfSpaceOfParticles<T, D> space;
  const int lane = 1;
  for (int k = D; k < space.length; ++k) {
    for (int a = 0; a < D; ++a) space.position[a][k * space.pack + lane] = T(2 * space.radius);
  }
  baseline_table<T, D>().fit_surface(space.arguments());
  for (int l = 0; l < space.pack; ++l) EXPECT_EQ(space.fitted[l], l == lane ? 0 : 1);
}

}  // namespace
}  // namespace pliant::kernels::test
