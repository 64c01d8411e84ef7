#include "engine/bench/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace pliant::bench {

namespace {

double processor_share(const Row& row, const Sample& sample) {
  return sample.elapsed.processor / (row.threads * sample.elapsed.wall);
}

double steps_per_remeshing(const Sample& sample) {
  return static_cast<double>(sample.steps) /
         static_cast<double>(std::max<std::int64_t>(sample.remeshings, 1));
}

double per_particle_stage(const Sample& sample, double seconds) {
  return 1e9 * seconds / static_cast<double>(sample.particle_stages);
}

double idle_time(const Row& row, const Sample& sample) {
  return per_particle_stage(sample, row.threads * sample.elapsed.wall - sample.phase_seconds);
}

// Kinds of phases, the columns of the phase table.
constexpr std::array<std::string_view, 7> kinds = {"advance", "surface",   "ghosts", "fits",
                                                   "remesh",  "level set", "other"};

std::string_view kind_of(std::string_view phase) {
  if (phase.starts_with("ghosts: ")) return "fits";
  const std::string_view beginning = phase.substr(0, phase.find(':'));
  const auto kind = std::find(kinds.begin(), kinds.end(), beginning);
  return kind == kinds.end() ? "other" : *kind;
}

double time_of_kind(const Sample& sample, std::string_view kind) {
  double seconds = 0;
  for (const auto& phase : sample.phases) {
    if (kind_of(phase.name) == kind) seconds += phase.seconds;
  }
  return per_particle_stage(sample, seconds);
}

double time_of_phase(const Sample& sample, std::string_view name) {
  for (const auto& phase : sample.phases) {
    if (phase.name == name) return per_particle_stage(sample, phase.seconds);
  }
  return 0;
}

std::string heading_of(const Row& row) {
  return fmt::format("{:<25}{:>8} {:<19}{:>3}", row.settings.name, row.samples[0].particles,
                     row.kernel(), row.threads);
}

std::string row_heading() {
  return fmt::format("{:<25}{:>8} {:<19}{:>3}", "case", "N", "kernel", "thr");
}

}  // namespace

std::string speed_table(const std::vector<Row>& rows) {
  std::string table = fmt::format(
      "{} {:>7} {:>13} {:>6} {:>5} {:>5} {:>8} {:>6} {:>6} {:>7} {:>6} {:>6} {:>6} {:>5}\n",
      row_heading(), "M/s", "least..most", "speed", "FMA's", "hand", "GFLOP/s", "% peak", "GB/s",
      "% triad", "B/part", "idle %", "extra", "CPU %");
  for (const Row& row : rows) {
    const Spread rate = row.spread([](const Sample& s) { return s.rate() * 1e-6; });
    table += fmt::format(
        "{} {:>7.2f} {:>13} {:>6.2f} {:>5.2f} {:>5.0f} {:>8.1f} {:>6.1f} {:>6.2f} {:>7.1f} "
        "{:>6.0f} {:>6.1f} {:>6.1f} {:>5.0f}\n",
        heading_of(row), rate.median, fmt::format("{:.2f}..{:.2f}", rate.least, rate.most),
        speed_up(rows, row, [](const Sample& s) { return s.rate(); }),
        speed_up(rows, row, [](const Sample& s) { return s.fma_peak; }),
        1e9 * row.median([](const Sample& s) { return s.hand_over; }),
        1e-9 * row.median([&](const Sample& s) { return row.flop_rate(s); }),
        100 * row.median([&](const Sample& s) { return row.flop_rate(s) / row.fma_peak(s); }),
        1e-9 * row.median([&](const Sample& s) { return row.byte_rate(s); }),
        100 * row.median([&](const Sample& s) { return row.byte_rate(s) / s.triad; }),
        row.median([](const Sample& s) { return s.bytes_per_particle; }),
        100 * row.median([&](const Sample& s) { return row.idle_share(s); }),
        100 * extra_idle_share(rows, row),
        100 * row.median([&](const Sample& s) { return processor_share(row, s); }));
  }
  return table;
}

std::string phase_table(const std::vector<Row>& rows) {
  std::string table = row_heading();
  for (const std::string_view kind : kinds) table += fmt::format(" {:>9}", kind);
  table += fmt::format(" {:>9} {:>15}\n", "idle", "steps/remeshing");
  for (const Row& row : rows) {
    table += heading_of(row);
    for (const std::string_view kind : kinds) {
      table += fmt::format(" {:>9.2f}",
                           row.median([&](const Sample& s) { return time_of_kind(s, kind); }));
    }
    table += fmt::format(" {:>9.2f} {:>15.1f}\n",
                         row.median([&](const Sample& s) { return idle_time(row, s); }),
                         row.median(steps_per_remeshing));
  }
  return table;
}

std::string csv(const std::vector<std::string>& machine, const std::vector<Row>& rows) {
  std::string text;
  for (const std::string& line : machine) text += "# " + line + "\n";
  std::vector<std::string> phases;  // of all rows, in order of first appearance
  for (const Row& row : rows) {
    for (const auto& phase : row.samples[0].phases) {
      if (std::find(phases.begin(), phases.end(), phase.name) == phases.end())
        phases.push_back(phase.name);
    }
  }
  text +=
      "case,particles,kernel,threads,samples,steps,steps per remeshing,"
      "particle-stages/s,least,most,speed-up,FMA speed-up,hand-over s,flop per particle-stage,"
      "FMA peak flop/s,share of FMA peak,bytes per particle-stage,triad bytes/s,"
      "share of triad,bytes per particle,"
      "idle share,extra idle share,processor share,idle ns per particle-stage";
  for (const std::string& phase : phases) text += ",\"" + phase + " ns per particle-stage\"";
  text += "\n";
  for (const Row& row : rows) {
    const Spread rate = row.spread([](const Sample& s) { return s.rate(); });
    text += fmt::format(
        "{},{},{},{},{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{},{:.4g},{:.4g},{},"
        "{:.4g},{:.4g},{:.0f},{:.4f},{:.4f},{:.4f},{:.4g}",
        row.settings.name, row.samples[0].particles, row.kernel(), row.threads, row.samples.size(),
        row.samples[0].steps, row.median(steps_per_remeshing), rate.median, rate.least, rate.most,
        speed_up(rows, row, [](const Sample& s) { return s.rate(); }),
        speed_up(rows, row, [](const Sample& s) { return s.fma_peak; }),
        row.median([](const Sample& s) { return s.hand_over; }), row.flop(),
        row.median([&](const Sample& s) { return row.fma_peak(s); }),
        row.median([&](const Sample& s) { return row.flop_rate(s) / row.fma_peak(s); }),
        row.bytes(), row.median([](const Sample& s) { return s.triad; }),
        row.median([&](const Sample& s) { return row.byte_rate(s) / s.triad; }),
        row.median([](const Sample& s) { return s.bytes_per_particle; }),
        row.median([&](const Sample& s) { return row.idle_share(s); }), extra_idle_share(rows, row),
        row.median([&](const Sample& s) { return processor_share(row, s); }),
        row.median([&](const Sample& s) { return idle_time(row, s); }));
    for (const std::string& phase : phases) {
      text += fmt::format(",{:.3f}",
                          row.median([&](const Sample& s) { return time_of_phase(s, phase); }));
    }
    text += "\n";
  }
  return text;
}

}  // namespace pliant::bench
