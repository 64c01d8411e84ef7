#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "engine/cli/actions.hpp"

namespace pliant::cli {

/// The case that `pliant new` writes, new_case.toml, with @NAME@ in place of its name.
extern const std::string_view new_case_text;

struct NewArguments {
  std::filesystem::path folder;
  std::optional<std::filesystem::path> from;  ///< a case to copy
};

/// Writes a commented case into a new folder, or copies a case with its mesh files.
ExitStatus new_case(const NewArguments& arguments);

}  // namespace pliant::cli
