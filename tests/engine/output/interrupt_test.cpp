#include "engine/output/interrupt.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace pliant::test {
namespace {

TEST(interrupt, the_first_signal_only_raises_a_flag) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.requested());
    ::raise(number);
    EXPECT_TRUE(interrupt.requested());
    EXPECT_EQ(interrupt.signal(), number);
  }
}

TEST(interrupt, a_second_signal_ends_the_process_in_the_default_way) {
  for (const int second : {SIGINT, SIGTERM}) {
    const auto child = ::fork();
    if (child == 0) {
      const Interrupt interrupt;
      ::raise(SIGINT);
      ::raise(second);
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), second);
  }
}

TEST(interrupt, hangups_never_end_the_process) {
  const Interrupt interrupt;
  for (int i = 0; i < 3; ++i) ::raise(SIGHUP);
  ::raise(SIGINT);
  ::raise(SIGHUP);
  EXPECT_EQ(interrupt.signal(), SIGHUP);
}

TEST(interrupt, a_hangup_that_was_ignored_stays_ignored) {
  ::signal(SIGHUP, SIG_IGN);
  {
    const Interrupt interrupt;
    ::raise(SIGHUP);
    EXPECT_FALSE(interrupt.requested());
  }
  EXPECT_EQ(::signal(SIGHUP, SIG_DFL), SIG_IGN);
}

// Without an Interrupt there is nothing to save.
TEST(interrupt, before_a_run_begins_a_signal_ends_the_process_with_its_status) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto child = ::fork();
    if (child == 0) {
      const ExitOnInterrupt in_set_up(4, "");
      ::raise(number);
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 4);
  }
}

TEST(interrupt, from_then_on_a_signal_raises_the_flag) {
  const ExitOnInterrupt in_set_up(4, "");
  const Interrupt interrupt;
  ::raise(SIGTERM);
  EXPECT_TRUE(interrupt.requested());
}

TEST(interrupt, earlier_handlers_come_back) {
  struct sigaction before = {}, after = {};
  ::sigaction(SIGINT, nullptr, &before);
  {
    const Interrupt interrupt;
    ::raise(SIGINT);
  }
  ::sigaction(SIGINT, nullptr, &after);
  EXPECT_EQ(before.sa_handler, after.sa_handler);
}

}  // namespace
}  // namespace pliant::test
