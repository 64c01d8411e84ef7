#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/accuracy/record.hpp"

namespace pliant::accuracy {

namespace {

using Cells = std::vector<std::string>;
using Table = std::vector<Cells>;  ///< the first row is the heading

constexpr const char* costs_legend =
    "Wall time and particles at which the error, and that of all finer runs, falls to the given "
    "one;\n"
    "interpolated in logarithms. <: the coarsest run reaches it already; ~: only the finest run\n"
    "reaches it, and none confirms it; -: not reached.\n";

std::string cost_cell(const Cost& cost) {
  const char* mark = cost.certainty == Certainty::at_most       ? "< "
                     : cost.certainty == Certainty::unconfirmed ? "~ "
                                                                : "";
  if (cost.certainty == Certainty::not_reached) return "-";
  return fmt::format("{}{:.3g} s, {:.0f}", mark, cost.seconds, cost.particles);
}

Table table_of_costs(const AccuracyRecord& record) {
  Table table = {{"problem", "method"}};
  for (const double error : errors_of_interest) {
    table[0].push_back(fmt::format("to {:g} %", 100 * error));
  }
  for (const SeriesRecord& row : record.rows) {
    Cells cells = {row.problem, row.series};
    for (const double error : errors_of_interest) cells.push_back(cost_cell(row.cost_of(error)));
    table.push_back(cells);
  }
  return table;
}

/// The values of the settings, whose keys are known.
std::string rung_cell(const RungRecord& rung) {
  std::string text;
  for (const std::string& setting : rung.settings) {
    if (!text.empty()) text += ", ";
    text += setting.substr(setting.find('=') + 1);
  }
  return text;
}

Table table_of_runs(const AccuracyRecord& record) {
  Table table = {{"problem", "method", "rung", "particles", "steps", "time [s]", "error [%]"}};
  for (const SeriesRecord& row : record.rows) {
    for (const RungRecord& rung : row.rungs) {
      const bool has_answer = !std::isnan(rung.error);
      table.push_back({row.problem, row.series, rung_cell(rung),
                       has_answer ? fmt::format("{}", rung.particles) : "-",
                       has_answer ? fmt::format("{}", rung.steps) : "-",
                       has_answer ? fmt::format("{:.3g}", rung.median_seconds()) : "-",
                       has_answer ? fmt::format("{:.3g}", 100 * rung.error) : rung.message});
    }
  }
  return table;
}

std::string aligned(const Table& table) {
  std::vector<std::size_t> widths(table[0].size(), 0);
  for (const Cells& cells : table) {
    for (std::size_t c = 0; c < cells.size(); ++c) widths[c] = std::max(widths[c], cells[c].size());
  }
  std::string text;
  for (const Cells& cells : table) {
    for (std::size_t c = 0; c + 1 < cells.size(); ++c) {
      text += fmt::format("{:<{}}  ", cells[c], widths[c]);
    }
    text += cells.back() + "\n";
  }
  return text;
}

std::string as_markdown(const Table& table) {
  std::string text;
  for (std::size_t line = 0; line < table.size(); ++line) {
    text += fmt::format("| {} |\n", fmt::join(table[line], " | "));
    if (line == 0) text += fmt::format("|{}\n", fmt::join(Cells(table[0].size(), " --- |"), ""));
  }
  return text;
}

std::string heading_of(const AccuracyRecord& record) {
  return fmt::format("{}\n{} threads\n", fmt::join(record.machine, "\n"), record.threads);
}

}  // namespace

std::string text_of(const AccuracyRecord& record) {
  return fmt::format("{}\n{}\n{}\n{}", heading_of(record), aligned(table_of_runs(record)),
                     aligned(table_of_costs(record)), costs_legend);
}

std::string markdown_of(const AccuracyRecord& record) {
  return fmt::format("{}\n{}\n{}\n{}", heading_of(record), as_markdown(table_of_costs(record)),
                     costs_legend, as_markdown(table_of_runs(record)));
}

}  // namespace pliant::accuracy
