#include "engine/output/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace pliant::test {
namespace {

using namespace std::chrono_literals;

/// Progress written into a file, with a clock that the test sets; the text is read back.
class Recorded {
 public:
  explicit Recorded(Progress::Style style)
      : stream_(std::tmpfile()), progress_(stream_, style, [this] { return now_; }) {}

  Progress& operator()() { return progress_; }
  void wait(std::chrono::milliseconds time) { now_ += time; }

  std::string text() {
    std::rewind(stream_);
    std::string text;
    std::array<char, 4096> part;
    while (const auto size = std::fread(part.data(), 1, part.size(), stream_))
      text.append(part.data(), size);
    return text;
  }

 private:
  std::FILE* stream_;
  Progress::Clock::time_point now_ = {};
  Progress progress_;
};

/// Step `step` of 100, each with 100 ms and a million particle-stages.
ProgressState state(int step) {
  return {.time = 0.01 * step,
          .end = 1,
          .step = step,
          .time_step = 0.01,
          .particle_stages = 1'000'000LL * step};
}

void run(Recorded& progress, int steps) {
  for (int step = 0; step <= steps; ++step) {
    progress().update(state(step));
    progress.wait(100ms);
  }
}

TEST(progress, lines_come_every_few_seconds_and_at_the_end) {
  Recorded progress(Progress::Style::lines);
  run(progress, 99);
  progress().update(state(100));
  progress().finish();
  const auto text = progress.text();
  EXPECT_EQ(std::ranges::count(text, '\n'), 2);  // at 5 s and at 10 s
  EXPECT_EQ(text.find('\r'), text.npos);
  EXPECT_EQ(text.find('\x1b'), text.npos);
  EXPECT_NE(text.find(" 50 %  t = 0.5 s  step 50  dt = 0.01 s  10.00 M/s  ETA 0:05\n"), text.npos)
      << text;
  EXPECT_NE(text.find("100 %  t = 1 s  step 100  dt = 0.01 s  10.00 M/s  ETA 0:00\n"), text.npos)
      << text;
}

TEST(progress, a_terminal_shows_the_start_at_once) {
  Recorded progress(Progress::Style::redrawn), lines(Progress::Style::lines);
  progress().update(state(0));
  lines().update(state(0));
  EXPECT_NE(progress.text().find("  0 %  t = 0 s  step 0"), std::string::npos) << progress.text();
  EXPECT_EQ(lines.text(), "");
}

TEST(progress, a_terminal_gets_one_line_redrawn) {
  Recorded progress(Progress::Style::redrawn);
  run(progress, 20);
  const auto before = progress.text();
  EXPECT_EQ(std::ranges::count(before, '\n'), 0);
  EXPECT_EQ(std::ranges::count(before, '\r'), 21);
  progress().finish();
  EXPECT_EQ(progress.text().back(), '\n');
}

TEST(progress, no_line_is_wider_than_the_terminal) {
  Recorded progress(Progress::Style::redrawn);
  auto far = state(1);
  far.time = 123456.789;
  far.end = 1e9;
  far.step = 123456789;
  progress().update(far);
  progress.wait(1s);
  progress().update(far);
  const auto text = progress.text();
  const auto begin = text.rfind("\r\x1b[K") + 4;
  EXPECT_LT(text.size() - begin, 80u);  // the width assumed for a stream without a size
}

TEST(progress, a_message_takes_the_place_of_the_redrawn_line) {
  Recorded progress(Progress::Style::redrawn);
  run(progress, 3);
  progress().message("interrupted: writing a checkpoint");
  EXPECT_TRUE(progress.text().ends_with("\r\x1b[Kinterrupted: writing a checkpoint\n"));
  progress().finish();
  EXPECT_TRUE(progress.text().ends_with("checkpoint\n")) << "nothing new to say";
}

TEST(progress, quiet_says_nothing_but_messages) {
  Recorded progress(Progress::Style::silent);
  run(progress, 100);
  progress().finish();
  EXPECT_EQ(progress.text(), "");
  progress().message("failed");
  EXPECT_EQ(progress.text(), "failed\n");
}

TEST(progress, a_resumed_run_estimates_from_its_own_steps) {
  Recorded progress(Progress::Style::lines);
  for (int step = 50; step < 101; ++step) {
    progress().update(state(step));
    progress.wait(200ms);
  }
  EXPECT_NE(progress.text().find(" 75 %  t = 0.75 s  step 75  dt = 0.01 s  5.00 M/s  ETA 0:05"),
            std::string::npos)
      << progress.text();
}

TEST(progress, a_stream_that_cannot_be_written_falls_silent) {
  for (const auto style : {Progress::Style::lines, Progress::Style::redrawn}) {
    std::FILE* full = std::fopen("/dev/full", "w");
    ASSERT_NE(full, nullptr);
    Progress::Clock::time_point now = {};
    {
      Progress progress(full, style, [&] { return now; });
      for (int step = 0; step < 100; ++step, now += 100ms) progress.update(state(step));
      EXPECT_NO_THROW(progress.message("interrupted"));
      EXPECT_NO_THROW(progress.report("results\n"));
    }
    std::fclose(full);
  }
}

TEST(progress, a_report_follows_the_last_line_unless_quiet) {
  Recorded shown(Progress::Style::lines), quiet(Progress::Style::silent);
  for (Recorded* progress : {&shown, &quiet}) {
    run(*progress, 1);
    (*progress)().report("results in x\n");
  }
  EXPECT_TRUE(shown.text().ends_with("\nresults in x\n")) << shown.text();
  EXPECT_EQ(quiet.text(), "");
}

TEST(progress, an_estimate_is_left_out_while_nothing_is_known) {
  EXPECT_TRUE(
      progress_text(state(0), 0, std::numeric_limits<double>::infinity()).ends_with("ETA -:--"));
  EXPECT_TRUE(progress_text(state(0), 0, 3725).ends_with("ETA 1:02:05"));
}

}  // namespace
}  // namespace pliant::test
