#include "scheduler/workers.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <stdexcept>

#include "scheduler/zero_subnormals.hpp"

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

struct Workers::Arena {
  // Lets oneTBB start more threads than there are cores, if the caller asks for that many.
  tbb::global_control limit;
  tbb::task_arena arena;
};

Workers::Workers(int threads)
    : threads_(checked(threads)),
      id_(next_id()),
      arena_(new Arena{
          {tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)},
          tbb::task_arena(threads)}) {}

Workers::~Workers() = default;

void Workers::call(void (*function)(void*), void* what) {
  arena_->arena.execute([=] { function(what); });
}

void Workers::loop(int count, void (*function)(void*, int), void* what) {
  arena_->arena.execute([=] {
    const auto call_one = [=](int i) {
      const ZeroSubnormals arithmetic;
      function(what, i);
    };
    if (count == 1) return call_one(0);
    tbb::parallel_for(0, count, call_one, tbb::simple_partitioner());
  });
}

int Workers::index() const { return tbb::this_task_arena::current_thread_index(); }

}  // namespace pliant::scheduler
