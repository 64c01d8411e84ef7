#include "kernels/remeshed/ghosts/ghost_state.hpp"
#include "tests/kernels/body.hpp"
#include "tests/kernels/tables.hpp"

// Normals of surface particles follow from the deformation around them, (RP.61).
namespace pliant::kernels::test {
namespace {

template <class T>
class slopes : public testing::Test {};
TYPED_TEST_SUITE(slopes, Dimensions);

/// A particle among others, whose surface record is written.
template <class T, int D>
struct SurfaceParticle {
  SurfaceParticle() : body(small_box<T, D>(), T(0.1), Model::linear) {
    cell.fill(5);
    cell[0] = 13;
    for (auto& field : state().drift) std::fill(field.begin(), field.end(), T(0));
    for (auto& field : state().velocity) std::fill(field.begin(), field.end(), T(0));
    level_set.assign(body.patch.slots, 0);
  }

  State<T, D>& state() { return body.states[0]; }

  /// Sets a slot field to a function of the lattice distance from the particle.
  template <class U, class F>
  void set(Field<U>& field, F&& value) {
    const auto origin = body.patch.node(cell);
    body.patch.for_each([&](std::int64_t p, const auto& other) {
      auto x = body.patch.node(other);
      for (int i = 0; i < D; ++i) x[i] -= origin[i];
      field[p] = static_cast<U>(value(x));
    });
  }

  /// Gradient of phi at the particle, `lead` ahead.
  std::array<T, D> gradient(double lead = 0) {
    const std::int64_t slot = body.patch.slot(cell);
    SurfacePack pack{slot / body.patch.pack * body.patch.pack, 0, 0, 0};
    for (std::size_t s = 0; s < body.patch.segments.size(); ++s) {
      const Segment<D>& segment = body.patch.segments[s];
      if (segment.first <= slot && slot < segment.first + segment.count) {
        pack.segment = static_cast<std::int32_t>(s);
        pack.first = segment.first + (slot - segment.first) / body.patch.pack * body.patch.pack;
      }
    }
    pack.lanes = static_cast<std::uint16_t>(1u << (slot - pack.first));
    SurfaceRecords<T, D> work = {body.patch.segments.data(),
                                 &pack,
                                 1,
                                 body.patch.spacing,
                                 body.material,
                                 body.mass.data(),
                                 level_set.data(),
                                 body.patch.interior.data(),
                                 std::as_const(state()).evolving(),
                                 std::as_const(state()).stress_fields(),
                                 record.data()};
    work.renews_slopes = renews;
    work.lead = static_cast<T>(lead);
    baseline_table<T, D>().write_surface_records(work);
    std::array<T, D> result;
    for (int i = 0; i < D; ++i) result[i] = RecordSum<T, D>{record.data()}.level_set_gradient(i);
    return result;
  }

  Body<T, D> body;
  std::array<std::int32_t, D> cell;
  Field<T> level_set, record = Field<T>(record_width<D>, T(0));
  bool renews = true;
};

/// Displacement gradient of a shear with rotation and stretch.
constexpr double deformation[3][3] = {{0.1, -0.3, 0.05}, {0.2, -0.15, 0.1}, {-0.1, 0.25, 0.2}};
/// Gradient of phi in the deformed body.
constexpr double gradient_after[3] = {1, -2, 3};

template <class X>
double displacement(int i, const X& x) {
  double sum = 0;
  for (std::size_t j = 0; j < x.size(); ++j) sum += deformation[i][j] * x[j];
  return sum;
}

/// phi of a particle as a function of its original place.
template <class X>
double level_set_of(const X& x) {
  double phi = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    phi += gradient_after[i] * (x[i] + displacement(static_cast<int>(i), x));
  }
  return phi;
}

TYPED_TEST(slopes, follow_linear_deformations_exactly) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  SurfaceParticle<T, D> particle;
  particle.set(particle.level_set, [](const auto& x) { return level_set_of(x); });
  for (int i = 0; i < D; ++i) {
    particle.set(particle.state().drift[i], [i](const auto& x) { return displacement(i, x); });
  }
  const auto gradient = particle.gradient();
  for (int i = 0; i < D; ++i) EXPECT_NEAR(gradient[i], gradient_after[i], 20 * exact<T>);
}

TYPED_TEST(slopes, are_taken_ahead_with_the_velocity) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  SurfaceParticle<T, D> particle;
  particle.set(particle.level_set, [](const auto& x) { return level_set_of(x); });
  for (int i = 0; i < D; ++i) {
    particle.set(particle.state().velocity[i],
                 [i](const auto& x) { return 7 + 4 * displacement(i, x); });
  }
  const auto gradient = particle.gradient(0.25);
  for (int i = 0; i < D; ++i) EXPECT_NEAR(gradient[i], gradient_after[i], 20 * exact<T>);
}

// One in four particles is displaced to each side, as far as (RP.20) hardly sees; differences of
// neighbours would turn the normal by up to 1.
TYPED_TEST(slopes, hardly_see_wiggles) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  SurfaceParticle<T, D> particle;
  const double h = particle.body.patch.spacing;
  particle.set(particle.level_set, [](const auto& x) { return x[1]; });
  particle.set(particle.state().drift[1],
               [h](const auto& x) { return 0.1 * h * std::sin(std::acos(0.) * x[0] / h); });
  EXPECT_LT(std::abs(particle.gradient()[0]), 0.3 * 0.1);
}

TYPED_TEST(slopes, of_a_line_of_particles_turn_with_it) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  SurfaceParticle<T, D> particle;
  const double h = particle.body.patch.spacing;
  particle.set(particle.level_set, [](const auto& x) { return x[1]; });
  particle.set(particle.body.patch.interior, [h](const auto& x) {
    double beside = 0;
    for (int i = 1; i < D; ++i) beside += std::abs(x[i]);
    return beside < 0.5 * h ? 1 : 0;
  });
  particle.set(particle.state().drift[0], [](const auto& x) { return -0.2 * x[0]; });
  particle.set(particle.state().drift[1], [](const auto& x) { return 0.6 * x[0]; });
  const auto gradient = particle.gradient();
  EXPECT_NEAR(gradient[0] / gradient[1], -0.6 / 0.8, 1e-2);
}

TYPED_TEST(slopes, are_kept_until_they_are_renewed) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  SurfaceParticle<T, D> particle;
  particle.set(particle.level_set, [](const auto& x) { return x[0]; });
  const auto before = particle.gradient();
  particle.set(particle.level_set, [](const auto& x) { return x[1]; });
  particle.renews = false;
  EXPECT_EQ(particle.gradient(), before);
  particle.renews = true;
  EXPECT_NE(particle.gradient(), before);
}

}  // namespace
}  // namespace pliant::kernels::test
