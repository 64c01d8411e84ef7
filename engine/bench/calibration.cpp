#include "engine/bench/calibration.hpp"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <vector>

#include "engine/bench/fma_loop.hpp"

namespace pliant::bench {

namespace {

using Clock = std::chrono::steady_clock;

// Long enough to wake a processor, short enough to accompany every measurement.
constexpr std::chrono::milliseconds duration(30);

// The processors that this process may use.
std::vector<int> own_processors() {
  cpu_set_t set;
  std::vector<int> processors;
  if (sched_getaffinity(0, sizeof set, &set) != 0) return processors;
  for (int p = 0; p < CPU_SETSIZE; ++p) {
    if (CPU_ISSET(p, &set)) processors.push_back(p);
  }
  return processors;
}

// Such a short-lived thread might never leave the processor on which it started.
void move_to(int processor) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(processor, &set);
  pthread_setaffinity_np(pthread_self(), sizeof set, &set);
}

// Work per second of all threads together. Each thread repeats `portion(thread)`, which returns the
// work done, until the time is over.
double rate(int threads, const std::function<double(int)>& portion) {
  const std::vector<int> processors = own_processors();
  std::vector<double> rates(static_cast<std::size_t>(threads));
  std::atomic<int> waiting = threads;
  const auto run = [&](int thread) {
    const auto t = static_cast<std::size_t>(thread);
    if (!processors.empty()) move_to(processors[t % processors.size()]);
    --waiting;
    while (waiting > 0) std::this_thread::yield();
    const auto start = Clock::now();
    double work = 0;
    auto now = start;
    while (now - start < duration) {
      work += portion(thread);
      now = Clock::now();
    }
    rates[t] = work / std::chrono::duration<double>(now - start).count();
  };
  std::vector<std::thread> workers;
  workers.reserve(threads);
  for (int thread = 0; thread < threads; ++thread) workers.emplace_back(run, thread);
  for (std::thread& worker : workers) worker.join();
  double sum = 0;
  for (const double r : rates) sum += r;
  return sum;
}

// Two threads wait for each other in turns: one makes the count odd, the other even.
double hand_over_between(int one, int other) {
  constexpr int last = 10'000;
  alignas(64) std::atomic<int> count = 0;
  const auto take_turns = [&](int turn, int end) {
    for (; turn < end; turn += 2) {
      while (count.load(std::memory_order_acquire) != turn) continue;
      count.store(turn + 1, std::memory_order_release);
    }
  };
  std::thread answers([&] {
    move_to(other);
    take_turns(1, last);
  });
  double elapsed = 0;
  std::thread asks([&] {
    move_to(one);
    take_turns(0, 4);  // until the other thread runs
    const auto start = Clock::now();
    take_turns(4, last);
    elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  });
  asks.join();
  answers.join();
  return 2 * elapsed / last;
}

struct Loop {
  double (*run)(std::int64_t);
  int lanes;
};

Loop loop_for(kernels::Isa isa) {
  switch (isa) {
    case kernels::Isa::avx512:
      return {fma_loop_avx512, 8};
    case kernels::Isa::avx2:
      return {fma_loop_avx2, 4};
    case kernels::Isa::sse2:
      break;
  }
  return {fma_loop_sse2, 2};
}

}  // namespace

double fma_peak(kernels::Isa isa, int threads) {
  const Loop loop = loop_for(isa);
  return rate(threads, [&](int) {
    constexpr std::int64_t rounds = 100'000;
    [[maybe_unused]] volatile double kept = loop.run(rounds);
    return 2.0 * static_cast<double>(rounds) * fma_chains * loop.lanes;
  });
}

double hand_over(int threads) {
  const std::vector<int> processors = own_processors();
  const std::size_t used = std::min(processors.size(), static_cast<std::size_t>(threads));
  double sum = 0;
  for (std::size_t p = 1; p < used; ++p) sum += hand_over_between(processors[0], processors[p]);
  return used > 1 ? sum / static_cast<double>(used - 1) : 0;
}

Triad::Triad() {
  for (Buffer<double>* array : {&a_, &b_, &c_}) array->grow(length, 1);
}

double Triad::operator()(int threads) {
  return rate(threads, [&](int thread) {
    const std::size_t first = length * static_cast<std::size_t>(thread) / threads;
    const std::size_t last = length * (static_cast<std::size_t>(thread) + 1) / threads;
    double* a = a_.get();
    const double *b = b_.get(), *c = c_.get();
    for (std::size_t i = first; i < last; ++i) a[i] = b[i] + 3 * c[i];
    return 3.0 * sizeof(double) * static_cast<double>(last - first);
  });
}

}  // namespace pliant::bench
