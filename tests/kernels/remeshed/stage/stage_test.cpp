#include <cmath>

#include "tests/kernels/reference_stage.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

constexpr Kernel every_kernel[] = {Kernel::quartic_spline, Kernel::quartic_spline_fit,
                                   Kernel::compact, Kernel::fourth_order};

template <class T>
class stage : public testing::Test {};
TYPED_TEST_SUITE(stage, Dimensions);

template <class T, int D>
const Segment<D>& segment_of(const Patch<T, D>& patch, std::int64_t slot) {
  for (const Segment<D>& segment : patch.segments) {
    if (slot >= segment.first && slot < segment.first + segment.count) return segment;
  }
  return patch.segments.front();
}

/// Largest difference between the first stage of the kernel and the reference, relative to the
/// scale of each rate.
template <class T, int D>
double worst_rate_error(Body<T, D>& body, const NeighbourLists<D>* lists) {
  const T dt = T(1e-2);
  Stage<T, D> arguments = body.stage(0, 0, 1, dt);
  arguments.neighbours = lists;
  const State<T, D> start = body.states[0];
  baseline_table<T, D>().advance_stage(arguments);
  double worst = 0;
  const auto compare = [&](double next, double before, double rate, double scale) {
    worst = std::max(worst, std::abs((next - before) / (dt / 2) - rate) / scale);
  };
  const bool deformation = carries_deformation(body.material.model);
  body.patch.for_each_interior([&](std::int64_t p, const auto&) {
    const Rates<D> rates = reference_rates(body, start, segment_of(body.patch, p), p);
    const State<T, D>& next = body.states[1];
    for (int i = 0; i < D; ++i) {
      compare(next.drift[i][p], start.drift[i][p], rates.drift[i], 1);
      compare(next.velocity[i][p], start.velocity[i][p], rates.velocity[i], 10);
      for (int j = deformation ? 0 : i; j < D; ++j) {
        const int c = deformation ? i * D + j : symmetric_index<D>(i, j);
        compare(next.material[c][p], start.material[c][p], rates.material(i, j), 100);
      }
    }
    compare(next.volume[p], start.volume[p], rates.volume, start.volume[p]);
  });
  return worst;
}

/// Rounding of the sums, amplified by the division of a difference by dt/2.
template <class T>
constexpr double rate_tolerance = 1e5 * std::numeric_limits<T>::epsilon();

TYPED_TEST(stage, rates_agree_with_the_equations_written_with_matrices) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Model model : every_model) {
    Body<T, D> body(small_box<T, D>(), T(0.1), model);
    for (const Kernel kernel : every_kernel) {
      body.kernel = kernel;
      for (const auto& [of_velocity, of_stress] :
           {std::pair(T(0), T(0)), std::pair(T(0.7), T(0)), std::pair(T(0), T(0.3)),
            std::pair(T(0.7), T(0.3))}) {
        body.velocity_dissipation = of_velocity;
        body.stress_dissipation = of_stress;
        for (const bool relaxes_shear : {true, false}) {
          body.relaxes_shear = relaxes_shear;
          EXPECT_LT((worst_rate_error<T, D>(body, nullptr)), rate_tolerance<T>);
        }
      }
    }
  }
}

TYPED_TEST(stage, rates_by_the_gradient_of_the_paper_agree_with_its_sums) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Model model : every_model) {
    Body<T, D> body(small_box<T, D>(), T(0.1), model);
    body.kernel = Kernel::quartic_spline;
    body.gradient_kind = Gradient::normalised;
    EXPECT_LT((worst_rate_error<T, D>(body, nullptr)), rate_tolerance<T>);
    const BoxLists<D> lists(body.patch, stencil_reach(body.kernel));
    const NeighbourLists<D> view = lists.view();
    EXPECT_LT((worst_rate_error<T, D>(body, &view)), rate_tolerance<T>);
  }
}

TYPED_TEST(stage, lists_give_what_the_stencil_gives) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Body<T, D> body(small_box<T, D>(), T(0.1), Model::linear);
  // With lists the quartic replaces Kernel::fourth_order.
  for (const Kernel kernel :
       {Kernel::quartic_spline, Kernel::quartic_spline_fit, Kernel::compact}) {
    body.kernel = kernel;
    const BoxLists<D> lists(body.patch, stencil_reach(kernel));
    const NeighbourLists<D> view = lists.view();
    EXPECT_LT((worst_rate_error<T, D>(body, &view)), rate_tolerance<T>);
  }
}

TYPED_TEST(stage, stress_is_that_of_the_new_state) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Model model : every_model) {
    Body<T, D> body(small_box<T, D>(), T(0.1), model);
    body.step(baseline_table<T, D>(), T(1e-3));
    double worst = 0;
    body.patch.for_each_interior([&](std::int64_t p, const auto&) {
      const Matrix<D> expected = reference_stress(body, body.states[0], p);
      const Matrix<D> stress = symmetric_at<T, D>(body.states[0].stress.data(), p);
      worst = std::max(worst, (stress - expected).norm());
    });
    // Moduli of order 100, relative rounding of J and rho of a few units.
    EXPECT_LT(worst, 1000 * std::numeric_limits<T>::epsilon());
  }
}

TYPED_TEST(stage, uniform_motion_changes_nothing_but_positions) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Model model : every_model) {
    Body<T, D> body(small_box<T, D>(), T(0.1), model);
    State<T, D>& state = body.states[0];
    const auto level = [&](auto& fields) {
      for (auto& field : fields) std::fill(field.begin(), field.end(), field[100]);
    };
    level(state.drift);
    level(state.velocity);
    level(state.material);
    std::fill(state.volume.begin(), state.volume.end(), state.volume[100]);
    const State<T, D> start = state;
    const StageResult result = body.step(baseline_table<T, D>(), T(1e-3));
    EXPECT_EQ(result.strain_rate, 0);
    EXPECT_EQ(body.states[0].velocity, start.velocity);
    EXPECT_EQ(body.states[0].volume, start.volume);
    EXPECT_EQ(body.states[0].material, start.material);
  }
}

TYPED_TEST(stage, particles_that_are_not_interior_only_move_along) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Body<T, D> body(small_box<T, D>(), T(0.1), Model::reduced_polynomial);
  const State<T, D> start = body.states[0];
  const T dt = T(1e-3);
  body.step(baseline_table<T, D>(), dt);
  body.patch.for_each([&](std::int64_t p, const auto&) {
    if (body.patch.interior[p] != 0) return;
    const State<T, D>& next = body.states[0];
    EXPECT_EQ(next.volume[p], start.volume[p]);
    for (int i = 0; i < D; ++i) {
      EXPECT_EQ(next.velocity[i][p], start.velocity[i][p]);
      EXPECT_NEAR(next.drift[i][p], start.drift[i][p] + dt * start.velocity[i][p],
                  4 * std::numeric_limits<T>::epsilon());
    }
    for (int c = 0; c < material_components<D>; ++c) {
      EXPECT_EQ(next.material[c][p], start.material[c][p]);
    }
  });
}

// (RP.21) with all four velocities, for particles and for ghosts, whose velocities are not updated.
TYPED_TEST(stage, places_follow_the_velocities_of_all_stages) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Body<T, D> body(small_box<T, D>(), T(0.1), Model::linear);
  const T dt = T(1e-3);
  const std::array<T, 4> share = {dt / 2, dt / 2, dt, 0};
  const std::array<T, 4> weight = {dt / 6, dt / 3, dt / 3, dt / 6};
  const std::array<Field<T>, D> start = body.states[0].drift;
  std::array<Field<T>, D> end = start;
  // Places and displacements are of order 1 or smaller.
  const double tolerance = 16 * std::numeric_limits<T>::epsilon();
  for (int number = 0; number < 4; ++number) {
    std::array<Field<T>, D>& u = body.states[number].velocity;
    body.patch.for_each([&](std::int64_t p, const auto&) {
      for (int i = 0; i < D; ++i) {
        if (body.patch.interior[p] == 0) u[i][p] = T(number * number - 0.3 * i) + T(p % 7);
        end[i][p] += weight[number] * u[i][p];
      }
    });
    const std::array<Field<T>, D> present = u;
    baseline_table<T, D>().advance_stage(body.stage(number, number, (number + 1) % 4, dt));
    const std::array<Field<T>, D>& place = body.states[(number + 1) % 2].drift;
    body.patch.for_each([&](std::int64_t p, const auto&) {
      for (int i = 0; i < D; ++i) {
        const T right = number == 3 ? end[i][p] : start[i][p] + share[number] * present[i][p];
        EXPECT_NEAR(place[i][p], right, tolerance);
      }
    });
  }
}

TYPED_TEST(stage, vacant_and_padding_slots_stay_finite) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Model model : every_model) {
    Body<T, D> body(small_box<T, D>(), T(0.1), model);
    State<T, D>& state = body.states[0];
    body.patch.for_each([&](std::int64_t p, const auto& cell) {
      // Beyond one layer of ghosts all slots are vacant, and one ghost is in an impossible state.
      if (body.patch.interior[p] != 0 || cell[0] == 2) return;
      for (int i = 0; i < D; ++i) state.drift[i][p] = state.velocity[i][p] = 0;
      const bool ghost = cell[0] == 1;
      for (int c = 0; c < material_components<D>; ++c) state.material[c][p] = ghost ? T(-1) : T(0);
    });
    for (int n = 1; n < 4; ++n) body.states[n] = state;
    EXPECT_EQ(body.step(baseline_table<T, D>(), T(1e-3)).non_finite, -1);
    for (const State<T, D>& q : body.states) {
      const auto expect_finite = [](const auto& fields) {
        for (const auto& field : fields) {
          for (const T value : field) ASSERT_TRUE(std::isfinite(value));
        }
      };
      expect_finite(q.drift);
      expect_finite(q.velocity);
      expect_finite(q.material);
      expect_finite(q.stress);
      expect_finite(std::array{q.volume});
    }
  }
}

TYPED_TEST(stage, result_holds_the_extremes_of_interior_particles) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Body<T, D> body(small_box<T, D>(), T(0.1), Model::linear);
  // Outside the body everything is faster and lighter, and must be ignored.
  body.patch.for_each([&](std::int64_t p, const auto&) {
    if (body.patch.interior[p] == 0) body.mass[p] /= 10;
  });
  const StageResult result = body.step(baseline_table<T, D>(), T(1e-3));
  double strain_rate = 0, wave_speed2 = 0;
  const Material<T>& m = body.material;
  body.patch.for_each_interior([&](std::int64_t p, const auto&) {
    const auto rates = reference_rates(body, body.states[3], segment_of(body.patch, p), p);
    strain_rate = std::max(strain_rate, rates.strain_rate);
    const double density = body.mass[p] / body.states[0].volume[p];
    wave_speed2 =
        std::max(wave_speed2, m.bulk_modulus / m.density + 4 * m.shear_modulus / (3 * density));
  });
  EXPECT_NEAR(result.strain_rate / strain_rate, 1, exact<T>);
  EXPECT_NEAR(result.wave_speed / std::sqrt(wave_speed2), 1, exact<T>);
  EXPECT_EQ(result.non_finite, -1);
}

// A rotation by 0.3 and a stretch by a tenth: differences are exact, even where a particle has a
// neighbour on one side only.
TYPED_TEST(stage, the_deformation_of_a_linear_drift_is_its_gradient) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Body<T, D> body(small_box<T, D>(), T(0.1), Model::linear);
  Matrix<D> gradient = Matrix<D>::Zero();
  gradient(0, 0) = std::cos(0.3) * 1.1 - 1;
  gradient(0, 1) = -std::sin(0.3);
  gradient(1, 0) = std::sin(0.3);
  gradient(1, 1) = std::cos(0.3) - 1;
  body.patch.for_each([&](std::int64_t p, const auto& cell) {
    for (int i = 0; i < D; ++i) {
      double drift = body.patch.interior[p] != 0 ? 0 : 1e3;
      for (int j = 0; j < D; ++j) drift += gradient(i, j) * body.patch.spacing * cell[j];
      body.states[0].drift[i][p] = static_cast<T>(drift);
    }
  });
  const double found = baseline_table<T, D>().lattice_gradient(
      {body.patch.segments.data(), static_cast<int>(body.patch.segments.size()), body.patch.spacing,
       body.patch.pack_state.data(), body.patch.interior.data(),
       std::as_const(body.states[0]).evolving().drift});
  EXPECT_NEAR(found / gradient.norm(), 1, 1e3 * std::numeric_limits<T>::epsilon());
}

TYPED_TEST(stage, first_impossible_particle_is_named) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  std::array<std::int32_t, D> cell;
  cell.fill(5);
  const T nan = std::numeric_limits<T>::quiet_NaN();
  for (const bool negative_volume : {false, true}) {
    Body<T, D> body(small_box<T, D>(), T(0.1), Model::linear_logarithmic);
    const std::int64_t slot = body.patch.slot(cell);
    if (negative_volume) {
      for (State<T, D>& q : body.states) q.volume[slot] = -q.volume[slot];
    } else {
      for (State<T, D>& q : body.states) q.material[0][slot] = nan;
    }
    const auto result = baseline_table<T, D>().advance_stage(body.stage(3, 3, 0, T(1e-3)));
    EXPECT_EQ(result.non_finite, slot);
  }
}

}  // namespace
}  // namespace pliant::kernels::test
