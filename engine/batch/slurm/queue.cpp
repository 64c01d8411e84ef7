#include "engine/batch/slurm/queue.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "engine/batch/command.hpp"

namespace pliant::batch::slurm {

namespace {

constexpr int usual_most_tasks = 1000;  // if Slurm reports none

std::string user_option() { return fmt::format("--user={}", ::getuid()); }

/// Joins the lines of a program's output.
std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

void submit(const Request& request) {
  constexpr double mebibyte = 1024 * 1024;
  std::vector<std::string> command = {
      "sbatch",
      "--requeue",
      "--open-mode=append",
      fmt::format("--job-name={}", request.name),
      fmt::format("--array=0-{}{}", request.tasks - 1,
                  request.at_once > 0 ? fmt::format("%{}", request.at_once) : ""),
      fmt::format("--cpus-per-task={}", request.threads),
      fmt::format("--mem={}M", std::ceil(request.bytes / mebibyte)),
      fmt::format("--output={}", request.log.string())};
  if (request.seconds > 0) {
    command.push_back(fmt::format("--time={}", std::ceil(request.seconds / 60)));
  }
  command.insert(command.end(), request.options.begin(), request.options.end());
  command.push_back(request.script.string());
  const CommandResult result = run_command(command);
  if (result.status == 127) {
    throw InputError(
        "--executor slurm: there is no program `sbatch`; run this where the commands of Slurm are "
        "installed, or leave the option out");
  }
  if (result.status != 0) {
    throw InputError(
        fmt::format("Slurm refuses the runs: {}; change `options` of [slurm] in the "
                    "sweep, or ask who runs the cluster",
                    one_line(result.errors)));
  }
}

int most_tasks() {
  const std::string settings = run_command({"scontrol", "show", "config"}).output;
  const auto at = settings.find("MaxArraySize");
  const auto value = at == std::string::npos ? at : settings.find('=', at);
  if (value == std::string::npos) return usual_most_tasks;
  const int size = std::atoi(settings.c_str() + value + 1);
  return size > 1 ? size - 1 : usual_most_tasks;
}

std::optional<States> states_of(const std::vector<std::string>& jobs) {
  States states;
  if (jobs.empty()) return states;
  const CommandResult result =
      run_command({"squeue", user_option(), "--array", "--states=all", "--noheader",
                   "--format=%j %K %T", fmt::format("--name={}", fmt::join(jobs, ","))});
  if (result.status != 0) return std::nullopt;
  std::istringstream lines(result.output);
  std::string job, state;
  for (int index = 0; lines >> job >> index >> state;) {
    // A requeued task may have several lines; the one that is not over counts.
    std::string& known = states[{job, index}];
    if (known.empty() || is_over(known)) known = state;
  }
  return states;
}

void cancel(const std::string& job) {
  run_command({"scancel", user_option(), fmt::format("--name={}", job)});
}

bool is_over(const std::string& state) {
  constexpr std::array over = {"BOOT_FAIL", "CANCELLED",     "COMPLETED", "DEADLINE", "FAILED",
                               "NODE_FAIL", "OUT_OF_MEMORY", "PREEMPTED", "TIMEOUT",  ""};
  return std::ranges::find(over, state) != over.end();
}

}  // namespace pliant::batch::slurm
