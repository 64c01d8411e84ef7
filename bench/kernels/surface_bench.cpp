#include "bench/kernels/measure.hpp"
#include "tests/kernels/body.hpp"

namespace pliant::kernels::bench {
namespace {

/// Records of three in every eight particles of a pack, as along a surface with slope 1/2.
void write_records(benchmark::State& state, Isa isa) {
  test::Body<double, 2> body(box<2>(state.range(0)), 0.01, Model::linear);
  std::vector<SurfacePack> packs;
  for (std::size_t s = 0; s < body.patch.segments.size(); ++s) {
    const Segment<2>& segment = body.patch.segments[s];
    for (std::int64_t p = segment.first; p < segment.first + segment.count; p += 8) {
      if (body.patch.pack_state[p / 8] != PackState::all) continue;
      packs.push_back(
          {p, static_cast<std::int32_t>(s), static_cast<std::int32_t>(3 * packs.size()), 0b111000});
    }
  }
  test::Field<double> records(3 * packs.size() * record_width<2>);
  const auto& current = std::as_const(body.states[0]);
  const SurfaceRecords<double, 2> arguments{body.patch.segments.data(),
                                            packs.data(),
                                            static_cast<int>(packs.size()),
                                            body.patch.spacing,
                                            body.material,
                                            body.mass.data(),
                                            body.mass.data(),
                                            body.patch.interior.data(),
                                            current.evolving(),
                                            current.stress_fields(),
                                            records.data()};
  for (auto _ : state) RemeshedTable<double, 2>::of(isa).write_surface_records(arguments);
  // Whole packs are computed: 8/3 gradients of one field for each record.
  report(state, static_cast<std::int64_t>(3 * packs.size()), {8. / 3 * 30, 8. / 3 * 200 + 128});
}

const bool registered = [] {
  register_sizes("write_surface_records", write_records);
  return true;
}();

}  // namespace
}  // namespace pliant::kernels::bench
