#include <cmath>

#include "kernels/remeshed/ghosts/ghost_state.hpp"
#include "tests/kernels/reference_stage.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class surface_records : public testing::Test {};
TYPED_TEST_SUITE(surface_records, Dimensions);

/// Packs of every third interior particle.
template <class T, int D>
std::vector<SurfacePack> every_third_particle(const Patch<T, D>& patch,
                                              std::vector<std::int64_t>& slots) {
  std::vector<SurfacePack> packs;
  for (std::size_t s = 0; s < patch.segments.size(); ++s) {
    const Segment<D>& segment = patch.segments[s];
    for (std::int64_t first = segment.first; first < segment.first + segment.count;
         first += patch.pack) {
      SurfacePack pack{first, static_cast<std::int32_t>(s), static_cast<std::int32_t>(slots.size()),
                       0};
      for (int l = 0; l < patch.pack; ++l) {
        if (patch.interior[first + l] == 0 || (first + l) % 3 != 0) continue;
        pack.lanes = static_cast<std::uint16_t>(pack.lanes | 1u << l);
        slots.push_back(first + l);
      }
      if (pack.lanes != 0) packs.push_back(pack);
    }
  }
  return packs;
}

/// The records of these particles, for a level set that was the first coordinate at the remeshing.
template <class T, int D>
Field<T> records_of(const Body<T, D>& body, const std::vector<SurfacePack>& packs,
                    std::size_t count) {
  Field<T> level_set(body.patch.slots, 0), records(count * record_width<D>, T(-7));
  body.patch.for_each([&](std::int64_t p, const auto& cell) {
    level_set[p] = static_cast<T>(body.patch.node(cell)[0]);
  });
  const State<T, D>& state = body.states[0];
  baseline_table<T, D>().write_surface_records(
      {body.patch.segments.data(), packs.data(), static_cast<int>(packs.size()), body.patch.spacing,
       body.material, body.mass.data(), level_set.data(), body.patch.interior.data(),
       state.evolving(), state.stress_fields(), records.data()});
  return records;
}

TYPED_TEST(surface_records, hold_velocity_stress_and_pressure) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const Model model : every_model) {
    Body<T, D> body(small_box<T, D>(), T(0.1), model);
    const State<T, D>& state = body.states[0];
    std::vector<std::int64_t> slots;
    const auto packs = every_third_particle(body.patch, slots);
    constexpr int width = record_width<D>;
    const Field<T> records = records_of(body, packs, slots.size());
    for (std::size_t r = 0; r < slots.size(); ++r) {
      const T* record = records.data() + r * width;
      const RecordSum<T, D> view{record};
      for (int i = 0; i < D; ++i) {
        EXPECT_EQ(view.velocity(i), state.velocity[i][slots[r]]);
        for (int j = i; j < D; ++j) {
          EXPECT_EQ(view.stress(i, j), state.stress[symmetric_index<D>(i, j)][slots[r]]);
        }
      }
      double pressure = 0;
      if (carries_deformation(model)) {
        pressure = -reference_cauchy_stress(body, state, slots[r]).trace() / 3;
      } else {
        const Matrix<D> stress = reference_stress(body, state, slots[r]);
        pressure = state.material[0][slots[r]] - stress(0, 0);  // p = S_xx - sigma_xx
      }
      EXPECT_NEAR(view.pressure(), pressure, 1000 * std::numeric_limits<T>::epsilon());
      using Place = RecordPlace<D>;
      for (int f = Place::pressure + 1; f < Place::velocity; ++f) EXPECT_EQ(record[f], 0);
      for (int f = Place::slope + D; f < width; ++f) EXPECT_EQ(record[f], 0);
    }
  }
}

}  // namespace
}  // namespace pliant::kernels::test
