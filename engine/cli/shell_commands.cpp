#include "engine/cli/shell_commands.hpp"

#include <fmt/format.h>

#include "engine/cli/completion.hpp"
#include "engine/cli/manual.hpp"

namespace pliant::cli {

namespace {

ExitStatus print_completion(const CLI::App& app, const std::string& shell) {
  const CommandModel program = model_of(app);
  fmt::print("{}", shell == "bash"  ? bash_completion(program)
                   : shell == "zsh" ? zsh_completion(program)
                                    : fish_completion(program));
  return ExitStatus::done;
}

void add_completion(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand(
      "completion", "Print a script that completes the command line in a shell");
  command.group("Commands");
  command.footer(
      "An installed pliant includes these scripts. Without installation:\n  source <(pliant "
      "completion bash)\n"
      "  pliant completion fish > ~/.config/fish/completions/pliant.fish");
  const auto shell = std::make_shared<std::string>();
  command.add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("");
  // The app only lives during `read_command_line`, so this runs here and not in `chosen`.
  command.callback([&commands, shell] {
    const ExitStatus status = print_completion(commands.app, *shell);
    commands.chosen = [status] { return status; };
  });
}

void add_manual(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("manual", "Print the manual page for `man`");
  command.group("Commands");
  command.footer("Example:\n  pliant manual > pliant.1 && man ./pliant.1");
  command.callback([&commands] {
    fmt::print("{}", manual_page(model_of(commands.app)));
    commands.chosen = [] { return ExitStatus::done; };
  });
}

}  // namespace

void add_shell_commands(Commands& commands) {
  commands.add("schema", "Print the JSON Schema of case files", "schema > case.schema.json",
               std::make_shared<NoArguments>(), &schema);
  add_completion(commands);
  add_manual(commands);
}

}  // namespace pliant::cli
