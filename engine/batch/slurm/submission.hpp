#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/batch/slurm/queue.hpp"
#include "engine/batch/work.hpp"

// Each submission is a job array with a folder of its own, DIR/slurm/1 and so on, and a name that
// follows from this folder: whoever continues the batch finds its tasks by their names, wherever
// the process that submitted them was killed.
namespace pliant::batch::slurm {

/// The folders of the arrays of a batch, in their order.
std::vector<std::filesystem::path> arrays_in(const std::filesystem::path& batch);

/// The name of the job of an array.
std::string job_of(const std::filesystem::path& array);

/// A task that Slurm has, with those of its runs that are not settled.
struct Task {
  std::filesystem::path array;
  TaskId id;
  std::vector<Waiting> runs;
  bool has_begun = false;    ///< one of its runs
  double seconds_over = -1;  ///< when it was seen to be over; negative: not yet
};

/// Submits all runs that wait as one array, with many short runs in a task. Throws InputError where
/// Slurm refuses it, and OutputError.
class Submission {
 public:
  explicit Submission(Work& work) : work_(work) {}

  std::vector<Task> operator()();

 private:
  double rate();
  double time_of(const Waiting& run);
  std::vector<std::size_t> sizes_of_tasks();
  Task next_task(int index, std::size_t runs, Request& request);

  Work& work_;
  std::filesystem::path array_ = {};
  double rate_ = -1;  ///< seconds for each particle and step; 0: cannot be known, -1: not yet
};

}  // namespace pliant::batch::slurm
