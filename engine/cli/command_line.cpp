#include "engine/cli/command_line.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>
#include <pliant/version.hpp>

#include <algorithm>
#include <iterator>
#include <memory>

#include "engine/case/problems.hpp"
#include "engine/cli/batch_commands.hpp"
#include "engine/cli/commands.hpp"
#include "engine/cli/report_command.hpp"
#include "engine/cli/shell_commands.hpp"

namespace pliant::cli {
namespace {

std::vector<const CLI::App*> all_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

InputError unknown_command(const CLI::App& app, const std::string& given) {
  std::vector<std::string> kept;
  std::ranges::transform(all_commands(app), std::back_inserter(kept),
                         [](const CLI::App* command) { return command->get_name(); });
  const std::vector<std::string_view> names(kept.begin(), kept.end());
  return InputError(fmt::format("pliant {}: no such command; {}", given,
                                suggestion(given, names, "the commands are")));
}

void add_help(Commands& commands) {
  CLI::App& app = commands.app;
  CLI::App& command = *app.add_subcommand("help", "Explain a command");
  command.group("Commands");
  command.footer("Example:\n  pliant help run");
  const auto explained = std::make_shared<std::string>();
  command.add_option("COMMAND", *explained, "the command to explain")->type_name("");
  command.callback([&commands, &app, explained] {
    const auto known = all_commands(app);
    const auto about = std::ranges::find_if(
        known, [&](const CLI::App* one) { return one->get_name() == *explained; });
    if (!explained->empty() && about == known.end()) {
      throw unknown_command(app, *explained);
    }
    // App::help() of the program itself would explain the given command, `help`.
    const std::string text = explained->empty() ? app.get_formatter()->make_help(
                                                      &app, "pliant", CLI::AppFormatMode::Normal)
                                                : (*about)->help("pliant");
    fmt::print("{}", text);
    commands.chosen = [] { return ExitStatus::done; };
  });
}

void add_commands(Commands& commands) {
  CLI::App& app = commands.app;
  app.set_version_flag("--version", "pliant " + std::string(version), "Print the version");
  app.set_help_flag("-h,--help", "Print this help; `pliant help COMMAND` explains a command");
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->label("Positionals", "Arguments");
  app.get_formatter()->label("REQUIRED", "");
  app.require_subcommand(1);
  // refuse_repetitions gives a better message than CLI11.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);

  add_case_commands(commands);
  add_measuring_commands(commands);
  add_batch_commands(commands);
  add_report_command(commands);
  add_shell_commands(commands);
  add_help(commands);
}

/// The message of CLI11 in the words of this program: options that CLI11 converts take numbers.
std::string reason(const CLI::ParseError& error) {
  std::string text = error.what();
  constexpr std::string_view conversion = "Could not convert: ";
  if (!text.starts_with(conversion)) return text;
  return text.substr(conversion.size()) + " is not a number in the range of this option";
}

/// CLI11's error as a sentence that names the command; for an unknown option, with the nearest one.
InputError explained(const CLI::App& app, const CLI::ParseError& error) {
  const auto given = app.get_subcommands();
  const CLI::App& command = given.empty() ? app : *given.front();
  const std::string name = given.empty() ? "pliant" : "pliant " + command.get_name();
  const std::string help =
      given.empty() ? "`pliant help` explains the commands"
                    : fmt::format("`pliant help {}` explains its options", command.get_name());
  for (const std::string& extra : app.remaining(true)) {
    if (!extra.starts_with("-")) continue;
    std::vector<std::string> options;
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& long_name : option->get_lnames()) options.push_back("--" + long_name);
    }
    const std::vector<std::string_view> known(options.begin(), options.end());
    return InputError(
        fmt::format("{}: there is no option {}; {}", name, extra,
                    suggestion(extra.substr(0, extra.find('=')), known, "the options are")));
  }
  if (const auto extras = app.remaining(true); !extras.empty())
    return InputError(
        fmt::format("{}: one argument too many, `{}`; {}", name, extras.back(), help));
  return InputError(fmt::format("{}: {}; {}", name, reason(error), help));
}

/// Throws InputError for an option that is given twice, since it is unclear which one should count.
void refuse_repetitions(const CLI::App& app, const std::string& name) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_multi_option_policy() != CLI::MultiOptionPolicy::TakeLast) continue;
    if (option->count() < 2) continue;
    throw InputError(fmt::format("{}: {} is given {} times; give it once", name, option->get_name(),
                                 option->count()));
  }
  for (const CLI::App* command : app.get_subcommands()) {
    refuse_repetitions(*command, name + " " + command->get_name());
  }
}

}  // namespace

std::function<ExitStatus()> read_command_line(int argc, const char* const* argv) {
  Commands commands;
  add_commands(commands);
  CLI::App& app = commands.app;
  if (argc < 2) {
    throw InputError("pliant: no command is given; `pliant help` lists them");
  }
  const std::string first = argv[1];
  const auto is_first = [&](const CLI::App* command) { return command->get_name() == first; };
  if (!first.starts_with("-") && std::ranges::none_of(all_commands(app), is_first)) {
    throw unknown_command(app, first);
  }
  try {
    app.parse(argc, argv);
    refuse_repetitions(app, "pliant");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw explained(app, error);
    app.exit(error);
    return [] { return ExitStatus::done; };
  }
  return commands.chosen;
}

}  // namespace pliant::cli
