#include "bench/kernels/measure.hpp"
#include "tests/kernels/body.hpp"

namespace pliant::kernels::bench {
namespace {

/// Scatters all interior particles of a body to one buffer of nodes.
void scatter(benchmark::State& state, Isa isa) {
  const auto cells = box<2>(state.range(0));
  test::Body<double, 2> body(cells, 0.01, Model::linear);
  std::int64_t particles = 0;
  body.patch.for_each_interior([&](std::int64_t, const auto&) { ++particles; });
  test::Field<double> nodes(std::size_t(cells[0] + 6) * (cells[1] + 6) * node_width<2>, 0.);
  const std::array<std::int32_t, 2> extent = {cells[0] + 6, cells[1] + 6};
  const std::vector<NodeRow> rows = test::whole_rows<2>(extent);
  const auto& current = std::as_const(body.states[0]);
  const Scatter<double, 2> arguments{body.patch.segments.data(),
                                     static_cast<int>(body.patch.segments.size()),
                                     body.patch.kind.data(),
                                     100,
                                     {},
                                     3,
                                     body.mass.data(),
                                     body.mass.data(),
                                     {body.mass.data(), body.mass.data()},
                                     current.evolving(),
                                     nodes.data(),
                                     rows.data(),
                                     {-3, -3},
                                     extent};
  for (auto _ : state) RemeshedTable<double, 2>::of(isa).scatter(arguments);
  report(state, particles, {16 * (1 + 2 * 16) + 40, 12 * 8 + 1 + 2 * 128});
}

/// Filters one field.
void filter(benchmark::State& state, Isa isa) {
  test::Body<double, 2> body(box<2>(state.range(0)), 0.01, Model::linear);
  std::int64_t particles = 0;
  body.patch.for_each_interior([&](std::int64_t, const auto&) { ++particles; });
  const test::Field<double> inside(body.patch.interior.begin(), body.patch.interior.end());
  test::Field<double> filtered(body.patch.slots);
  const Filter<double, 2> arguments{body.patch.segments.data(),
                                    static_cast<int>(body.patch.segments.size()),
                                    0.2,
                                    inside.data(),
                                    body.mass.data(),
                                    filtered.data()};
  for (auto _ : state) RemeshedTable<double, 2>::of(isa).filter(arguments);
  report(state, particles, {27, 32});
}

const bool registered = [] {
  register_sizes("scatter", scatter);
  register_sizes("filter", filter);
  return true;
}();

}  // namespace
}  // namespace pliant::kernels::bench
