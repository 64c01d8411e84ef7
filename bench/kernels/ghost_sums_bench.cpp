#include <random>

#include "bench/kernels/measure.hpp"
#include "tests/kernels/field.hpp"

namespace pliant::kernels::bench {
namespace {

/// Ghosts with 20 particles each, from a range of records that moves along with the ghosts.
void sum(benchmark::State& state, Isa isa) {
  constexpr int particles = 20, width = record_width<2>;
  const std::int64_t ghosts = state.range(0);
  std::mt19937 random(1);
  std::vector<std::int64_t> begin(ghosts + 1);
  std::vector<FitPair> pairs(ghosts * particles + 8);
  std::vector<FitTerms<double, 2>> terms(ghosts);
  const std::vector<std::int64_t> at_free_surfaces(ghosts, -1);
  for (std::int64_t g = 0; g <= ghosts; ++g) begin[g] = g * particles;
  for (std::int64_t i = 0; i < ghosts * particles; ++i) {
    pairs[i] = fit_pair<2>(static_cast<std::int32_t>(i / particles + random() % 100), {1, -1});
  }
  test::Field<double> distance(ghosts + 100, -1.);
  test::Field<double> records((ghosts + 100) * width, 1.), sums(ghosts * 3 * width);
  const GhostSums<double, 2> arguments{
      0,       ghosts,          begin.data(),   pairs.data(), terms.data(), at_free_surfaces.data(),
      nullptr, distance.data(), records.data(), sums.data()};
  for (auto _ : state) RemeshedTable<double, 2>::of(isa).sum_ghosts(arguments);
  report(state, ghosts, {particles * (width * 6 + 30), 20 * 8 + 13 * 8 + 64 + 4 * 64});
}

const bool registered = [] {
  register_sizes("sum_ghosts", sum);
  return true;
}();

}  // namespace
}  // namespace pliant::kernels::bench
