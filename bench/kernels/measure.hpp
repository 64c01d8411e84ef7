#pragma once

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "kernels/remeshed/table.hpp"

namespace pliant::kernels::bench {

/// The cost of a particle: floating-point operations (an fma counts as two), and bytes between
/// processor and memory if caches hold nothing.
struct Cost {
  double flop = 0;
  double bytes = 0;
};

/// Rates besides the time: particles, flop and bytes per second.
inline void report(benchmark::State& state, std::int64_t particles, Cost each) {
  const double total = static_cast<double>(state.iterations()) * static_cast<double>(particles);
  state.SetItemsProcessed(static_cast<std::int64_t>(total));
  state.counters["flop"] = each.flop;
  state.counters["bytes"] = each.bytes;
  state.counters["GFLOP/s"] =
      benchmark::Counter(total * each.flop * 1e-9, benchmark::Counter::kIsRate);
  state.counters["GB/s"] =
      benchmark::Counter(total * each.bytes * 1e-9, benchmark::Counter::kIsRate);
}

/// Runs `run(state, isa)` for 10^3 ... 10^6 particles on every instruction set of the machine.
template <class Run>
void register_sizes(const std::string& name, const Run& run) {
  for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
    if (!is_supported(isa)) continue;
    benchmark::RegisterBenchmark((name + "/" + std::string(kernels::name(isa))).c_str(),
                                 [=](benchmark::State& state) { run(state, isa); })
        ->Arg(1000)
        ->Arg(10000)
        ->Arg(130000)
        ->Arg(1000000);
  }
}

/// Cells of a nearly square or cubic box with about `particles` interior cells.
template <int D>
std::array<int, D> box(std::int64_t particles) {
  const int side = static_cast<int>(std::lround(std::pow(static_cast<double>(particles), 1. / D)));
  std::array<int, D> cells;
  cells.fill(side + 6);
  cells[0] = (side + 6 + 7) / 8 * 8;
  return cells;
}

}  // namespace pliant::kernels::bench
