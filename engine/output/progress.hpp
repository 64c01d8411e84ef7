#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

namespace pliant {

/// Where a run stands.
struct ProgressState {
  double time = 0, end = 0;  ///< [s]
  std::int64_t step = 0;
  double time_step = 0;              ///< [s]
  std::int64_t particle_stages = 0;  ///< since the program started
};

/// Tells a person how a run is going: one line redrawn in place on a terminal, a plain line every
/// few seconds elsewhere. Never throws: when its stream cannot be written, it falls silent.
class Progress {
 public:
  enum class Style { silent, lines, redrawn };
  using Clock = std::chrono::steady_clock;

  /// On stderr, in the style that suits where it leads.
  explicit Progress(bool quiet);
  Progress(std::FILE* stream, Style style, std::function<Clock::time_point()> now = Clock::now);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Costs a look at the clock when it is not yet time to write.
  void update(const ProgressState& state);

  /// Writes the last state and ends the line.
  void finish();

  /// Finishes, then writes `text`, lines that end with a newline, unless silent.
  void report(std::string_view text);

  /// Writes a line of text, also when silent, in place of the redrawn line and what Ctrl-C left on
  /// it.
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
