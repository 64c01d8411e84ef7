#include "engine/bench/standard_set.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cstdio>

#include "engine/bench/cases.hpp"
#include "engine/bench/growth.hpp"
#include "engine/bench/machine.hpp"
#include "engine/bench/report.hpp"
#include "engine/bench/stage_cost.hpp"
#include "engine/bench/windows.hpp"
#include "engine/output/atomic_file.hpp"

namespace pliant::bench {

namespace {

using kernels::Kernel;

constexpr std::int64_t compression_columns = 256, quick_compression_columns = 64;

// Pairs of rows: one thread, then all.
std::vector<Row> all_rows(const StandardSetOptions& options) {
  if (options.largest) return growth_rows(*options.largest, options.threads);
  std::vector<Row> rows;
  const auto add = [&](const Case& settings, const Window& window) {
    rows.push_back({settings, window, 1, {}});
    if (options.threads > 1) rows.push_back({settings, window, options.threads, {}});
  };
  const auto add_balls = [&](std::int64_t particles) {
    for (const Kernel kernel : {Kernel::quartic_spline_fit, Kernel::compact}) {
      add(spinning_ball(particles, kernel), window_for(particles));
    }
  };
  if (options.ball) {
    add_balls(*options.ball);
    return rows;
  }
  for (const std::int64_t particles : {2'000, 10'000, 131'072, 1'000'000}) {
    if (options.quick && particles > 131'072) continue;
    for (const Kernel kernel :
         {Kernel::quartic_spline, Kernel::quartic_spline_fit, Kernel::compact}) {
      add(rotating_cylinder(particles, kernel), window_for(particles));
    }
  }
  add_balls(100'000);
  if (!options.quick) add_balls(1'000'000);
  for (const std::int64_t nodes : {8'000, 64'000, 1'000'000}) {
    if (options.quick && nodes > 64'000) continue;
    for (const Precision precision : {Precision::binary64, Precision::binary32}) {
      add(point_block(nodes, precision), window_of_points(nodes));
    }
  }
  for (const int dimension : {3, 2}) {
    for (const std::int64_t particles : {10'000, 100'000, 1'000'000}) {
      if (options.quick && particles > 100'000) continue;
      for (const Precision precision : {Precision::binary64, Precision::binary32}) {
        add(elastic_block(dimension, particles, precision), window_of_points(particles));
      }
    }
  }
  constexpr std::int64_t whole_run = 1'000'000;
  add(compression(options.quick ? quick_compression_columns : compression_columns,
                  Kernel::quartic_spline),
      {0, whole_run, whole_run});
  return rows;
}

void print_machine(const std::vector<std::string>& machine, int threads, Triad& triad) {
  for (const std::string& line : machine) fmt::print("{}\n", line);
  fmt::print("\n{:<32}{:>10}", "just now", "1 thread");
  if (threads > 1) fmt::print("{:>12}", fmt::format("{} threads", threads));
  const auto print = [&](const std::string& what, const auto& rate) {
    fmt::print("\n{:<32}{:>10.1f}", what, 1e-9 * rate(1));
    if (threads > 1) fmt::print("{:>12.1f}", 1e-9 * rate(threads));
  };
  for (const auto isa : {kernels::Isa::sse2, kernels::Isa::avx2, kernels::Isa::avx512}) {
    if (!kernels::is_supported(isa)) continue;
    print(fmt::format("FMA peak, {} [GFLOP/s]", kernels::name(isa)),
          [isa](int count) { return fma_peak(isa, count); });
  }
  print("triad [GB/s]", [&](int count) { return triad(count); });
  fmt::print("\n\n");
}

void print_assumptions() {
  fmt::print("Assumed for each particle and stage, in the plane:");
  for (const Kernel kernel :
       {Kernel::quartic_spline, Kernel::quartic_spline_fit, Kernel::compact}) {
    fmt::print(" {} flop ({}),", flop_per_stage(kernel, kernels::Model::linear),
               kernel == Kernel::quartic_spline ? "quartic"
               : kernel == Kernel::compact      ? "compact"
                                                : "quartic_spline_fit");
  }
  fmt::print(" {} bytes; {} bytes and {} flop more for a hyperelastic material.\n",
             bytes_per_stage(kernels::Model::linear),
             bytes_per_stage(kernels::Model::reduced_polynomial),
             flop_per_stage(Kernel::compact, kernels::Model::reduced_polynomial) -
                 flop_per_stage(Kernel::compact, kernels::Model::linear));
}

constexpr const char* legend =
    "M/s: million particle-stages a second, everything included; median and range of the "
    "repetitions.\n"
    "speed, FMA's: rate over that on one thread, and what the FMA peak itself gained beside it.\n"
    "hand: a cache line from one thread's processor to another's and back [ns]; several times "
    "longer where processors of a virtual machine share no cache.\n"
    "% peak, % triad: of what the machine gave beside each repetition.  B/part: all fields.\n"
    "idle %: of the threads' time outside phases; extra: less that of the largest body.\n"
    "point_block: steps of nodes with 26 neighbours, by precision, with the peak of that "
    "precision.\n"
    "elastic_block: steps of particles of the total Lagrangian method, by precision.\n"
    "CPU %: processor time over threads x wall time; well below 100 the machine was busy "
    "otherwise.\n";

}  // namespace

std::vector<Row> standard_set(const StandardSetOptions& options) {
  std::vector<Row> rows = all_rows(options);
  std::erase_if(rows,
                [&](const Row& row) { return row.name().find(options.rows) == row.name().npos; });
  if (!rows.empty()) return rows;
  throw InputError(
      fmt::format("--rows {}: no row of the set has this in its name; give for example "
                  "rotating_cylinder or {}",
                  options.rows, all_rows(options).front().name()));
}

std::vector<std::string> names_of_rows(const StandardSetOptions& options) {
  std::vector<std::string> names;
  for (const Row& row : standard_set(options)) names.push_back(row.name());
  return names;
}

Record run_standard_set(const StandardSetOptions& options) {
  const kernels::Isa isa = kernels::widest_supported();
  const std::vector<std::string> machine = machine_description();
  std::vector<Row> rows = standard_set(options);
  Triad triad;
  if (options.tables) print_machine(machine, options.threads, triad);
  const int repetitions = options.repetitions.value_or(options.quick ? 3 : 5);
  for (int repetition = 1; repetition <= repetitions; ++repetition) {
    for (Row& row : rows) {
      row.samples.push_back(measure(row.settings, row.window, row.threads, isa, triad));
      fmt::print(stderr, "{}/{} {} {} {}, {} threads: {:.2f} M/s\n", repetition, repetitions,
                 row.settings.name, row.samples.back().particles, row.kernel(), row.threads,
                 1e-6 * row.samples.back().rate());
    }
  }
  if (options.growth_markdown) {
    write_atomically(*options.growth_markdown, growth_markdown(rows), Durable::no);
  }
  if (options.tables && options.largest) {
    fmt::print("{}", growth_text(rows));
  } else if (options.tables) {
    print_assumptions();
    fmt::print("\n{}\n{}\nThread time per particle-stage [ns]:\n\n{}", speed_table(rows), legend,
               phase_table(rows));
  }
  if (options.csv) write_atomically(*options.csv, csv(machine, rows), Durable::no);
  return record_of(machine, rows);
}

}  // namespace pliant::bench
