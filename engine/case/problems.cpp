#include "engine/case/problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace pliant {
namespace {

Place place_in(const toml::source_region& source) {
  Place place;
  if (source.path) place.file = *source.path;
  if (!place.file.starts_with(setting_mark)) place.line = source.begin.line;
  return place;
}

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> distance(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        distance[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      distance[i][j] = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
    }
  }
  return distance[a.size()][b.size()];
}

}  // namespace

std::string Place::text() const { return line == 0 ? file : fmt::format("{}:{}", file, line); }

Place place_of(const toml::node& node) { return place_in(node.source()); }
Place place_of(const toml::key& key) { return place_in(key.source()); }

void Problems::add(const Place& place, std::string_view what, std::string_view remedy) {
  const std::string sentence = fmt::format("{}: {}; {}", place.text(), what, remedy);
  for (const Problem& problem : problems_) {
    if (problem.sentence == sentence) return;
  }
  problems_.push_back({place, sentence});
}

std::string Problems::text() const {
  std::vector<Problem> ordered = problems_;
  std::stable_sort(ordered.begin(), ordered.end(), [](const Problem& a, const Problem& b) {
    const bool setting_a = a.place.line == 0, setting_b = b.place.line == 0;
    return std::tie(setting_a, a.place.line) < std::tie(setting_b, b.place.line);
  });
  std::string text;
  for (const Problem& problem : ordered) {
    if (!text.empty()) text += '\n';
    text += problem.sentence;
  }
  return text;
}

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("the text \"{}\"", text->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

std::string_view nearest_word(std::string_view given, const std::vector<std::string_view>& known) {
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(1, given.size() / 3) + 1;
  for (const std::string_view word : known) {
    const std::size_t distance = edit_distance(given, word);
    if (distance >= best_distance) continue;
    best = word;
    best_distance = distance;
  }
  if (!best.empty() || given.size() < 3) return best;
  const auto begins = [given](std::string_view word) { return word.starts_with(given); };
  const auto longer = std::find_if(known.begin(), known.end(), begins);
  return longer == known.end() ? best : *longer;
}

std::string suggestion(std::string_view given, const std::vector<std::string_view>& known,
                       std::string_view otherwise) {
  const std::string_view nearest = nearest_word(given, known);
  if (!nearest.empty()) return fmt::format("did you mean `{}`?", nearest);
  return fmt::format("{} {}", otherwise, fmt::join(known, ", "));
}

}  // namespace pliant
