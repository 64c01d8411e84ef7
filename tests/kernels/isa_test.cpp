#include "kernels/isa.hpp"

#include <cmath>
#include <cstring>
#include <functional>

#include "tests/kernels/body.hpp"
#include "tests/kernels/dimension.hpp"

namespace pliant::kernels::test {
namespace {

using Values = std::vector<double>;

constexpr Isa every_isa[] = {Isa::sse2, Isa::avx2, Isa::avx512};

void append(Values& values, const State<double, 2>& state) {
  for (const auto* fields : {&state.displacement, &state.velocity}) {
    for (const auto& field : *fields) values.insert(values.end(), field.begin(), field.end());
  }
  values.insert(values.end(), state.volume.begin(), state.volume.end());
  for (const auto& field : state.material) values.insert(values.end(), field.begin(), field.end());
  for (const auto& field : state.stress) values.insert(values.end(), field.begin(), field.end());
}

/// All that two steps compute.
Values steps(const Table<double, 2>& kernels, Model model, Weight weight) {
  Body<double, 2> body({64, 20}, 0.1, model);
  body.weight = weight;
  Values values;
  for (int n = 0; n < 2; ++n) {
    const StageResult result = body.step(kernels, 1e-3);
    values.insert(values.end(), {result.strain_rate, result.wave_speed});
  }
  for (const auto& state : body.states) append(values, state);
  return values;
}

/// Surface records of a row's particles, and ghost sums over them.
Values surface(const Table<double, 2>& kernels, Model model, Weight weight) {
  Body<double, 2> body({64, 20}, 0.1, model);
  std::vector<SurfacePack> packs;
  const Segment<2>& segment = body.patch.segments[8];
  for (int i = 8, record = 0; i + 16 < segment.count; i += 8, record += 5) {
    packs.push_back({segment.first + i, 8, record, 0b10110011});
  }
  Values records(packs.size() * 5 * record_width<2>), sums(4 * 2 * record_width<2>);
  const auto& state = std::as_const(body.states[0]);
  kernels.write_surface_records({body.patch.segments.data(), packs.data(),
                                 static_cast<int>(packs.size()), body.patch.spacing, weight,
                                 body.material, body.mass.data(), state.displacement[0].data(),
                                 state.evolving(), state.stress_fields(), records.data()});
  const std::vector<std::int64_t> begin = {0, 3, 10, 11, 20};
  std::vector<std::int32_t> record;
  for (int i = 0; i < 20; ++i) record.push_back(7 * i % 20);
  kernels.sum_ghosts({0, 4, begin.data(), record.data(), body.mass.data() + 1,
                      state.volume.data() + 3, records.data(), sums.data()});
  records.insert(records.end(), sums.begin(), sums.end());
  return records;
}

Values remeshing(const Table<double, 2>& kernels, Model model, Weight) {
  Body<double, 2> body({64, 20}, 0.1, model);
  const auto& state = std::as_const(body.states[0]);
  Values nodes(80 * 30 * node_width<2>), filtered(body.patch.slots);
  kernels.scatter({body.patch.segments.data(),
                   static_cast<int>(body.patch.segments.size()),
                   body.patch.kind.data(),
                   10,
                   {},
                   carried_components<2>(model),
                   body.mass.data(),
                   state.volume.data(),
                   {state.velocity[0].data(), state.velocity[1].data()},
                   state.evolving(),
                   nodes.data(),
                   {-3, -3},
                   {80, 30}});
  kernels.filter({body.patch.segments.data(), static_cast<int>(body.patch.segments.size()), 0.2,
                  body.patch.interior.data(), state.velocity[0].data(), filtered.data()});
  nodes.insert(nodes.end(), filtered.begin(), filtered.end());
  return nodes;
}

using Computation = std::function<Values(const Table<double, 2>&, Model, Weight)>;

template <class Compare>
void for_each_combination(const Compare& compare) {
  for (const Computation& compute :
       {Computation(steps), Computation(surface), Computation(remeshing)}) {
    for (const Model model : {Model::linear_rho, Model::linear_log, Model::reduced_polynomial}) {
      for (const Weight weight : {Weight::quartic, Weight::quartic_polynomial, Weight::compact}) {
        compare([&](Isa isa) { return compute(table<double, 2>(isa), model, weight); });
      }
    }
  }
}

TEST(isa, every_one_agrees_with_the_baseline_within_rounding) {
  for (const Isa isa : every_isa) {
    if (!is_supported(isa)) continue;
    for_each_combination([&](const auto& compute) {
      const Values baseline = compute(Isa::sse2), values = compute(isa);
      ASSERT_EQ(values.size(), baseline.size());
      double worst = 0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        worst = std::max(worst, std::abs(values[i] - baseline[i]) / (1 + std::abs(baseline[i])));
      }
      // Velocity gradients of 10/s and moduli of 100 enlarge the rounding of a few units.
      EXPECT_LT(worst, 1e-12) << name(isa);
    });
  }
}

TEST(isa, avx2_and_avx512_agree_to_the_bit) {
  if (!is_supported(Isa::avx512)) GTEST_SKIP() << "this processor has no AVX-512";
  for_each_combination([](const auto& compute) {
    const Values narrow = compute(Isa::avx2), wide = compute(Isa::avx512);
    ASSERT_EQ(narrow.size(), wide.size());
    EXPECT_EQ(std::memcmp(narrow.data(), wide.data(), narrow.size() * sizeof(double)), 0);
  });
}

TEST(isa, tables_are_those_asked_for) {
  for (const Isa isa : every_isa) {
    EXPECT_EQ((table<double, 2>(isa).isa), isa);
    EXPECT_EQ((table<double, 2>(isa).lanes), isa == Isa::sse2 ? 2 : isa == Isa::avx2 ? 4 : 8);
  }
  EXPECT_TRUE(is_supported(Isa::sse2));
  EXPECT_TRUE(is_supported(widest_supported()));
  EXPECT_EQ(name(Isa::avx512), "avx512");
}

}  // namespace
}  // namespace pliant::kernels::test
