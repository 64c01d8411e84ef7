#include "engine/cli/report.hpp"

#include <fmt/format.h>

#include "engine/batch/ledger.hpp"
#include "engine/report/batch_report.hpp"
#include "engine/report/report.hpp"

namespace pliant::cli {

ExitStatus report(const ReportArguments& arguments) {
  const auto& folder = arguments.folder;
  const auto page = arguments.page.value_or(folder / "report.html");
  if (batch::Ledger::exists(folder)) {
    report::write_batch_report(folder, page);
  } else {
    report::ReportOptions options;
    options.fields = arguments.fields;
    options.reference = arguments.reference;
    report::write_run_report(folder, page, options);
  }
  fmt::print("wrote {}; open it in a browser\n", page.string());
  return ExitStatus::done;
}

}  // namespace pliant::cli
