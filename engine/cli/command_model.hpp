#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// The command line for completions and the manual page, from CLI11's declaration.
namespace pliant::cli {

/// How the value of an option or an argument is completed.
enum class Completion { none, files, folders, words };

struct OptionModel {
  std::vector<std::string> names;  ///< "-h", "--help"; empty for an argument
  std::string argument;            ///< name of an argument, such as CASE
  std::string value;               ///< for example FOLDER in --out FOLDER; empty for a flag
  std::string description;
  bool required = false;
  bool repeatable = false;
  Completion completion = Completion::none;
  std::vector<std::string> words;  ///< possible values

  const std::string& longest_name() const { return names.back(); }
};

struct CommandModel {
  std::string name, description, footer;
  std::vector<OptionModel> options, arguments;
  std::vector<CommandModel> commands;
};

/// The model of `app`. `arguments` that name a command complete with the names of its commands.
CommandModel model_of(const CLI::App& app);

}  // namespace pliant::cli
