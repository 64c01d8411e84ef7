#pragma once

#include <signal.h>

namespace pliant::batch {

/// Blocks SIGCHLD, so that the signal stays pending if a child ends while nothing waits for it.
/// Must be created before the children.
class EndOfChild {
 public:
  EndOfChild() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGCHLD);
    sigprocmask(SIG_BLOCK, &signals_, nullptr);
  }

  /// Returns when a child ends, or after a tenth of a second.
  void wait() const {
    constexpr timespec longest_sleep = {0, 100'000'000};
    sigtimedwait(&signals_, nullptr, &longest_sleep);
  }

 private:
  sigset_t signals_ = {};
};

}  // namespace pliant::batch
