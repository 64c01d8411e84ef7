#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "scheduler/step_graph.hpp"
#include "tests/scheduler/phases.hpp"

namespace {

std::atomic<int> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  if (void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment))
    return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace pliant::scheduler {

TEST(allocation, a_warm_step_allocates_nothing) {
  using namespace testing;
  for (const int threads : {1, 2, 7}) {
    StepGraph graph(
        {per_block("advance", {{0, Reach::neighbours}}, {{1}}), per_block("copy", {{1}}, {{0}}),
         once("fold", {{0, Reach::all}}, {{2, Reach::all}}),
         per_block("gather", {{0, Reach::all}}, {{1}})},
        row_of_blocks(20), {"a", "b", "c"});
    Workers workers(threads);
    StepTotals totals;
    const auto step = [&] {
      graph.run(workers);
      totals.add(graph.record(), graph.timer_names());
    };
    for (int warm = 0; warm < 3; ++warm) step();
    const int before = allocations;
    for (int i = 0; i < 200; ++i) step();
    EXPECT_EQ(allocations - before, 0) << threads << " threads";
  }
}

}  // namespace pliant::scheduler
