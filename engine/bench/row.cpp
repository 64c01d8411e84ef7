#include "engine/bench/row.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/bench/stage_cost.hpp"
#include "engine/case/vocabulary/words.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::bench {

namespace {

double middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n == 0 ? 0 : (values[(n - 1) / 2] + values[n / 2]) / 2;
}

bool same_case_and_kernel(const Row& a, const Row& b) {
  return a.settings.name == b.settings.name && a.kernel() == b.kernel();
}

bool is_point_based(const Case& settings) { return settings.method == "point_based"; }

bool is_total_lagrangian(const Case& settings) { return settings.method == "total_lagrangian"; }

int value_size(const Case& settings) { return settings.precision == Precision::binary32 ? 4 : 8; }

NodeCost cost_of_nodes(const Case& settings) {
  return point_based_cost(settings.dimension, point_based::neighbour_count(settings),
                          value_size(settings));
}

kernels::Model model_of(const Case& settings) { return settings.bodies[0].material.model; }

}  // namespace

std::string Row::name() const {
  return fmt::format("{}/{}/{:.4g}/{}", settings.name, kernel(), settings.discretisation.spacing,
                     threads);
}

std::string Row::kernel() const {
  const bool is_by_precision = is_point_based(settings) || is_total_lagrangian(settings);
  return std::string(is_by_precision ? pliant::text_of(settings.precision)
                                     : pliant::text_of(settings.discretisation.kernel));
}

double Row::flop() const {
  if (is_total_lagrangian(settings)) return total_lagrangian_cost(settings.dimension, 8).flop;
  if (is_point_based(settings)) return cost_of_nodes(settings).flop;
  return flop_per_stage(settings.discretisation.kernel, model_of(settings), settings.dimension);
}

double Row::bytes() const {
  if (is_total_lagrangian(settings)) {
    return total_lagrangian_cost(settings.dimension, value_size(settings)).bytes;
  }
  if (is_point_based(settings)) return cost_of_nodes(settings).bytes;
  return bytes_per_stage(model_of(settings), settings.dimension);
}

Spread Row::spread(const Figure& figure) const {
  std::vector<double> values;
  for (const Sample& sample : samples) values.push_back(figure(sample));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {middle(values), *least, *most};
}

double Row::flop_rate(const Sample& sample) const { return sample.rate() * flop(); }

double Row::byte_rate(const Sample& sample) const { return sample.rate() * bytes(); }

double Row::fma_peak(const Sample& sample) const {
  return settings.precision == Precision::binary32 ? 2 * sample.fma_peak : sample.fma_peak;
}

double Row::idle_share(const Sample& sample) const {
  return 1 - sample.phase_seconds / (threads * sample.elapsed.wall);
}

double speed_up(const std::vector<Row>& rows, const Row& row, const Figure& rate) {
  const auto alone = std::find_if(rows.begin(), rows.end(), [&](const Row& other) {
    return other.threads == 1 && same_case_and_kernel(row, other) &&
           row.settings.discretisation.spacing == other.settings.discretisation.spacing;
  });
  if (alone == rows.end()) return 0;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(row.samples.size(), alone->samples.size()); ++i) {
    ratios.push_back(rate(row.samples[i]) / rate(alone->samples[i]));
  }
  return middle(ratios);
}

double extra_idle_share(const std::vector<Row>& rows, const Row& row) {
  const auto idle = [](const Row& r) {
    return r.median([&](const Sample& sample) { return r.idle_share(sample); });
  };
  const Row* largest = &row;
  for (const Row& other : rows) {
    if (other.threads == row.threads && same_case_and_kernel(row, other) &&
        other.samples[0].particles > largest->samples[0].particles) {
      largest = &other;
    }
  }
  return idle(row) - idle(*largest);
}

}  // namespace pliant::bench
