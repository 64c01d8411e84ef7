#include "engine/batch/ledger.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/output/error.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

using namespace batch;

const Assignment first = {{"a", "1"}, {"b", "x y"}}, second = {{"a", "2"}, {"b", "z"}};

TEST(ledger, holds_what_was_put_into_it) {
  const TemporaryFolder folder;
  EXPECT_FALSE(Ledger::exists(folder.path()));
  Outcome outcome;
  outcome.exit_status = 0;
  outcome.wall_seconds = 1.5;
  outcome.processor_seconds = 3;
  outcome.peak_memory = 123456789012;
  outcome.measurements = {{"force", "N", 0.1}, {"period", "s", std::nan("")}};
  outcome.versions = {{"pliant", "0.1.0"}};
  {
    Ledger ledger(folder.path(), Ledger::Use::write);
    ledger.add({first, second});
    ledger.set("case", "text");
    ledger.start(name_of(first));
    ledger.end(name_of(first), RunStatus::done, outcome);
  }
  ASSERT_TRUE(Ledger::exists(folder.path()));
  Ledger ledger(folder.path(), Ledger::Use::read);
  EXPECT_EQ(ledger.get("case"), "text");
  EXPECT_EQ(ledger.get("other"), std::nullopt);
  const auto rows = ledger.rows();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].parameters, first);
  EXPECT_EQ(rows[0].status, RunStatus::done);
  EXPECT_EQ(rows[0].attempts, 1);
  EXPECT_EQ(rows[0].outcome.exit_status, 0);
  EXPECT_EQ(rows[0].outcome.wall_seconds, 1.5);
  EXPECT_EQ(rows[0].outcome.peak_memory, 123456789012);
  ASSERT_EQ(rows[0].outcome.measurements.size(), 2u);
  EXPECT_EQ(rows[0].outcome.measurements[0].value, 0.1);
  EXPECT_TRUE(std::isnan(rows[0].outcome.measurements[1].value));
  EXPECT_EQ(rows[0].outcome.versions, outcome.versions);
  EXPECT_LE(rows[0].started, rows[0].ended);
  EXPECT_EQ(rows[1].status, RunStatus::pending);
  EXPECT_EQ(rows[1].outcome.exit_status, std::nullopt);
}

TEST(ledger, keeps_what_it_has_when_runs_are_added) {
  const TemporaryFolder folder;
  Ledger ledger(folder.path(), Ledger::Use::write);
  ledger.add({second});
  ledger.start(name_of(second));
  ledger.add({first, second});
  const auto rows = ledger.rows();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].name, name_of(second));
  EXPECT_EQ(rows[0].attempts, 1);
  EXPECT_EQ(rows[0].parameters, second);
}

TEST(ledger, takes_runs_that_were_at_work_as_pending_again) {
  const TemporaryFolder folder;
  Ledger ledger(folder.path(), Ledger::Use::write);
  ledger.add({first});
  ledger.start(name_of(first));
  EXPECT_EQ(ledger.rows()[0].status, RunStatus::running);
  ledger.reset_running();
  EXPECT_EQ(ledger.rows()[0].status, RunStatus::pending);
}

TEST(ledger, takes_what_other_processes_say_of_an_attempt) {
  const TemporaryFolder folder;
  Ledger ledger(folder.path(), Ledger::Use::write);
  ledger.add({first});
  RunRow row = ledger.rows()[0];
  row.status = RunStatus::failed;
  row.attempts = 3;
  row.started = 10;
  row.ended = 20;
  row.outcome.exit_status = 137;
  row.outcome.message = "ended by signal 9";
  ledger.put(row);
  const RunRow found = ledger.rows()[0];
  EXPECT_EQ(found.status, RunStatus::failed);
  EXPECT_EQ(found.attempts, 3);
  EXPECT_EQ(found.started, 10);
  EXPECT_EQ(found.ended, 20);
  EXPECT_EQ(found.outcome.exit_status, 137);
  EXPECT_EQ(found.outcome.message, "ended by signal 9");
}

TEST(ledger, that_is_no_database_is_refused_with_its_path) {
  const TemporaryFolder folder;
  std::ofstream(folder / "batch.sqlite") << std::string(5000, 'x');
  try {
    Ledger(folder.path(), Ledger::Use::read).rows();
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_NE(std::string(error.what()).find("batch.sqlite"), std::string::npos);
  }
}

}  // namespace
}  // namespace pliant::test
