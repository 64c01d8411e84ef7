#include "engine/case/vocabulary/example.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pliant {

namespace {

std::vector<std::string> parts_of(std::string_view list) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(", ", begin), list.size());
    parts.emplace_back(list.substr(begin, end - begin));
    begin = end + 2;
  }
  return parts;
}

std::string fitted(std::string_view list, std::size_t dimension) {
  std::vector<std::string> parts = parts_of(list);
  while (parts.size() != dimension) {
    auto place = std::find(parts.begin(), parts.end(), "0");
    if (place == parts.end()) place = std::find(parts.begin(), parts.end(), "1");
    if (place == parts.end()) break;
    if (parts.size() < dimension) {
      parts.insert(place, *place);
    } else {
      parts.erase(place);
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

void replace(std::string& text, std::string_view what, std::string_view by) {
  const std::size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), by);
}

}  // namespace

std::string with_components(std::string_view example, int dimension) {
  std::string text;
  for (std::size_t at = 0; at < example.size();) {
    const std::size_t open = example.find('[', at);
    const std::size_t close = example.find(']', at);
    const bool is_list = close != std::string_view::npos && open < close;
    // A list of tables, such as shapes: its elements are processed one by one.
    const bool is_of_tables = is_list && example.substr(open, 2) == "[{";
    if (!is_list || is_of_tables) {
      const std::size_t next = is_of_tables ? open + 1 : example.size();
      text += example.substr(at, next - at);
      at = next;
      continue;
    }
    text += example.substr(at, open + 1 - at);
    text += fitted(example.substr(open + 1, close - open - 1), static_cast<std::size_t>(dimension));
    text += ']';
    at = close + 1;
  }
  if (dimension == 3) {
    replace(text, "\"disc\"", "\"ball\"");
    replace(text, "angular_velocity = 1", "angular_velocity = [0, 0, 1]");
    if (text == "\"2*pi\"") text = "[0, 0, \"2*pi\"]";
  }
  return text;
}

}  // namespace pliant
