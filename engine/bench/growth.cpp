#include "engine/bench/growth.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/bench/cases.hpp"
#include "engine/bench/windows.hpp"

namespace pliant::bench {

namespace {

using Cells = std::vector<std::string>;

double particle_steps_per_second(const Sample& sample) {
  return static_cast<double>(sample.particles) * static_cast<double>(sample.steps) /
         sample.elapsed.wall;
}

std::vector<Cells> cells_of(const std::vector<Row>& rows) {
  std::vector<Cells> table = {{"method", "dimension", "kernel", "threads", "particles",
                               "set-up [s]", "set-up [us/particle]", "fields [B/particle]",
                               "resident [B/particle]", "particle-steps [M/s]"}};
  for (const Row& row : rows) {
    const Sample& first = row.samples[0];
    const double setup = row.median([](const Sample& s) { return s.setup_seconds; });
    table.push_back(
        {row.settings.method, fmt::format("{}", row.settings.dimension), row.kernel(),
         fmt::format("{}", row.threads), fmt::format("{}", first.particles),
         fmt::format("{:.3g}", setup),
         fmt::format("{:.2f}", 1e6 * setup / static_cast<double>(first.particles)),
         fmt::format("{:.0f}", row.median([](const Sample& s) { return s.bytes_per_particle; })),
         fmt::format("{:.0f}", row.median([](const Sample& s) { return s.resident_per_particle; })),
         fmt::format("{:.3g}", 1e-6 * row.median(particle_steps_per_second))});
  }
  return table;
}

}  // namespace

std::vector<Row> growth_rows(std::int64_t largest, int threads) {
  constexpr kernels::Kernel kernel = kernels::Kernel::compact;
  std::vector<Row> rows;
  const auto add = [&](const Case& settings, const Window& window) {
    rows.push_back({settings, window, threads, {}});
  };
  const auto all_sizes = [&](const auto& add_size) {
    for (std::int64_t size = 10'000; size <= largest; size *= 10) add_size(size);
  };
  all_sizes([&](std::int64_t n) { add(rotating_cylinder(n, kernel), window_for(n)); });
  all_sizes([&](std::int64_t n) { add(spinning_ball(n, kernel), window_for(n)); });
  for (const char* method : {"total_lagrangian", "point_based"}) {
    for (const int dimension : {2, 3}) {
      for (const Precision precision : {Precision::binary64, Precision::binary32}) {
        all_sizes([&](std::int64_t n) {
          add(elastic_block(dimension, n, precision, method), window_of_points(n));
        });
      }
    }
  }
  return rows;
}

std::string growth_text(const std::vector<Row>& rows) {
  const std::vector<Cells> table = cells_of(rows);
  std::string text;
  for (const Cells& cells : table) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      text += fmt::format("{:<{}}", cells[c], std::max(table[0][c].size(), std::size_t{16}) + 2);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

std::string growth_markdown(const std::vector<Row>& rows) {
  std::string text;
  const std::vector<Cells> table = cells_of(rows);
  for (std::size_t line = 0; line < table.size(); ++line) {
    text += fmt::format("| {} |\n", fmt::join(table[line], " | "));
    if (line == 0) text += fmt::format("|{}\n", fmt::join(Cells(table[0].size(), " --- |"), ""));
  }
  return text;
}

}  // namespace pliant::bench
