#pragma once

#include <csignal>

namespace pliant {

/// While it lives, the first SIGINT or SIGTERM only raises a flag, so that a run can stop between
/// steps with a checkpoint; a second one ends the process as if nobody listened. One at a time.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();  ///< restores what was installed before

  bool requested() const { return signal() != 0; }
  int signal() const;  ///< SIGINT, SIGTERM, or 0

 private:
  struct sigaction earlier_interrupt_ = {}, earlier_terminate_ = {};
};

}  // namespace pliant
