#pragma once

#include <csignal>

namespace pliant {

/// What a process does on SIGINT, SIGTERM and SIGHUP.
struct SignalActions {
  struct sigaction interrupt = {}, terminate = {}, hangup = {};
};

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
  SignalActions earlier_;
};

/// While it lives, and until there is an Interrupt, SIGINT, SIGTERM and SIGHUP end the process at
/// once with an exit status and a message: for the time in which there is nothing to save. A SIGHUP
/// that was ignored before stays ignored. One object at a time.
class ExitOnInterrupt {
 public:
  /// `message` is a line that outlives the object.
  ExitOnInterrupt(int status, const char* message);
  ExitOnInterrupt(const ExitOnInterrupt&) = delete;
  ExitOnInterrupt& operator=(const ExitOnInterrupt&) = delete;
  ~ExitOnInterrupt();  ///< restores what was installed before

 private:
  SignalActions earlier_;
};

}  // namespace pliant
