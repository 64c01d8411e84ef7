#include "engine/output/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr auto redraw_interval = std::chrono::milliseconds(100);
constexpr auto line_interval = std::chrono::seconds(5);
constexpr int widest_bar = 30, narrowest_bar = 5, usual_width = 80;

constexpr auto clear_line = "\r\x1b[K";

Progress::Style style_of(int descriptor, bool quiet) {
  if (quiet) return Progress::Style::silent;
  return ::isatty(descriptor) ? Progress::Style::redrawn : Progress::Style::lines;
}

int width_of(int descriptor) {
  winsize size = {};
  const bool known = ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : usual_width;
}

double fraction_of(const ProgressState& state) {
  return state.end > 0 ? std::clamp(state.time / state.end, 0.0, 1.0) : 0;
}

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds > 359999) return "-:--";
  const auto whole = std::lround(seconds);
  const auto hours = whole / 3600, minutes = whole / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
  return fmt::format("{}:{:02}", minutes, whole % 60);
}

/// A line longer than the terminal would wrap, and the next redraw would leave its first row.
std::string drawn_line(const std::string& text, double fraction, int width) {
  const int room = width - static_cast<int>(text.size()) - 4;
  if (room < narrowest_bar) return text.substr(0, static_cast<std::size_t>(width - 1));
  const auto size = std::min(room, widest_bar);
  const auto full = static_cast<int>(std::lround(fraction * size));
  return fmt::format("[{:#<{}}{:.<{}}] {}", "", full, "", size - full, text);
}

}  // namespace

std::string progress_text(const ProgressState& state, double rate, double seconds_left) {
  // Rounded down, so that 100 % means done.
  return fmt::format("{:3d} %  t = {:.4g} s  step {}  dt = {:.3g} s  {:.2f} M/s  ETA {}",
                     static_cast<int>(100 * fraction_of(state)), state.time, state.step,
                     state.time_step, rate / 1e6, duration_text(seconds_left));
}

Progress::Progress(bool quiet) : Progress(stderr, style_of(STDERR_FILENO, quiet)) {}

Progress::Progress(std::FILE* stream, Style style, std::function<Clock::time_point()> now)
    : stream_(stream), style_(style), now_(std::move(now)) {}

Progress::~Progress() { finish(); }

void Progress::update(const ProgressState& state) {
  if (style_ == Style::silent) return;
  const auto now = now_();
  const bool is_first = !started_ && style_ == Style::redrawn;
  if (!started_) {
    started_ = true;
    first_ = written_ = state;
    start_ = written_at_ = now;
  }
  last_ = state;
  last_is_written_ = false;
  const auto interval =
      style_ == Style::redrawn ? Clock::duration(redraw_interval) : Clock::duration(line_interval);
  if (now - written_at_ >= interval || is_first) write(state, now);
}

void Progress::finish() {
  if (!last_is_written_) write(last_, now_());
  if (drawn_) put("\n");
  drawn_ = false;
}

void Progress::report(std::string_view text) {
  finish();
  if (style_ != Style::silent) put(text);
}

void Progress::message(std::string_view text) {
  put(fmt::format("{}{}\n", drawn_ ? clear_line : "", text));
  drawn_ = false;
}

/// Progress must not stop a run: if the terminal is closed or the disk is full, nothing more is
/// shown.
void Progress::put(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stream_) == text.size();
  if (std::fflush(stream_) == 0 && written) return;
  std::clearerr(stream_);
  style_ = Style::silent;
  last_is_written_ = true;
  drawn_ = false;
}

void Progress::write(const ProgressState& state, Clock::time_point now) {
  const double since_start = Seconds(now - start_).count();
  const double since_written = Seconds(now - written_at_).count();
  const double stages = static_cast<double>(state.particle_stages - written_.particle_stages);
  const double rate = since_written > 0 ? stages / since_written : 0;
  const double done = state.time - first_.time;
  const double left = state.time >= state.end ? 0 : (state.end - state.time) / done * since_start;
  const auto text = progress_text(state, rate, left);
  written_ = state;
  written_at_ = now;
  last_is_written_ = true;
  if (style_ == Style::redrawn) {
    const auto line = drawn_line(text, fraction_of(state), width_of(::fileno(stream_)));
    drawn_ = true;
    put(clear_line + line);
  } else {
    put(text + '\n');
  }
}

}  // namespace pliant
