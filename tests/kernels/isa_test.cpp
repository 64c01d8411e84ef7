#include "kernels/isa.hpp"

#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

#include "kernels/total_lagrangian/table.hpp"
#include "tests/kernels/body.hpp"
#include "tests/kernels/half_space_of_particles.hpp"
#include "tests/kernels/nodes_of_a_ball.hpp"
#include "tests/kernels/random_ghosts.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
using Values = std::vector<T>;

constexpr Isa every_isa[] = {Isa::sse2, Isa::avx2, Isa::avx512};

template <class T, std::size_t N>
void append(Values<T>& values, const std::array<Field<T>, N>& fields) {
  for (const auto& field : fields) values.insert(values.end(), field.begin(), field.end());
}

/// All results of two steps, the first with lists.
template <class T, int D>
Values<T> steps(const RemeshedTable<T, D>& kernels, Model model, Kernel kernel) {
  Body<T, D> body(small_box<T, D>(), T(0.1), model);
  body.kernel = kernel;
  const BoxLists<D> lists(body.patch, stencil_reach(kernel));
  const NeighbourLists<D> view = lists.view();
  Values<T> values;
  for (const NeighbourLists<D>* neighbours :
       {&view, static_cast<const NeighbourLists<D>*>(nullptr)}) {
    body.neighbours = neighbours;
    const StageResult result = body.step(kernels, T(1e-3));
    values.push_back(static_cast<T>(result.strain_rate));
    values.push_back(static_cast<T>(result.deformation));
    values.push_back(static_cast<T>(result.wave_speed));
  }
  for (const auto& state : body.states) {
    append(values, state.drift);
    append(values, state.velocity);
    append(values, std::array{state.volume});
    append(values, state.material);
    append(values, state.stress);
  }
  return values;
}

/// Surface records of the particles of a row, and ghost sums.
template <class T, int D>
Values<T> surface(const RemeshedTable<T, D>& kernels, Model model, Kernel) {
  Body<T, D> body(small_box<T, D>(), T(0.1), model);
  const auto& segments = body.patch.segments;
  constexpr int pack = slots_per_pack, chosen = 5;
  std::vector<SurfacePack> packs;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const std::int64_t first = segments[s].first + pack;
    if (body.patch.pack_state[first / pack] != PackState::all) continue;
    packs.push_back({first, static_cast<std::int32_t>(s),
                     static_cast<std::int32_t>(chosen * packs.size()), 0b10110011});
  }
  const auto& state = std::as_const(body.states[0]);
  Values<T> records(packs.size() * chosen * record_width<D>);
  kernels.write_surface_records({segments.data(), packs.data(), static_cast<int>(packs.size()),
                                 body.patch.spacing, body.material, body.mass.data(),
                                 state.drift[0].data(), body.patch.interior.data(),
                                 state.evolving(), state.stress_fields(), records.data()});
  const RandomGhosts<T, D> ghosts;
  Values<T> sums(ghosts.ghosts * 3 * record_width<D>);
  kernels.sum_ghosts(ghosts.sums(0, ghosts.ghosts, sums.data()));
  records.insert(records.end(), sums.begin(), sums.end());
  return records;
}

template <class T, int D>
Values<T> remeshing(const RemeshedTable<T, D>& kernels, Model model, Kernel) {
  Body<T, D> body(small_box<T, D>(), T(0.1), model);
  const auto& state = std::as_const(body.states[0]);
  const int segment_count = static_cast<int>(body.patch.segments.size());
  Scatter<T, D> arguments{body.patch.segments.data(),
                          segment_count,
                          body.patch.kind.data(),
                          10,
                          {},
                          material_component_count<D>(model),
                          body.mass.data(),
                          state.volume.data(),
                          state.evolving().velocity,
                          state.evolving(),
                          nullptr,
                          nullptr,
                          {},
                          small_box<T, D>()};
  const std::vector<NodeRow> rows = whole_rows<D>(small_box<T, D>());
  arguments.rows = rows.data();
  std::size_t size = node_width<D>;
  for (const int n : small_box<T, D>()) size *= n;
  Values<T> nodes(size), filtered(body.patch.slots);
  arguments.nodes = nodes.data();
  kernels.scatter(arguments);
  const Field<T> inside(body.patch.interior.begin(), body.patch.interior.end());
  kernels.filter({body.patch.segments.data(), segment_count, T(0.2), inside.data(),
                  state.velocity[0].data(), filtered.data()});
  nodes.insert(nodes.end(), filtered.begin(), filtered.end());
  return nodes;
}

/// Closest points, and the fits of ghosts.
template <class T, int D>
Values<T> free_surface(const RemeshedTable<T, D>& kernels, Model, Kernel) {
  NodesOfABall<T, D> ball(6.3);
  kernels.find_closest_points(ball.arguments());
  Values<T> values(ball.converged.begin(), ball.converged.begin() + ball.count);
  for (Field<T>& coordinate : ball.point)
    coordinate.resize(ball.count);  // the rest fills up a pack
  append(values, ball.point);
  HalfSpaceOfParticles<T, D> space;
  kernels.fit_surface(space.arguments());
  append(values, space.linear);
  append(values, space.surface);
  append(values, space.constrained);
  append(values, std::array{space.fitted, space.constrained_sum});
  return values;
}

/// Calls `compare(compute)` for every function, law and kernel; `compute(isa)` returns the values.
template <class T, int D, class Compare>
void for_each_combination(const Compare& compare) {
  for (const auto& function : {steps<T, D>, surface<T, D>, remeshing<T, D>, free_surface<T, D>}) {
    for (const Model model : every_model) {
      for (const Kernel kernel : {Kernel::quartic_spline, Kernel::quartic_spline_fit,
                                  Kernel::compact, Kernel::fourth_order}) {
        compare([&](Isa isa) { return function(RemeshedTable<T, D>::of(isa), model, kernel); });
      }
    }
  }
}

template <class T>
class isa : public testing::Test {};
TYPED_TEST_SUITE(isa, Dimensions);

TYPED_TEST(isa, every_one_agrees_with_the_baseline_within_rounding) {
  using T = typename TypeParam::Scalar;
  for (const Isa wide : every_isa) {
    if (!is_supported(wide)) continue;
    for_each_combination<T, TypeParam::dimension>([&](const auto& compute) {
      const auto baseline = compute(Isa::sse2), values = compute(wide);
      ASSERT_EQ(values.size(), baseline.size());
      double worst = 0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double scale = 1 + std::abs(double(baseline[i]));
        worst = std::max(worst, std::abs(double(values[i]) - double(baseline[i])) / scale);
      }
      // Velocity gradients of 10/s and moduli of 100 amplify the rounding of a few units.
      EXPECT_LT(worst, exact<T>) << name(wide);
    });
  }
}

TYPED_TEST(isa, avx2_and_avx512_agree_to_the_bit) {
  using T = typename TypeParam::Scalar;
  if (!is_supported(Isa::avx512)) GTEST_SKIP() << "this processor has no AVX-512";
  for_each_combination<T, TypeParam::dimension>([](const auto& compute) {
    const auto narrow = compute(Isa::avx2), wide = compute(Isa::avx512);
    ASSERT_EQ(narrow.size(), wide.size());
    EXPECT_EQ(std::memcmp(narrow.data(), wide.data(), narrow.size() * sizeof(T)), 0);
  });
}

TYPED_TEST(isa, no_two_share_a_kernel) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Isa wide : {Isa::avx2, Isa::avx512}) {
    EXPECT_NE((RemeshedTable<T, D>::of(wide).advance_stage),
              (baseline_table<T, D>().advance_stage));
    EXPECT_NE((TotalLagrangianTable<T, D>::of(wide).advance_motion),
              (TotalLagrangianTable<T, D>::of(Isa::sse2).advance_motion));
  }
  // In single precision AVX2 is the widest.
  EXPECT_EQ(
      (RemeshedTable<T, D>::of(Isa::avx2).scatter == RemeshedTable<T, D>::of(Isa::avx512).scatter),
      (std::is_same_v<T, float>));
}

TEST(dispatch, the_processor_runs_the_baseline_and_what_it_names_as_widest) {
  EXPECT_TRUE(is_supported(Isa::sse2));
  EXPECT_TRUE(is_supported(widest_supported()));
  EXPECT_EQ(name(Isa::avx512), "avx512");
}

}  // namespace
}  // namespace pliant::kernels::test
