#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// The command line as completions and the manual page show it, taken from CLI11's declaration.
namespace pliant::cli {

/// What completes the value of an option or an argument.
enum class Completion { none, files, folders, words };

struct OptionModel {
  std::vector<std::string> names;  ///< "-h", "--help"; empty for an argument
  std::string argument;            ///< name of an argument, as CASE
  std::string value;               ///< as in --out FOLDER; empty for a flag
  std::string description;
  bool required = false;
  bool repeatable = false;
  Completion completion = Completion::none;
  std::vector<std::string> words;  ///< that the value may be

  const std::string& longest_name() const { return names.back(); }
};

struct CommandModel {
  std::string name, description, footer;
  std::vector<OptionModel> options, arguments;
  std::vector<CommandModel> commands;
};

/// `arguments` that name a command complete with the names of `app`'s commands.
CommandModel model_of(const CLI::App& app);

}  // namespace pliant::cli
