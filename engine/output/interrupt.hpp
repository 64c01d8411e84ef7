#pragma once

#include <csignal>

namespace pliant {

/// While it lives, SIGINT, SIGTERM and SIGHUP only raise a flag, so that a run can stop between
/// steps with a checkpoint. After the first SIGINT or SIGTERM, the next one ends the process. A
/// SIGHUP never does, since a closing terminal may send several; one that was ignored before, as
/// under nohup, stays ignored. One object at a time.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();  ///< restores what was installed before

  bool requested() const { return signal() != 0; }
  int signal() const;  ///< the first of SIGINT, SIGTERM and SIGHUP that came, or 0

 private:
  struct sigaction earlier_interrupt_ = {}, earlier_terminate_ = {}, earlier_hangup_ = {};
};

}  // namespace pliant
