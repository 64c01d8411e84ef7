#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/waiting.hpp"

/// The runs of a task of a job array, as a file.
namespace pliant::batch::slurm {

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
/// Throws InputError if the task does not exist.
TaskFile read_task(const std::filesystem::path& array, int index);

/// The number of runs in each task, in order; `seconds_of_runs` are their durations. A task has
/// `runs_per_task` runs. If that is 0, it has about `seconds` of work, but no more than leaves at
/// least `least_tasks`. There are at most `most_tasks`.
std::vector<std::size_t> grouped(const std::vector<double>& seconds_of_runs, int runs_per_task,
                                 double seconds, int least_tasks, int most_tasks);

}  // namespace pliant::batch::slurm
