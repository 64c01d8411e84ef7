#include "engine/report/batch_report.hpp"

#include <gtest/gtest.h>

#include "engine/batch/ledger.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/report/page_content.hpp"

namespace pliant::test {
namespace {

using namespace batch;

TEST(batch_report, a_page_holds_parameters_and_measurements_of_all_runs) {
  const TemporaryFolder folder;
  Ledger ledger(folder.path(), Ledger::Use::write);
  ledger.add({{{"time.end", "1"}, {"method", "\"remeshed\""}},
              {{"time.end", "2"}, {"method", "\"sph\""}}});
  const auto first = ledger.rows().at(0).name;
  Outcome outcome;
  outcome.exit_status = 0;
  outcome.measurements = {{"tip", "m", 0.25}};
  ledger.start(first);
  ledger.end(first, RunStatus::done, outcome);
  report::write_batch_report(folder.path(), folder / "report.html");
  const auto page = content_of_page(folder / "report.html");
  EXPECT_EQ(page.run["runs"].size(), 2u);
  EXPECT_EQ(page.run["runs"][0]["measurements"]["tip"], 0.25);
  EXPECT_EQ(page.run["measurements"][0]["unit"], "m");
  EXPECT_EQ(page.run["parameters"][0]["label"], "time.end");
  EXPECT_EQ(page.run["parameters"][1]["words"].size(), 2u) << "words have places of their own";
  EXPECT_EQ(page.run["notes"][0], "1 runs are not done and have no points.");
}

}  // namespace
}  // namespace pliant::test
