#include <algorithm>
#include <cmath>

#include "kernels/total_lagrangian/table.hpp"
#include "tests/kernels/patch.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

constexpr double bulk_modulus = 40, kept = 0.9, gained = 0.02, time_step = 0.01;

/// A block of rubber: cells are filled where their lowest corner is an interior slot of the patch.
template <class T, int D>
struct Block {
  Block() : patch(cells(), T(0.125)), fraction(patch.slots), inverse_mass(patch.slots) {
    material.model = Model::reduced_polynomial;
    material.order = 1;
    material.coefficient = {T(10)};
    material.compressibility = T(2 / bulk_modulus);
    for (auto* fields : {&displacement, &velocity, &internal, &traction}) {
      for (Field<T>& field : *fields) field.assign(patch.slots, T(0));
    }
    for (auto& modes : force) {
      for (Field<T>& mode : modes) mode.assign(patch.slots, T(0));
    }
    patch.for_each_interior([&](std::int64_t p, const auto&) {
      fraction[p] = 1;
      inverse_mass[p] = 2;
    });
  }

  static std::array<int, D> cells() {
    std::array<int, D> n;
    n.fill(12);
    n[0] = 3 * slots_per_pack;
    return n;
  }

  /// d = (F - I) x
  void deform() {
    patch.for_each([&](std::int64_t p, const std::array<std::int32_t, D>& cell) {
      for (int i = 0; i < D; ++i) {
        double d = 0;
        for (int j = 0; j < D; ++j) d += slope[i][j] * cell[j] * patch.spacing;
        displacement[i][p] = static_cast<T>(d);
        largest = std::max(largest, std::abs(d));
      }
    });
  }

  MotionResult step(Isa isa) {
    const auto& table = TotalLagrangianTable<T, D>::of(isa);
    StressPoints<T, D> stress{};
    Motion<T, D> motion{};
    stress.segments = motion.segments = patch.segments.data();
    stress.segment_count = motion.segment_count = static_cast<int>(patch.segments.size());
    stress.spacing = patch.spacing;
    stress.hourglass = T(0.8);
    stress.examine = true;
    stress.material = material;
    stress.fraction = fraction.data();
    motion.kept = T(kept);
    motion.gained = T(gained);
    motion.time_step = T(time_step);
    motion.inverse_mass = inverse_mass.data();
    for (int i = 0; i < D; ++i) {
      stress.displacement[i] = motion.displacement[i] = displacement[i].data();
      motion.velocity[i] = velocity[i].data();
      motion.internal[i] = internal[i].data();
      motion.traction[i] = traction[i].data();
      for (int m = 0; m < cell_modes<D>; ++m) {
        stress.force[i][m] = force[i][m].data();
        motion.force[i][m] = force[i][m].data();
      }
    }
    result = table.evaluate_stress_points(stress);
    return table.advance_motion(motion);
  }

  static constexpr double slope[3][3] = {{0.2, 0.1, -0.05}, {-0.1, 0.1, 0.05}, {0.05, -0.1, 0.1}};
  Patch<T, D> patch;
  Material<T> material;
  Field<T> fraction, inverse_mass;
  std::array<Field<T>, D> displacement, velocity, internal, traction;
  std::array<std::array<Field<T>, cell_modes<D>>, D> force;
  double largest = 0;  ///< component of the displacement
  StressPointsResult result{};
};

/// What rounding displacements to units makes of the force on a particle: strains off by so many
/// units of d/h, times the modulus and the area of a cell.
template <class T, int D>
double rounding(const Block<T, D>& block) {
  const double h = block.patch.spacing;
  return 32 * std::numeric_limits<T>::epsilon() * block.largest / h * bulk_modulus *
         std::pow(h, D - 1);
}

template <class T>
class total_lagrangian_kernels : public testing::Test {};
TYPED_TEST_SUITE(total_lagrangian_kernels, Dimensions);

TYPED_TEST(total_lagrangian_kernels, a_homogeneous_deformation_pulls_on_faces_only) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Block<T, D> block;
  block.deform();
  block.step(Isa::sse2);
  EXPECT_EQ(block.result.non_finite, -1);
  double outside = 0;
  block.patch.for_each_interior([&](std::int64_t p, const std::array<std::int32_t, D>& cell) {
    bool inside = true;
    for (int i = 0; i < D; ++i) inside = inside && cell[i] > Patch<T, D>::margin;
    for (int i = 0; i < D; ++i) {
      if (inside) {
        EXPECT_NEAR(block.internal[i][p], 0, rounding(block));
      } else {
        outside = std::max(outside, std::abs(double(block.internal[i][p])));
      }
    }
  });
  EXPECT_GT(outside, 100 * rounding(block)) << "there is no stress at all";
}

TYPED_TEST(total_lagrangian_kernels, force_and_traction_move_a_particle) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Block<T, D> block;
  jitter(block.displacement, T(0.01), 4);
  jitter(block.velocity, T(1), 5);
  jitter(block.traction, T(1), 6);
  const Block<T, D> before = block;
  block.step(Isa::sse2);
  const double tolerance = 8 * std::numeric_limits<T>::epsilon();
  block.patch.for_each_interior([&](std::int64_t p, const auto&) {
    for (int i = 0; i < D; ++i) {
      const double force = double(block.internal[i][p]) + double(before.traction[i][p]);
      const double u = kept * double(before.velocity[i][p]) + gained * 2 * force;
      EXPECT_NEAR(block.velocity[i][p], u, tolerance);
      EXPECT_NEAR(block.displacement[i][p], before.displacement[i][p] + time_step * u, tolerance);
    }
  });
}

TYPED_TEST(total_lagrangian_kernels, instruction_sets_agree_with_the_baseline_within_rounding) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Block<T, D> baseline;
  jitter(baseline.displacement, T(0.01), 4);
  jitter(baseline.velocity, T(1), 5);
  for (const Isa isa : {Isa::avx2, Isa::avx512}) {
    if (!is_supported(isa)) continue;
    Block<T, D> wide = baseline, narrow = baseline;
    wide.step(isa);
    narrow.step(Isa::sse2);
    EXPECT_NEAR(wide.result.wave_speed / narrow.result.wave_speed, 1, exact<T>);
    // A wide register may reach beyond a segment into slots that belong to nobody.
    baseline.patch.for_each_interior([&](std::int64_t p, const auto&) {
      for (int i = 0; i < D; ++i) {
        EXPECT_NEAR(wide.velocity[i][p], narrow.velocity[i][p], exact<T>) << name(isa);
        EXPECT_NEAR(wide.displacement[i][p], narrow.displacement[i][p], exact<T>) << name(isa);
      }
    });
  }
}

}  // namespace
}  // namespace pliant::kernels::test
