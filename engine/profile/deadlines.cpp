#include "engine/profile/deadlines.hpp"

#include <algorithm>
#include <numeric>

namespace pliant::profile {

namespace {

Distribution distribution_of(const std::vector<double>& values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {sum / static_cast<double>(values.size()),
          percentile_of(values, 50),
          percentile_of(values, 95),
          percentile_of(values, 99),
          percentile_of(values, 99.9),
          percentile_of(values, 100)};
}

template <class Record>
std::vector<double> wall_times(const std::vector<Record>& records) {
  std::vector<double> times(records.size());
  std::transform(records.begin(), records.end(), times.begin(),
                 [](const Record& record) { return record.wall_seconds; });
  return times;
}

void count_missed(const std::vector<double>& times, double budget, Verdict& verdict) {
  std::int64_t streak = 0;
  for (const double time : times) {
    streak = time > budget ? streak + 1 : 0;
    verdict.missed += time > budget ? 1 : 0;
    verdict.longest_streak = std::max(verdict.longest_streak, streak);
  }
}

std::vector<std::size_t> worst_of(const std::vector<double>& times) {
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t count = std::min<std::size_t>(10, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      return times[a] != times[b] ? times[a] > times[b] : a < b;
                    });
  order.resize(count);
  return order;
}

std::vector<Part> compare_parts(const Profile& profile, const std::vector<std::size_t>& worst,
                                double total) {
  std::vector<Part> parts;
  const auto names = names_of_parts(profile.phases);
  parts.reserve(names.size());
  std::vector<std::vector<double>> of_frame(profile.frames.size());
  std::transform(profile.frames.begin(), profile.frames.end(), of_frame.begin(), parts_of);
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<double> times(of_frame.size());
    std::transform(of_frame.begin(), of_frame.end(), times.begin(),
                   [i](const auto& frame) { return frame[i]; });
    Part part{names[i], std::accumulate(times.begin(), times.end(), 0.0) / total,
              percentile_of(times, 50), 0};
    for (const std::size_t frame : worst) {
      part.in_worst += times[frame] / static_cast<double>(worst.size());
    }
    parts.push_back(part);
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.share > b.share; });
  return parts;
}

}  // namespace

std::vector<double> parts_of(const FrameRecord& frame) {
  std::vector<double> parts = frame.phase_seconds;
  parts.insert(parts.end(),
               {frame.scheduling_seconds, frame.waiting_seconds, frame.serial_seconds});
  return parts;
}

std::vector<std::string> names_of_parts(const std::vector<std::string>& phases) {
  std::vector<std::string> names = phases;
  names.insert(names.end(), {"scheduling", "waiting", "serial part"});
  return names;
}

Verdict judge(const Profile& profile) {
  const std::vector<double> times = wall_times(profile.frames);
  const double total = std::accumulate(times.begin(), times.end(), 0.0);
  Verdict verdict;
  verdict.at_percentile = percentile_of(times, profile.options.percentile);
  verdict.held = verdict.at_percentile <= profile.options.budget;
  count_missed(times, profile.options.budget, verdict);
  verdict.real_time_factor =
      profile.options.frame_seconds * static_cast<double>(times.size()) / total;
  verdict.frames = distribution_of(times);
  verdict.steps = distribution_of(wall_times(profile.steps));
  verdict.worst = worst_of(times);
  verdict.parts = compare_parts(profile, verdict.worst, total);
  const auto most =
      std::max_element(verdict.parts.begin(), verdict.parts.end(),
                       [](const Part& a, const Part& b) { return a.excess() < b.excess(); });
  verdict.to_blame = static_cast<std::size_t>(most - verdict.parts.begin());
  return verdict;
}

}  // namespace pliant::profile
