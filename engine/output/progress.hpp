#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

namespace pliant {

struct ProgressState {
  double time = 0, end = 0;  ///< [s]
  std::int64_t step = 0;
  double time_step = 0;              ///< [s]
  std::int64_t particle_stages = 0;  ///< since the program started
};

/// Shows the progress of a run: on a terminal one line that is redrawn, elsewhere a plain line
/// every few seconds. Never throws: when its stream cannot be written, it stops writing.
class Progress {
 public:
  enum class Style { silent, lines, redrawn };
  using Clock = std::chrono::steady_clock;

  /// Writes to stderr, in a style that suits it.
  explicit Progress(bool quiet);
  Progress(std::FILE* stream, Style style, std::function<Clock::time_point()> now = Clock::now);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Only reads the clock if it is not yet time to write.
  void update(const ProgressState& state);

  /// Writes the last state and ends the line.
  void finish();

  /// Finishes, then writes `text`, lines that end with a newline, unless silent.
  void report(std::string_view text);

  /// Writes a line of text, also when silent, over the redrawn line and the echo of Ctrl-C.
  void message(std::string_view text);

 private:
  void put(std::string_view text);
  void write(const ProgressState& state, Clock::time_point now);

  std::FILE* stream_;
  Style style_;
  std::function<Clock::time_point()> now_;
  bool started_ = false, drawn_ = false, last_is_written_ = true;
  ProgressState first_, last_, written_;
  Clock::time_point start_, written_at_;
};

/// "  42 %  t = 0.0126 s  step 1234  dt = 1.02e-05 s  8.31 M/s  ETA 0:42", with `rate` in
/// particle-stages per second.
std::string progress_text(const ProgressState& state, double rate, double seconds_left);

}  // namespace pliant
