#include "engine/cli/report_command.hpp"

#include "engine/cli/report.hpp"

namespace pliant::cli {

void add_report_command(Commands& commands) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App& command = commands.add("report", "Show a run or a batch in a browser",
                                   "report results/organ", arguments, &report);
  command.add_option("FOLDER", arguments->folder, "folder of a run or of a batch")
      ->required()
      ->type_name("");
  command
      .add_option("--out", arguments->page, "file to write (default: report.html in the folder)")
      ->type_name("FILE");
  command
      .add_option("--field", arguments->fields,
                  "field to show, as in velocity or velocity_y; may be given more than once")
      ->type_name("NAME")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  command
      .add_option("--reference", arguments->reference,
                  "curves over time to lay over the measurements (default: "
                  "cases/<case>/reference.csv, if there is one)")
      ->type_name("CSV");
}

}  // namespace pliant::cli
