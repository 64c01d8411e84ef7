#include "engine/cli/batch_commands.hpp"

#include "engine/cli/batch.hpp"
#include "engine/cli/calibrate.hpp"

namespace pliant::cli {

namespace {

void add_options_of_runs(CLI::App& command, RunsArguments& arguments, const char* out,
                         const char* resume) {
  command.add_option("--out", arguments.folder, out)->type_name("FOLDER");
  command
      .add_option("--executor", arguments.executor,
                  "where runs are executed: on this machine, or as job arrays of Slurm")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  command
      .add_option("--workers", arguments.workers,
                  "runs at the same time (default and maximum: processors / threads)")
      ->type_name("N");
  command.add_option("--threads", arguments.threads, "threads of each run")
      ->type_name("N")
      ->capture_default_str();
  command.add_flag("--resume", arguments.resume, resume);
  command.add_flag("--quiet", arguments.quiet, "show no progress");
}

void add_ledger_command(Commands& commands, CLI::App& parent, const char* name,
                        const char* description, bool has_json,
                        ExitStatus (*action)(const LedgerArguments&)) {
  const auto arguments = std::make_shared<LedgerArguments>();
  CLI::App& command = *parent.add_subcommand(name, description);
  command.add_option("FOLDER", arguments->folder, "folder of the batch")->required()->type_name("");
  if (has_json) command.add_flag("--json", arguments->json, "print all runs as JSON");
  command.footer(std::string("Example:\n  pliant batch ") + name + " results/sweep");
  command.callback([&commands, arguments, action] {
    commands.chosen = [arguments, action] { return action(*arguments); };
  });
}

/// For job scripts, not for users.
void add_task_command(Commands& commands, CLI::App& parent) {
  const auto arguments = std::make_shared<TaskArguments>();
  CLI::App& command = *parent.add_subcommand("task", "Do the runs of a task of a job array");
  command.group("");
  command.add_option("FOLDER", arguments->array, "folder of the array")->required();
  command.add_option("INDEX", arguments->index, "number of the task")->required();
  command.callback(
      [&commands, arguments] { commands.chosen = [arguments] { return batch_task(*arguments); }; });
}

void add_batch(Commands& commands) {
  const auto arguments = std::make_shared<BatchArguments>();
  CLI::App& command = *commands.app.add_subcommand("batch", "Run a case with many parameters");
  command.group("Commands");
  command.footer(
      "Exit status: 0 all runs are done, 3 some have failed; else as for other commands."
      "\n\nExamples:\n  pliant batch sweep.toml --out results/sweep --workers 2\n"
      "  pliant batch sweep.toml --executor slurm --resume\n"
      "  pliant batch status results/sweep\n"
      "  pliant batch export results/sweep > runs.csv");
  command.add_option("SWEEP", arguments->sweep, "file that lists the parameters and their values")
      ->type_name("");
  add_options_of_runs(command, *arguments, "folder for the runs (default: results/<sweep>)",
                      "run only what is missing or has failed");
  add_ledger_command(commands, command, "status", "Show the progress of a batch", true,
                     &batch_status);
  add_ledger_command(commands, command, "export", "Print all runs as CSV", false, &batch_export);
  add_task_command(commands, command);
  command.callback([&commands, &command, arguments] {
    if (!command.get_subcommands().empty()) return;  // a subcommand has set `chosen`
    if (arguments->sweep.empty()) throw CLI::RequiredError("SWEEP");
    commands.chosen = [arguments] { return batch(*arguments); };
  });
}

void add_calibrate(Commands& commands) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App& command = commands.add(
      "calibrate", "Find the parameter values that reproduce measured curves",
      "calibrate fit.toml --out results/fit\n\nExit status: 1 if it has not converged.", arguments,
      &calibrate);
  command.add_option("FIT", arguments->fit, "file that names the case, parameters and curves")
      ->required()
      ->type_name("");
  add_options_of_runs(command, *arguments, "folder for the runs (default: results/<fit>)",
                      "keep the runs in the folder");
  command.add_flag("--json", arguments->json, "print the result as JSON");
}

}  // namespace

void add_batch_commands(Commands& commands) {
  add_batch(commands);
  add_calibrate(commands);
}

}  // namespace pliant::cli
