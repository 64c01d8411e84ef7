#include "kernels/remeshed/ghosts/ghost_state.hpp"
#include "tests/kernels/random_ghosts.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class free_surface_ghosts : public testing::Test {};
TYPED_TEST_SUITE(free_surface_ghosts, Dimensions);

/// Ghosts in slots numbered from the last one backwards: every fifth is a wall ghost, every seventh
/// is inactive, every third is under a pressure.
template <class T, int D>
struct FilledGhosts : RandomGhosts<T, D> {
  using Base = RandomGhosts<T, D>;
  static constexpr int components = symmetric_components<D>;

  FilledGhosts() {
    for (int g = 0; g < Base::ghosts; ++g) {
      slot.push_back(Base::ghosts - 1 - g);
      wall.push_back(static_cast<std::int8_t>(g % 5 == 0 ? 0 : -1));
      active.push_back(g % 7 != 0);
      pressure.push_back(static_cast<std::int8_t>(g % 3 == 0 ? 1 : -1));
      constrained_sum.push_back(T(0.01) * g);
      surface_sum.push_back(T(1) - T(0.02) * g);
    }
    for (auto& field : velocity) field.assign(Base::ghosts, T(-7));
    for (auto& field : stress) field.assign(Base::ghosts, T(-7));
    correction.assign(Base::ghosts * D, T(-7));
  }

  void fill(const RemeshedTable<T, D>& kernels) {
    FreeSurfaceGhosts<T, D> work = {};
    work.lists = this->sums(0, Base::ghosts, nullptr);
    work.constrained_sum = constrained_sum.data();
    work.surface_sum = surface_sum.data();
    work.slot = slot.data();
    work.wall = wall.data();
    work.active = active.data();
    work.pressure = pressure.data();
    work.pressures = pressures;
    work.pressure_impedance = impedance.pressure_wave;
    work.shear_impedance = impedance.shear_wave;
    for (int a = 0; a < D; ++a) work.velocity[a] = velocity[a].data();
    for (int c = 0; c < components; ++c) work.stress[c] = stress[c].data();
    work.correction = correction.data();
    kernels.fill_free_surfaces(work);
  }

  /// Computes one ghost by itself.
  GhostState<T, D> state(int ghost, const T* sums) const {
    constexpr int stride = Base::width;
    const T p = pressure[ghost] < 0 ? T(0) : static_cast<T>(pressures[pressure[ghost]]);
    return free_surface_ghost<T, D>(
        {{sums}, {sums + stride}, {sums + 2 * stride}, constrained_sum[ghost], surface_sum[ghost]},
        p, impedance);
  }

  const double pressures[2] = {3, 0.7};
  const Impedance<T> impedance{T(2), T(1.3)};
  std::vector<std::int32_t> slot;
  std::vector<std::int8_t> wall, pressure;
  std::vector<std::uint8_t> active;
  Field<T> constrained_sum, surface_sum, correction;
  std::array<Field<T>, D> velocity;
  std::array<Field<T>, components> stress;
};

TYPED_TEST(free_surface_ghosts, are_as_one_by_one_but_for_walls_and_the_inactive) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension, width = record_width<D>;
  FilledGhosts<T, D> filled;
  filled.fill(baseline_table<T, D>());
  Field<T> sums(filled.ghosts * 3 * width);
  baseline_table<T, D>().sum_ghosts(filled.sums(0, filled.ghosts, sums.data()));
  for (int g = 0; g < filled.ghosts; ++g) {
    const std::int32_t slot = filled.slot[g];
    const bool is_free = filled.wall[g] < 0 && filled.active[g] != 0;
    const GhostState<T, D> expected = filled.state(g, &sums[g * 3 * width]);
    const RecordSum<T, D> linear{&sums[g * 3 * width]};
    for (int a = 0; a < D; ++a) {
      EXPECT_NEAR(filled.correction[g * D + a],
                  is_free ? expected.velocity[a] - linear.velocity(a) : T(-7), exact<T>);
      EXPECT_NEAR(filled.velocity[a][slot], is_free ? expected.velocity[a] : T(-7), exact<T>);
    }
    for (int c = 0; c < symmetric_components<D>; ++c) {
      EXPECT_NEAR(filled.stress[c][slot], is_free ? expected.stress[c] : T(-7), exact<T>);
    }
  }
}

}  // namespace
}  // namespace pliant::kernels::test
