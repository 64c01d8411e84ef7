#pragma once

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <string_view>
#include <vector>

#include "engine/case/problems.hpp"

namespace pliant {

/// The position of the element called `name` in a list of the case. Throws InputError that lists
/// the names.
template <class List>
std::size_t find(const List& list, std::string_view name, std::string_view what) {
  const auto found =
      std::ranges::find(list, name, [](const auto& element) { return element.name; });
  if (found != list.end()) return found - list.begin();
  std::vector<std::string_view> known;
  known.reserve(list.size());
  for (const auto& element : list) known.push_back(element.name);
  throw InputError(fmt::format("the case has no {} `{}`; {}", what, name,
                               known.empty() ? "it has none" : suggestion(name, known, "it has")));
}

}  // namespace pliant
