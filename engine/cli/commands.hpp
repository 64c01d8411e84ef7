#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

#include "engine/cli/actions.hpp"

/// The commands of the program, declared with CLI11.
namespace pliant::cli {

/// Each command adds itself to `app`, and sets `chosen` to its action when it is given.
struct Commands {
  CLI::App app{"Simulates elastic solids and soft tissue with particles.", "pliant"};
  std::function<ExitStatus()> chosen;

  template <class Arguments>
  CLI::App& add(const char* name, const char* description, const char* example,
                std::shared_ptr<Arguments> arguments, ExitStatus (*action)(const Arguments&)) {
    CLI::App& command = *app.add_subcommand(name, description);
    command.group("Commands");
    command.footer(std::string("Example:\n  pliant ") + example);
    command.callback(
        [this, arguments, action] { chosen = [arguments, action] { return action(*arguments); }; });
    return command;
  }
};

/// Commands that read, run and explain cases.
void add_case_commands(Commands& commands);
/// Commands that measure speed.
void add_measuring_commands(Commands& commands);

/// The argument CASE and the option --set.
void add_case(CLI::App& command, CaseArguments& arguments);

}  // namespace pliant::cli
