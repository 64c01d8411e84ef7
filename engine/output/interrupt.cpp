#include "engine/output/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <cstring>

namespace pliant {
namespace {

// A signal handler may only use lock-free atomics, sigaction, write and _exit.
std::atomic<int> received = 0;
std::atomic<int> exit_status = 0;  // 0: the process continues
std::atomic<const char*> exit_message = nullptr;
static_assert(std::atomic<int>::is_always_lock_free);
static_assert(std::atomic<const char*>::is_always_lock_free);

void restore_default(int number) {
  struct sigaction action = {};
  action.sa_handler = SIG_DFL;
  sigaction(number, &action, nullptr);
}

extern "C" void note_signal(int number) {
  if (const int status = exit_status; status != 0) {
    const char* message = exit_message;
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message, std::strlen(message));
    ::_exit(status);
  }
  int none = 0;
  received.compare_exchange_strong(none, number);
  if (number == SIGHUP) return;
  restore_default(SIGINT);
  restore_default(SIGTERM);
}

SignalActions install() {
  SignalActions earlier;
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &earlier.interrupt);
  sigaction(SIGTERM, &action, &earlier.terminate);
  sigaction(SIGHUP, nullptr, &earlier.hangup);
  if (earlier.hangup.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  return earlier;
}

void restore(const SignalActions& earlier) {
  sigaction(SIGINT, &earlier.interrupt, nullptr);
  sigaction(SIGTERM, &earlier.terminate, nullptr);
  sigaction(SIGHUP, &earlier.hangup, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  received = 0;
  exit_status = 0;
  earlier_ = install();
}

Interrupt::~Interrupt() { restore(earlier_); }

int Interrupt::signal() const { return received; }

ExitOnInterrupt::ExitOnInterrupt(int status, const char* message) {
  exit_message = message;
  exit_status = status;
  earlier_ = install();
}

ExitOnInterrupt::~ExitOnInterrupt() {
  exit_status = 0;
  restore(earlier_);
}

}  // namespace pliant
