#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The commands of Slurm.
namespace pliant::batch::slurm {

/// A task of a job array: name of the job and index.
using TaskId = std::pair<std::string, int>;

/// Words of squeue, such as "PENDING".
using States = std::map<TaskId, std::string>;

struct Request {
  std::string name;
  int tasks = 1;
  int at_once = 0;  ///< tasks that may run at the same time; 0: any number
  int threads = 1;
  double bytes = 0;
  double seconds = 0;  ///< of the longest task; 0: unknown
  std::filesystem::path script;
  std::filesystem::path log;         ///< `%a` is replaced by the index of the task
  std::vector<std::string> options;  ///< further options of sbatch
};

/// Throws InputError if Slurm is missing or refuses the array.
void submit(const Request& request);

/// The largest number of tasks in an array.
int most_tasks();

/// States of all tasks of these jobs that Slurm still knows; none if it does not answer.
std::optional<States> states_of(const std::vector<std::string>& jobs);

/// Removes waiting tasks, and sends SIGTERM to running ones.
void cancel(const std::string& job);

/// Whether a task in this state neither runs nor waits.
bool is_over(const std::string& state);

}  // namespace pliant::batch::slurm
