#include <cmath>

#include "tests/kernels/reference_stage.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class state_stress : public testing::Test {};
TYPED_TEST_SUITE(state_stress, Dimensions);

TYPED_TEST(state_stress, follows_the_law_in_every_slot) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Model model : every_model) {
    Body<T, D> body(small_box<T, D>(), T(0.1), model);
    const StageResult result = baseline_table<T, D>().evaluate_stress(body.stress_of(0));
    EXPECT_GT(result.wave_speed, 0);
    EXPECT_EQ(result.non_finite, -1);
    double worst = 0;
    body.patch.for_each([&](std::int64_t p, const auto&) {
      const Matrix<D> stress = symmetric_at<T, D>(body.states[0].stress.data(), p);
      worst = std::max(worst, (stress - reference_stress(body, body.states[0], p)).norm());
    });
    // Moduli of order 100, relative rounding of J and rho of a few units.
    EXPECT_LT(worst, 1000 * std::numeric_limits<T>::epsilon());
  }
}

TYPED_TEST(state_stress, wave_speed_is_the_largest_of_interior_particles) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Body<T, D> body(small_box<T, D>(), T(0.1), Model::linear_logarithmic);
  double largest2 = 0;
  body.patch.for_each([&](std::int64_t p, const auto&) {
    if (body.patch.interior[p] == 0) body.mass[p] /= 10;
    const double modulus = body.material.bulk_modulus + 4 * body.material.shear_modulus / 3;
    const double c2 = modulus * body.states[0].volume[p] / body.mass[p];
    if (body.patch.interior[p] != 0) largest2 = std::max(largest2, c2);
  });
  const StageResult result = baseline_table<T, D>().evaluate_stress(body.stress_of(0));
  EXPECT_NEAR(result.wave_speed / std::sqrt(largest2), 1, exact<T>);
}

}  // namespace
}  // namespace pliant::kernels::test
