#include "engine/batch/slurm/submission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "engine/batch/slurm/tasks.hpp"
#include "engine/case/reading/read_case.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/simulation/estimate.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant::batch::slurm {

namespace {

constexpr double seconds_of_task =
    600;                         // short enough to share a cluster, long relative to its start
constexpr int usual_tasks = 16;  // for a sweep of short runs
// Estimates of time are right within a factor of two on this machine, and others may be slower.
constexpr double time_factor = 4, seconds_to_set_up = 20, seconds_to_start = 120;
constexpr double memory_factor = 1.25, bytes_of_worker = 1e8;  // estimates are right within a fifth

std::filesystem::path array_of(const std::filesystem::path& batch, std::size_t number) {
  return std::filesystem::absolute(batch / "slurm" / fmt::format("{}", number)).lexically_normal();
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

std::string script_of(const std::filesystem::path& program, const std::filesystem::path& array) {
  return fmt::format("#!/bin/sh\nexec {} batch task {} \"$SLURM_ARRAY_TASK_ID\"\n",
                     quoted(program.string()), quoted(array.string()));
}

}  // namespace

std::vector<std::filesystem::path> arrays_in(const std::filesystem::path& batch) {
  std::vector<std::filesystem::path> arrays;
  while (std::filesystem::exists(array_of(batch, arrays.size() + 1))) {
    arrays.push_back(array_of(batch, arrays.size() + 1));
  }
  return arrays;
}

std::string job_of(const std::filesystem::path& array) {
  return "pliant-" + name_of({{"array", array.string()}});
}

double Submission::rate() {
  if (rate_ >= 0) return rate_;
  const Waiting& run = work_.waiting.front();
  const Case first = read_case(work_.sweep().case_file, work_.settings_of(run.parameters));
  const auto seconds = estimated_seconds(first, estimate(first),
                                         solver_options(work_.options().threads, ""), methods());
  rate_ = seconds.value_or(0) / std::max(1.0, run.steps);
  return rate_;
}

/// The time that a task must allow for a run [s]; 0 if it is unknown.
double Submission::time_of(const Waiting& run) {
  const double limit = work_.sweep().time_limit * run.attempts_left;
  const double estimate = time_factor * rate() * run.steps;
  if (limit > 0 && estimate > 0) return std::min(limit, estimate) + seconds_to_set_up;
  return limit + estimate > 0 ? limit + estimate + seconds_to_set_up : 0;
}

std::vector<std::size_t> Submission::sizes_of_tasks() {
  std::vector<double> seconds;
  seconds.reserve(work_.waiting.size());
  for (const Waiting& run : work_.waiting) seconds.push_back(rate() * run.steps + 1);
  const int workers = work_.options().workers;
  return grouped(seconds, work_.sweep().slurm.runs_per_task, seconds_of_task,
                 workers > 0 ? 4 * workers : usual_tasks, most_tasks());
}

/// Assigns the first waiting runs to a task.
Task Submission::next_task(int index, std::size_t runs, Request& request) {
  Task task = {array_, {request.name, index}, {}};
  TaskFile file;
  file.time_limit = work_.sweep().time_limit;
  double seconds = seconds_to_start;
  bool is_known = true;
  for (std::size_t i = 0; i < runs; ++i) {
    const Waiting run = work_.waiting.front();
    is_known = is_known && time_of(run) > 0;
    seconds += time_of(run);
    request.bytes =
        std::max(request.bytes, memory_factor * static_cast<double>(run.bytes) + bytes_of_worker);
    file.runs.push_back({run, work_.command_of(run.parameters)});
    task.runs.push_back(run);
    work_.waiting.pop_front();
  }
  if (is_known) request.seconds = std::max(request.seconds, seconds);
  write_task(array_, index, file);
  return task;
}

std::vector<Task> Submission::operator()() {
  const BatchOptions& options = work_.options();
  array_ = array_of(options.folder, arrays_in(options.folder).size() + 1);
  std::filesystem::create_directories(array_);
  const auto sizes = sizes_of_tasks();
  Request request;
  request.name = job_of(array_);
  request.tasks = static_cast<int>(sizes.size());
  request.at_once = options.workers;
  request.threads = options.threads;
  request.script = array_ / "task.sh";
  request.log = array_ / "task-%a.log";
  request.options = work_.sweep().slurm.options;
  std::vector<Task> tasks;
  tasks.reserve(sizes.size());
  for (int i = 0; i < request.tasks; ++i) {
    tasks.push_back(next_task(i, sizes[static_cast<std::size_t>(i)], request));
  }
  write_atomically(request.script, script_of(work_.program(), array_), Durable::no);
  submit(request);
  if (!options.quiet) {
    std::fputs(
        fmt::format("submitted {} tasks to Slurm as {}\n", request.tasks, request.name).c_str(),
        stderr);
  }
  return tasks;
}

}  // namespace pliant::batch::slurm
