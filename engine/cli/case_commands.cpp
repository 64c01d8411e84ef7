#include "engine/cli/commands.hpp"
#include "engine/cli/new_case.hpp"

namespace pliant::cli {

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

namespace {

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
  command.add_flag("--quiet", arguments->quiet,
                   "show neither progress nor measurements, only warnings");
  command.add_flag("--report", arguments->report,
                   "end with `pliant report`: a page that shows the run in a browser");
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

void add_check(Commands& commands) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App& command = commands.add("check", "Check a case and estimate its cost",
                                   "check cases/rotating_cylinder", arguments, &check);
  add_case(command, arguments->source);
  command.add_flag("--json", arguments->json, "print JSON");
}

void add_list(Commands& commands) {
  const auto arguments = std::make_shared<ListArguments>();
  CLI::App& command =
      commands.add("list", "List the cases of a folder", "list cases", arguments, &list);
  command.add_option("FOLDER", arguments->folder, "folder with one folder per case")
      ->type_name("")
      ->capture_default_str();
  command.add_flag("--json", arguments->json, "print JSON");
}

void add_new(Commands& commands) {
  const auto arguments = std::make_shared<NewArguments>();
  CLI::App& command =
      commands.add("new", "Write a commented case as a start", "new my_case", arguments, &new_case);
  command.add_option("NAME", arguments->folder, "name of the case: a folder that is made for it")
      ->required()
      ->type_name("");
  command.add_option("--from", arguments->from, "copy this case, with its mesh files")
      ->type_name("CASE");
}

}  // namespace

void add_case_commands(Commands& commands) {
  add_run(commands);
  add_check(commands);
  add_list(commands);
  add_new(commands);
  add_graph(commands);
  commands.add("reference", "Print the reference of case files", "reference > case-reference.md",
               std::make_shared<NoArguments>(), &reference);
}

}  // namespace pliant::cli
