#include <random>

#include "bench/kernels/measure.hpp"
#include "tests/kernels/field.hpp"

namespace pliant::kernels::bench {
namespace {

/// Ghosts with 20 particles each, taken from a stretch of records that moves along with them.
void sum(benchmark::State& state, Isa isa) {
  constexpr int particles = 20, width = record_width<2>;
  const std::int64_t ghosts = state.range(0);
  std::mt19937 random(1);
  std::vector<std::int64_t> begin(ghosts + 1);
  std::vector<std::int32_t> record(ghosts * particles);
  test::Field<double> coefficient(ghosts * particles, 0.05);
  for (std::int64_t g = 0; g <= ghosts; ++g) begin[g] = g * particles;
  for (std::int64_t i = 0; i < ghosts * particles; ++i) {
    record[i] = static_cast<std::int32_t>(i / particles + random() % 100);
  }
  test::Field<double> records((ghosts + 100) * width, 1.), sums(ghosts * 3 * width);
  const GhostSums<double, 2> arguments{0,
                                       ghosts,
                                       begin.data(),
                                       record.data(),
                                       coefficient.data(),
                                       coefficient.data(),
                                       coefficient.data(),
                                       records.data(),
                                       sums.data()};
  for (auto _ : state) table<double, 2>(isa).sum_ghosts(arguments);
  report(state, ghosts, {particles * width * 6, 20 * 28 + 64 + 4 * 64});
}

const bool registered = [] {
  register_sizes("sum_ghosts", sum);
  return true;
}();

}  // namespace
}  // namespace pliant::kernels::bench
