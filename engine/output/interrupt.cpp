#include "engine/output/interrupt.hpp"

#include <atomic>

namespace pliant {
namespace {

// A signal handler may use nothing but lock-free atomics and sigaction.
std::atomic<int> received = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void restore_default(int number) {
  struct sigaction action = {};
  action.sa_handler = SIG_DFL;
  sigaction(number, &action, nullptr);
}

extern "C" void note_signal(int number) {
  int none = 0;
  received.compare_exchange_strong(none, number);
  if (number == SIGHUP) return;
  restore_default(SIGINT);
  restore_default(SIGTERM);
}

}  // namespace

Interrupt::Interrupt() {
  received = 0;
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &earlier_interrupt_);
  sigaction(SIGTERM, &action, &earlier_terminate_);
  sigaction(SIGHUP, nullptr, &earlier_hangup_);
  if (earlier_hangup_.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &earlier_interrupt_, nullptr);
  sigaction(SIGTERM, &earlier_terminate_, nullptr);
  sigaction(SIGHUP, &earlier_hangup_, nullptr);
}

int Interrupt::signal() const { return received; }

}  // namespace pliant
