#include "engine/cli/setup_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

#include "engine/simulation/estimate.hpp"

namespace pliant::cli {

namespace {

constexpr auto redraw_interval = std::chrono::seconds(1), line_interval = std::chrono::seconds(5);
constexpr auto clear_line = "\r\x1b[K";

std::size_t resident_bytes() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// An stderr that cannot be written must not end the run.
void put(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

SetupProgress::SetupProgress(std::size_t expected)
    : expected_(expected),
      is_terminal_(::isatty(STDERR_FILENO) != 0),
      thread_([this](const std::stop_token& stop) { show(stop); }) {}

void SetupProgress::finish() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void SetupProgress::show(const std::stop_token& stop) {
  const auto interval = is_terminal_ ? redraw_interval : line_interval;
  std::unique_lock lock(mutex_);
  bool is_drawn = false;
  for (int count = 1;; ++count) {
    stopped_.wait_for(lock, stop, interval, [] { return false; });
    if (stop.stop_requested()) break;
    put(fmt::format("{}setting up: {} of about {} in use after {} s{}",
                    is_terminal_ ? clear_line : "", memory_text(resident_bytes()),
                    memory_text(expected_), count * interval.count(), is_terminal_ ? "" : "\n"));
    is_drawn = is_terminal_;
  }
  if (is_drawn) put(clear_line);
}

}  // namespace pliant::cli
