#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/waiting.hpp"

/// Which runs a task of a job array does, as a file.
namespace pliant::batch::slurm {

/// A run with the command that makes it.
struct TaskRun {
  Waiting run;  ///< without parameters
  std::vector<std::string> command;
};

struct TaskFile {
  double time_limit = 0;  ///< of an attempt [s]; 0: none
  std::vector<TaskRun> runs;
};

/// Throws OutputError.
void write_task(const std::filesystem::path& array, int index, const TaskFile& task);
/// Throws InputError where there is no such task.
TaskFile read_task(const std::filesystem::path& array, int index);

/// How many runs, of so many seconds each, go into each task, in their order. A task has
/// `runs_per_task`, or, where that is 0, about `seconds` but so few that there are `least_tasks`.
/// There are `most_tasks` at most.
std::vector<std::size_t> grouped(const std::vector<double>& seconds_of_runs, int runs_per_task,
                                 double seconds, int least_tasks, int most_tasks);

}  // namespace pliant::batch::slurm
