#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <cmath>
#include <numeric>

#include "engine/batch/outcome.hpp"
#include "engine/batch/slurm/attempt.hpp"
#include "engine/batch/slurm/tasks.hpp"
#include "engine/output/summary.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

using namespace batch;
using namespace batch::slurm;
using Sizes = std::vector<std::size_t>;

TEST(slurm_tasks, have_as_many_runs_as_the_user_says) {
  EXPECT_EQ(grouped(std::vector<double>(50, 3.0), 5, 600, 16, 1000), Sizes(10, 5));
  EXPECT_EQ(grouped(std::vector<double>(7, 3.0), 3, 600, 16, 1000), (Sizes{3, 3, 1}));
}

TEST(slurm_tasks, take_about_the_time_that_is_given) {
  EXPECT_EQ(grouped(std::vector<double>(1000, 60.0), 0, 600, 16, 1000), Sizes(100, 10));
  EXPECT_EQ(grouped({1000, 1000}, 0, 600, 1, 1000), (Sizes{1, 1}));
}

TEST(slurm_tasks, of_short_runs_are_enough_to_fill_the_workers) {
  EXPECT_EQ(grouped(std::vector<double>(64, 0.1), 0, 600, 16, 1000), Sizes(16, 4));
  EXPECT_EQ(grouped(std::vector<double>(3, 0.1), 0, 600, 16, 1000), Sizes(3, 1));
}

TEST(slurm_tasks, are_never_more_than_an_array_may_have) {
  for (const int runs_per_task : {0, 1}) {
    std::vector<double> seconds(12345);
    std::iota(seconds.begin(), seconds.end(), 1.0);
    const Sizes sizes = grouped(seconds, runs_per_task, 600, 16, 1000);
    EXPECT_LE(sizes.size(), 1000u);
    EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), seconds.size());
  }
}

TEST(slurm_task_file, holds_what_was_put_into_it) {
  const TemporaryFolder folder;
  Waiting run;
  run.name = "r1";
  run.attempts = 2;
  run.attempts_left = 3;
  write_task(folder.path(), 7, {1.5, {{run, {"pliant", "run", "a b"}}}});
  const TaskFile task = read_task(folder.path(), 7);
  EXPECT_EQ(task.time_limit, 1.5);
  ASSERT_EQ(task.runs.size(), 1u);
  EXPECT_EQ(task.runs[0].run.name, "r1");
  EXPECT_EQ(task.runs[0].run.attempts, 2);
  EXPECT_EQ(task.runs[0].run.attempts_left, 3);
  EXPECT_EQ(task.runs[0].command, (std::vector<std::string>{"pliant", "run", "a b"}));
  EXPECT_THROW(read_task(folder.path(), 8), InputError);
}

// As if the node is lost after a run is done, but before its task has recorded the outcome.
TEST(run_outcome, of_a_process_that_nobody_waited_for_is_whole) {
  const TemporaryFolder folder;
  Summary summary;
  summary.wall_time = 2.5;
  summary.processor_time = 4.75;
  summary.peak_memory = 123456789012;
  write_summary(folder.path(), summary);
  Outcome outcome;
  ASSERT_TRUE(read_summary(folder.path(), outcome));
  EXPECT_EQ(outcome.wall_seconds, 2.5);
  EXPECT_EQ(outcome.processor_seconds, 4.75);
  EXPECT_EQ(outcome.peak_memory, 123456789012);
}

TEST(slurm_attempt_file, holds_what_was_put_into_it) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_attempt(folder / "r1").has_value());
  Attempt attempt;
  attempt.row.status = RunStatus::failed;
  attempt.row.attempts = 4;
  attempt.row.started = 1.25e9;
  attempt.row.ended = std::nan("");
  attempt.row.outcome.exit_status = 139;
  attempt.row.outcome.message = "ended by signal 11 \xff";  // not UTF-8
  attempt.row.outcome.peak_memory = 123456789012;
  attempt.attempts_left = 2;
  write_attempt(folder / "r1", attempt);
  const Attempt found = read_attempt(folder / "r1").value();
  EXPECT_EQ(found.row.name, "r1");
  EXPECT_EQ(found.row.status, RunStatus::failed);
  EXPECT_EQ(found.row.attempts, 4);
  EXPECT_EQ(found.row.started, 1.25e9);
  EXPECT_TRUE(std::isnan(found.row.ended));
  EXPECT_EQ(found.row.outcome.exit_status, 139);
  EXPECT_EQ(found.row.outcome.message.substr(0, 18), "ended by signal 11");
  EXPECT_EQ(found.row.outcome.peak_memory, 123456789012);
  EXPECT_EQ(found.attempts_left, 2);
}

}  // namespace
}  // namespace pliant::test
