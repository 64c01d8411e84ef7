#include "engine/batch/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "engine/simulation/estimate.hpp"

namespace pliant::batch {

namespace {

bool is_terminal() { return ::isatty(STDERR_FILENO) != 0; }

}  // namespace

void ProgressLine::add_run(double seconds) {
  run_seconds_ += seconds;
  ++runs_;
}

void ProgressLine::show(std::size_t running, int workers) {
  const auto interval = is_terminal() ? std::chrono::milliseconds(200) : std::chrono::seconds(5);
  if (quiet_ || Clock::now() - written_ < interval) return;
  write(running, workers);
}

void ProgressLine::write(std::size_t running, int workers) {
  std::string text =
      fmt::format("{} of {} runs done, {} failed, {} running", done, all, failed, running);
  const int left = all - done - failed;
  if (runs_ > 0 && left > 0) {
    text += ", ETA " + duration_text(run_seconds_ / runs_ * left / workers);
  }
  // Progress must not stop a batch: write errors are ignored.
  std::fputs((is_terminal() ? "\r\x1b[K" + text : text + "\n").c_str(), stderr);
  written_ = Clock::now();
}

void ProgressLine::finish() {
  if (quiet_) return;
  write(0, 1);
  if (is_terminal()) std::fputs("\n", stderr);
}

}  // namespace pliant::batch
