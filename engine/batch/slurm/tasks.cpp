#include "engine/batch/slurm/tasks.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/output/atomic_file.hpp"

namespace pliant::batch::slurm {

namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path file_of(const std::filesystem::path& array, int index) {
  return array / fmt::format("task-{}.json", index);
}

}  // namespace

void write_task(const std::filesystem::path& array, int index, const TaskFile& task) {
  Json runs = Json::array();
  for (const TaskRun& one : task.runs) {
    runs.push_back({{"name", one.run.name},
                    {"attempts", one.run.attempts},
                    {"attempts_left", one.run.attempts_left},
                    {"command", one.command}});
  }
  const Json json = {{"time_limit", task.time_limit}, {"runs", runs}};
  write_atomically(file_of(array, index),
                   json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n", Durable::no);
}

TaskFile read_task(const std::filesystem::path& array, int index) {
  std::ifstream file(file_of(array, index));
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object()) {
    throw InputError(
        fmt::format("{}: holds no task of a batch; `pliant batch SWEEP --executor "
                    "slurm` writes them",
                    file_of(array, index).string()));
  }
  TaskFile task;
  task.time_limit = json.at("time_limit");
  for (const Json& one : json.at("runs")) {
    Waiting run;
    run.name = one.at("name");
    run.attempts = one.at("attempts");
    run.attempts_left = one.at("attempts_left");
    task.runs.push_back({run, one.at("command")});
  }
  return task;
}

std::vector<std::size_t> grouped(const std::vector<double>& seconds_of_runs, int runs_per_task,
                                 double seconds, int least_tasks, int most_tasks) {
  const auto runs = static_cast<double>(seconds_of_runs.size());
  std::vector<double> costs = seconds_of_runs;
  double of_task = 0;
  if (runs_per_task > 0) {
    std::ranges::fill(costs, 1.0);
    of_task = std::max(static_cast<double>(runs_per_task), runs / most_tasks);
  } else {
    const double all = std::accumulate(costs.begin(), costs.end(), 0.0);
    of_task = std::max(std::min(seconds, all / least_tasks), all / most_tasks);
  }
  std::vector<std::size_t> sizes;
  double sum = 0;
  for (const double cost : costs) {
    // Tasks are divided at multiples of the time of a task, so that there are never more tasks than
    // allowed.
    const auto task = static_cast<std::size_t>(sum / of_task * (1 + 1e-12));
    if (task >= sizes.size()) sizes.push_back(0);
    ++sizes.back();
    sum += cost;
  }
  return sizes;
}

}  // namespace pliant::batch::slurm
