#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/batch/slurm/queue.hpp"
#include "engine/batch/work.hpp"

// Each submission is a job array with its own folder, DIR/slurm/1 and so on. Its name follows from
// this folder, so that a process that continues the batch finds its tasks by name, even if the
// submitting process was killed.
namespace pliant::batch::slurm {

/// The folders of the arrays of a batch, in order.
std::vector<std::filesystem::path> arrays_in(const std::filesystem::path& batch);

/// The name of the job of an array.
std::string job_of(const std::filesystem::path& array);

/// A task of Slurm, with those of its runs that are not settled.
struct Task {
  std::filesystem::path array;
  TaskId id;
  std::vector<Waiting> runs;
  bool has_begun = false;    ///< whether one of its runs has begun
  double seconds_over = -1;  ///< time when its end was noticed; negative: not yet
};

/// Submits all waiting runs as one array, with many short runs in each task. Throws InputError if
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
  double rate_ = -1;  ///< seconds per particle and step; 0: unknowable, -1: not yet
};

}  // namespace pliant::batch::slurm
