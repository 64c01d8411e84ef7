#pragma once

#include <csignal>

namespace pliant {

/// The actions of a process on SIGINT, SIGTERM and SIGHUP.
struct SignalActions {
  struct sigaction interrupt = {}, terminate = {}, hangup = {};
};

/// While it exists, SIGINT, SIGTERM and SIGHUP only set a flag, so that a run can stop between
/// steps with a checkpoint. A second SIGINT or SIGTERM ends the process; a SIGHUP never does, since
/// a closing terminal may send several. If SIGHUP was ignored before, as under nohup, it stays so.
/// Only one object may exist at a time.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();  ///< restores the former actions

  bool requested() const { return signal() != 0; }
  int signal() const;  ///< the first of SIGINT, SIGTERM and SIGHUP received, or 0

 private:
  SignalActions earlier_;
};

/// While it exists, and until there is an Interrupt, SIGINT, SIGTERM and SIGHUP end the process at
/// once with an exit status and a message, since there is nothing to save yet. If SIGHUP was
/// ignored before, it stays so. Only one object may exist at a time.
class ExitOnInterrupt {
 public:
  /// `message` is a line that must outlive the object.
  ExitOnInterrupt(int status, const char* message);
  ExitOnInterrupt(const ExitOnInterrupt&) = delete;
  ExitOnInterrupt& operator=(const ExitOnInterrupt&) = delete;
  ~ExitOnInterrupt();  ///< restores the former actions

 private:
  SignalActions earlier_;
};

}  // namespace pliant
