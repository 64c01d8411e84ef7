#include "engine/batch/designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "engine/batch/sobol.hpp"

namespace pliant::batch {

namespace {

/// In [0, 1). std::uniform_real_distribution is not used, since its numbers differ between
/// libraries.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

Assignment assignment_at(const std::vector<Interval>& intervals,
                         const std::vector<double>& position) {
  Assignment assignment;
  assignment.reserve(intervals.size());
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    assignment.emplace_back(intervals[i].key, number_text(intervals[i].at(position[i])));
  }
  return assignment;
}

}  // namespace

double Interval::at(double position) const {
  return logarithmic ? from * std::pow(to / from, position) : from + (to - from) * position;
}

std::string number_text(double value) { return fmt::format("{}", value); }

ValueList range_of(const Interval& interval, int count) {
  ValueList list{interval.key, {}};
  list.values.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const bool is_last = i == count - 1 && count > 1;
    list.values.push_back(
        number_text(is_last ? interval.to : interval.at(count > 1 ? i / (count - 1.0) : 0)));
  }
  return list;
}

std::vector<Assignment> product_of(const std::vector<ValueList>& lists) {
  std::vector<Assignment> all(1);
  for (const ValueList& list : lists) {
    std::vector<Assignment> longer;
    longer.reserve(all.size() * list.values.size());
    for (const Assignment& assignment : all) {
      for (const std::string& value : list.values) {
        longer.push_back(assignment);
        longer.back().emplace_back(list.key, value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::vector<Assignment> zip_of(const std::vector<ValueList>& lists) {
  std::vector<Assignment> all(lists.empty() ? 0 : lists.front().values.size());
  for (const ValueList& list : lists) {
    for (std::size_t i = 0; i < all.size(); ++i) all[i].emplace_back(list.key, list.values[i]);
  }
  return all;
}

std::vector<Assignment> latin_hypercube(const std::vector<Interval>& intervals, int samples,
                                        std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto count = static_cast<std::size_t>(samples);
  std::vector<std::vector<double>> positions(count, std::vector<double>(intervals.size()));
  std::vector<std::size_t> part(count);
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    std::iota(part.begin(), part.end(), std::size_t{0});
    for (std::size_t n = count; n > 1; --n) std::swap(part[n - 1], part[random() % n]);
    for (std::size_t s = 0; s < count; ++s) {
      positions[s][i] =
          (static_cast<double>(part[s]) + uniform(random)) / static_cast<double>(count);
    }
  }
  std::vector<Assignment> all;
  all.reserve(count);
  for (const auto& position : positions) all.push_back(assignment_at(intervals, position));
  return all;
}

std::vector<Assignment> sobol(const std::vector<Interval>& intervals, int samples,
                              std::uint64_t seed) {
  SobolSequence sequence(static_cast<int>(intervals.size()), seed);
  std::vector<Assignment> all;
  all.reserve(static_cast<std::size_t>(samples));
  for (int s = 0; s < samples; ++s) all.push_back(assignment_at(intervals, sequence.next()));
  return all;
}

std::string name_of(const Assignment& assignment) {
  Assignment sorted = assignment;
  std::sort(sorted.begin(), sorted.end());
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const auto& [key, value] : sorted) {
    for (const char c : key + "=" + value + "\n") {
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    }
  }
  // The last characters have not affected all bits yet.
  hash = (hash ^ hash >> 33) * 0xff51afd7ed558ccdu;
  hash ^= hash >> 33;
  return fmt::format("r{:012x}", hash >> 16);
}

}  // namespace pliant::batch
