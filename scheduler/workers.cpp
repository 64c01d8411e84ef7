#include "scheduler/workers.hpp"

#include <fmt/format.h>

#include <atomic>
#include <stdexcept>

namespace pliant::scheduler {

namespace {

int checked(int threads) {
  if (threads < 1)
    throw std::invalid_argument(fmt::format("{} threads asked for, but it takes one", threads));
  return threads;
}

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

Workers::Workers(int threads)
    : threads_(checked(threads)),
      id_(next_id()),
      limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
      arena_(threads) {}

}  // namespace pliant::scheduler
