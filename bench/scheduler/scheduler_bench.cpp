#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "scheduler/step_graph.hpp"

// The cost of the scheduler in a small step: 8 blocks in a ring, four stages of three phases each
// (as in a Runge-Kutta step: records, ghosts of neighbours, advance), and one fold. Nodes do a
// fixed amount of arithmetic. From the record of each step,
//
//     idle = 1 - (seconds inside phases)/(threads x wall seconds)
//
// includes scheduling, waiting and timing. Figures are medians over all steps and over the fastest
// tenth of them. Other load on the machine still affects them, since a worker without a core counts
// as idle.
namespace pliant::scheduler {

namespace {

constexpr int block_count = 8, stage_count = 4;

// Runs a chain of dependent multiplications.
void work(std::int64_t links) {
  double x = 1.0;
  for (std::int64_t i = 0; i < links; ++i) {
    x = x * 0.999999 + 1e-9;
    benchmark::DoNotOptimize(x);
  }
}

// Uses the fastest of many samples, since disturbances only make a chain slower.
std::int64_t links_in(double microseconds) {
  constexpr std::int64_t sample = 100'000;
  static const double seconds_per_link = [] {
    double best = 1e9;
    for (int i = 0; i < 50; ++i) {
      const auto start = std::chrono::steady_clock::now();
      work(sample);
      const auto stop = std::chrono::steady_clock::now();
      best = std::min(best, std::chrono::duration<double>(stop - start).count());
    }
    return best / sample;
  }();
  return static_cast<std::int64_t>(microseconds * 1e-6 / seconds_per_link);
}

Blocks ring_of_blocks(int count) {
  Blocks blocks;
  for (int b = 0; b < count; ++b)
    blocks.neighbours.push_back({(b + 1) % count, (b + count - 1) % count});
  return blocks;
}

StepGraph small_step(int blocks, std::int64_t links) {
  enum : FieldId { state, next, record, ghost, time_step };
  const auto run = [links](BlockId) { work(links); };
  std::vector<Phase> phases;
  const auto add = [&](const char* name, int stage, std::vector<Access> reads,
                       std::vector<Access> writes) {
    phases.push_back({.name = name,
                      .stage = stage,
                      .reads = std::move(reads),
                      .writes = std::move(writes),
                      .blocks = {},
                      .run = run});
  };
  for (int stage = 0; stage < stage_count; ++stage) {
    const FieldId from = stage % 2 == 0 ? state : next, to = stage % 2 == 0 ? next : state;
    add("records", stage, {{from}}, {{record}});
    add("ghosts", stage, {{record, Reach::neighbours}}, {{ghost}});
    add("advance", stage, {{from, Reach::neighbours}, {ghost, Reach::neighbours}, {time_step}},
        {{to}});
  }
  add("time step", -1, {{state, Reach::all}}, {{time_step, Reach::all}});
  phases.back().kind = Phase::Kind::reduce;
  phases.back().run = [](BlockId) {};
  return {std::move(phases), ring_of_blocks(blocks), {"state", "next", "record", "ghost", "dt"}};
}

struct Cost {
  double wall, idle_share;  // [s], 1
};

// Arguments: threads, microseconds per node.
void step_of_100_nodes(benchmark::State& state) {
  const auto threads = static_cast<int>(state.range(0));
  StepGraph graph = small_step(block_count, links_in(static_cast<double>(state.range(1))));
  Workers workers(threads);
  graph.run(workers);

  std::vector<Cost> costs;
  for (auto _ : state) {
    graph.run(workers);
    costs.push_back({graph.record().wall_seconds, graph.record().idle_share()});
  }
  std::sort(costs.begin(), costs.end(), [](auto& a, auto& b) { return a.wall < b.wall; });
  const auto report = [&](const char* which, std::size_t position) {
    const Cost& cost = costs[position];
    const double lost_per_node =
        threads * cost.wall * cost.idle_share / static_cast<double>(graph.nodes().size());
    const auto name = [&](const char* what) { return std::string(what) + which; };
    state.counters[name("wall_us")] = cost.wall * 1e6;
    state.counters[name("idle")] = cost.idle_share;
    state.counters[name("lost_ns_per_node")] = lost_per_node * 1e9;
  };
  report("", costs.size() / 2);
  report("_quick", costs.size() / 10);
}
BENCHMARK(step_of_100_nodes)
    ->ArgNames({"threads", "us"})
    ->ArgsProduct({{1, 2}, {0, 2, 5, 10, 20}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

// Derives the edges and prepares the first run, as after a change of the blocks.
void build(benchmark::State& state) {
  Workers workers(1);
  for (auto _ : state) {
    StepGraph graph = small_step(static_cast<int>(state.range(0)), 0);
    graph.run(workers);
    benchmark::DoNotOptimize(graph.edges().size());
  }
}
BENCHMARK(build)->ArgName("blocks")->Arg(8)->Arg(64)->Arg(512)->Unit(benchmark::kMicrosecond);

// Reads the clock, as each node does twice.
void clock_reading(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(std::chrono::steady_clock::now());
}
BENCHMARK(clock_reading);

}  // namespace

}  // namespace pliant::scheduler
