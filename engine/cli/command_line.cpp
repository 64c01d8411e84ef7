#include "engine/cli/command_line.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>
#include <pliant/version.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>

#include "engine/case/problems.hpp"

namespace pliant::cli {
namespace {

using Chosen = std::function<ExitStatus()>;

/// Each command adds itself to `app`, and says in `chosen` what it does when it is given.
struct Commands {
  CLI::App app{"Simulates elastic solids and soft tissue with particles.", "pliant"};
  Chosen chosen;

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

void add_case(CLI::App& command, CaseArguments& arguments) {
  command.add_option("CASE", arguments.path, "case file, or folder with a case.toml")
      ->required()
      ->type_name("");
  command
      .add_option("--set", arguments.settings,
                  "override a key of the case; may be given several times,\n"
                  "as in --set discretisation.spacing=0.01 --set time.end=2")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_run(Commands& commands) {
  const auto arguments = std::make_shared<RunArguments>();
  CLI::App& command = commands.add(
      "run", "Run a case and write its results",
      "run cases/rotating_cylinder --set time.end=0.1 --out results/short", arguments, &run);
  add_case(command, arguments->source);
  command
      .add_option("--out", arguments->folder, "folder for the results (default: results/<case>)")
      ->type_name("FOLDER");
  command
      .add_option("--threads", arguments->threads, "worker threads (default: one per processor)")
      ->type_name("N");
  command
      .add_option("--isa", arguments->isa,
                  "instruction set: sse2, avx2 or avx512 (default: widest supported)")
      ->type_name("NAME");
  command.add_flag("--resume", arguments->resume,
                   "continue from the last checkpoint in the folder;\n"
                   "time.end may be later than it was");
  command.add_flag("--force", arguments->force, "run even if the memory may not suffice");
  command.add_flag("--quiet", arguments->quiet, "show neither progress nor measurements");
}

void add_graph(Commands& commands) {
  const auto arguments = std::make_shared<GraphArguments>();
  CLI::App& command =
      commands.add("graph", "Print the step graph of a case",
                   "graph cases/rotating_cylinder | dot -Tsvg > step.svg", arguments, &graph);
  add_case(command, arguments->source);
  command.add_option("--format", arguments->format, "how to write the graph")
      ->check(CLI::IsMember({"dot", "json"}))
      ->type_name("NAME")
      ->capture_default_str();
  command.add_flag("--blocks", arguments->blocks, "one node for each phase and block (dot only)");
}

void add_bench(Commands& commands) {
  const auto arguments = std::make_shared<BenchArguments>();
  CLI::App& command =
      commands.add("bench", "Measure this machine and the speed of the program on it",
                   "bench --quick --csv speed.csv", arguments, &bench);
  command.add_flag("--quick", arguments->quick,
                   "fewer repetitions, and no more than 131 072 particles");
  command
      .add_option("--ball", arguments->ball, "measure only spinning balls of this many particles")
      ->check(CLI::Range(1000, 100'000'000))
      ->type_name("N");
  command.add_option("--csv", arguments->csv, "write all figures to this file")->type_name("FILE");
  command
      .add_option("--threads", arguments->threads,
                  "threads to compare with one (default: one per processor)")
      ->type_name("N");
}

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
    // App::help() of the program itself would explain `help`, the command that was given.
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
  // A wrapper script or an alias may give an option that its user gives again.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);

  add_run(commands);
  const auto checked = std::make_shared<CaseArguments>();
  add_case(commands.add("check", "Check a case and say what it would run",
                        "check cases/rotating_cylinder", checked, &check),
           *checked);
  const auto folder = std::make_shared<std::filesystem::path>("cases");
  commands.add("list", "List the cases of a folder", "list cases", folder, &list)
      .add_option("FOLDER", *folder, "folder with one folder per case")
      ->type_name("")
      ->capture_default_str();
  add_graph(commands);
  add_bench(commands);
  commands.add("reference", "Print the reference of case files", "reference > case-reference.md",
               std::make_shared<NoArguments>(), &reference);
  add_help(commands);
}

/// CLI11's error as a sentence that names the command, with the nearest option for one that does
/// not exist.
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
  return InputError(fmt::format("{}: {}; {}", name, error.what(), help));
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
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw explained(app, error);
    app.exit(error);
    return [] { return ExitStatus::done; };
  }
  return commands.chosen;
}

}  // namespace pliant::cli
