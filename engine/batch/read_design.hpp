#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/batch/designs.hpp"
#include "engine/case/problems.hpp"

/// Reads one `[[design]]` of a sweep file; also helpers for the other parts of such files.
namespace pliant::batch {

/// The runs of a design; tables are files in `folder`. Throws InputError.
std::vector<Assignment> read_design(const toml::table& design, const std::filesystem::path& folder);

/// Throws InputError with the line of the node.
[[noreturn]] void refuse(const toml::node& node, const std::string& what,
                         const std::string& remedy);

void refuse_other_keys(const toml::table& table, const std::vector<std::string_view>& known);

/// Reads a TOML file; messages call it `kind`. Throws InputError.
toml::table read_toml(const std::filesystem::path& file, std::string_view kind);

/// The texts of a list; empty if the key does not exist. Throws InputError with `example` as the
/// remedy.
std::vector<std::string> texts_of(const toml::table& table, std::string_view key,
                                  const std::string& example);

/// The value of a key, or `otherwise` if it does not exist. Throws InputError if it is not what is
/// `wanted`.
template <class T>
T value_of(const toml::table& table, std::string_view key, const T& otherwise,
           std::string_view wanted) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return otherwise;
  const std::optional<T> value = node->value<T>();
  if (!value) {
    refuse(*node, fmt::format("`{}` is {}", key, describe(*node)), fmt::format("give {}", wanted));
  }
  return *value;
}

}  // namespace pliant::batch
