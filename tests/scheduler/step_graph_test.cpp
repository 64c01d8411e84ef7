#include "scheduler/step_graph.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <thread>

#include "tests/scheduler/phases.hpp"

namespace pliant::scheduler {

namespace {

using namespace testing;

/// Diffusion on a ring that is divided into blocks, with a global factor reduced from sums of the
/// blocks in each stage: every kind of access in a step.
class Ring {
 public:
  static constexpr int block_count = 9, stages = 3;
  static constexpr std::size_t cells = 16;

  Ring() : value_(block_count * cells), next_(value_.size()), partial_(block_count) {
    for (std::size_t i = 0; i < value_.size(); ++i)
      value_[i] = 1.0 / (1.0 + static_cast<double>(i * i % 37));
  }

  static Blocks blocks() {
    Blocks result;
    for (int b = 0; b < block_count; ++b)
      result.neighbours.push_back({(b + 1) % block_count, (b + block_count - 1) % block_count});
    return result;
  }

  std::vector<Phase> phases() {
    enum : FieldId { value, next, partial, factor };
    std::vector<Phase> result;
    for (int stage = 0; stage < stages; ++stage) {
      result.push_back(per_block("spread", {{value, Reach::neighbours}, {factor}}, {{next}},
                                 [this](BlockId b) { spread(b); }));
      result.push_back(
          per_block("copy", {{next}}, {{value}, {partial}}, [this](BlockId b) { copy(b); }));
      result.push_back(per_block("kick", {{factor}}, {{value}},
                                 [this](BlockId b) { value_[first(b)] += factor_; }));
      result.back().blocks = {1, 4};
      result.push_back(reduce("fold", {{partial, Reach::all}}, {{factor, Reach::all}},
                              [this](BlockId) { fold(); }));
      for (std::size_t p = result.size() - 4; p < result.size(); ++p) result[p].stage = stage;
    }
    return result;
  }

  StepGraph graph() { return {phases(), blocks(), {"value", "next", "partial", "factor"}}; }

  const std::vector<double>& value() const { return value_; }

 private:
  static std::size_t first(BlockId b) { return static_cast<std::size_t>(b) * cells; }

  void spread(BlockId b) {
    const std::size_t n = value_.size();
    for (std::size_t i = first(b); i < first(b + 1); ++i)
      next_[i] =
          value_[i] + factor_ * (value_[(i + 1) % n] - 1.9 * value_[i] + value_[(i + n - 1) % n]);
  }
  void copy(BlockId b) {
    double sum = 0;
    for (std::size_t i = first(b); i < first(b + 1); ++i) sum += value_[i] = next_[i];
    partial_[static_cast<std::size_t>(b)] = sum;
  }
  void fold() {
    const double sum = std::accumulate(partial_.begin(), partial_.end(), 0.0);
    factor_ = 0.3 / (1 + sum * sum);
  }

  std::vector<double> value_, next_, partial_;
  double factor_ = 0.2;
};

constexpr int steps = 50;

/// Runs the phases one after another, without a graph.
std::vector<double> expected_ring() {
  Ring ring;
  for (int step = 0; step < steps; ++step)
    for (const Phase& phase : ring.phases()) {
      if (phase.kind == Phase::Kind::reduce)
        phase.run(0);
      else
        for (int b = 0; b < Ring::block_count; ++b)
          if (phase.blocks.empty() || b == phase.blocks[0] || b == phase.blocks[1]) phase.run(b);
    }
  return ring.value();
}

int threads_of_this_process() {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/task"))
    ++count;
  return count;
}

}  // namespace

TEST(step_graph, results_are_bitwise_independent_of_the_thread_count) {
  const auto expected = expected_ring();
  for (const int threads : {1, 2, 7}) {
    Ring ring;
    StepGraph graph = ring.graph();
    Workers workers(threads);
    for (int step = 0; step < steps; ++step) graph.run(workers);
    EXPECT_EQ(ring.value(), expected) << threads << " threads";
  }
}

TEST(step_graph, results_are_bitwise_independent_of_the_legal_order) {
  const auto expected = expected_ring();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Ring ring;
    StepGraph graph = ring.graph();
    for (std::uint64_t step = 0; step < steps; ++step) graph.run_serially(seed * steps + step);
    EXPECT_EQ(ring.value(), expected) << "seed " << seed;
  }
}

TEST(step_graph, serial_orders_differ_between_seeds) {
  std::vector<BlockId> order;
  StepGraph graph({per_block("p", {}, {}, [&](BlockId b) { order.push_back(b); })},
                  row_of_blocks(20), {});
  graph.run_serially(1);
  const auto first = std::exchange(order, {});
  graph.run_serially(1);
  EXPECT_EQ(order, first);
  order.clear();
  graph.run_serially(2);
  EXPECT_NE(order, first);
}

TEST(step_graph, no_node_starts_before_its_predecessors_have_stopped) {
  Ring ring;
  StepGraph graph = ring.graph();
  Workers workers(7);
  for (int step = 0; step < steps; ++step) {
    graph.run(workers);
    for (const Edge& edge : graph.edges())
      ASSERT_LE(graph.record().spans[static_cast<std::size_t>(edge.from)].stop,
                graph.record().spans[static_cast<std::size_t>(edge.to)].start);
  }
}

TEST(step_graph, runs_every_call_once_also_behind_junctions) {
  constexpr int block_count = 12;
  std::atomic<int> calls{0}, late_writes{0};
  const auto count = [&](BlockId) { ++calls; };
  StepGraph graph(
      {per_block("write", {}, {{0}}, count), per_block("read", {{0, Reach::all}}, {{1}}, count),
       per_block("again", {}, {{0}}, [&](BlockId) { late_writes += calls >= 2 * block_count; })},
      row_of_blocks(block_count), {"a", "b"});
  Workers workers(2);
  graph.run(workers);
  EXPECT_EQ(calls, 2 * block_count);
  EXPECT_EQ(late_writes, block_count);
}

/// Runs steps of that many blocks on a number of threads, and expects the calling thread alone.
void expect_no_other_thread(int blocks, int threads) {
  const int threads_before = threads_of_this_process();
  std::atomic<int> elsewhere{0};
  const auto caller = std::this_thread::get_id();
  StepGraph graph({per_block("p", {}, {{0}},
                             [&](BlockId) { elsewhere += std::this_thread::get_id() != caller; }),
                   per_block("q", {{0, Reach::all}}, {}, do_nothing)},
                  row_of_blocks(blocks), {"a"});
  Workers workers(threads);
  for (int step = 0; step < steps; ++step) graph.run(workers);
  EXPECT_EQ(elsewhere, 0);
  EXPECT_EQ(threads_of_this_process(), threads_before);
}

TEST(step_graph, one_worker_is_the_calling_thread_alone) { expect_no_other_thread(50, 1); }

TEST(step_graph, one_block_runs_on_the_calling_thread_alone) { expect_no_other_thread(1, 4); }

TEST(step_graph, workers_know_their_index) {
  Workers workers(7);
  std::atomic<int> wrong{0};
  StepGraph graph({per_block("p", {}, {},
                             [&](BlockId) {
                               wrong += workers.index() < 0 || workers.index() >= workers.threads();
                             })},
                  row_of_blocks(200), {});
  for (int step = 0; step < steps; ++step) graph.run(workers);
  EXPECT_EQ(wrong, 0);
}

TEST(step_graph, an_exception_in_a_phase_comes_out_and_the_graph_runs_again) {
  for (const int threads : {1, 2}) {
    std::atomic<bool> fails{true};
    std::atomic<int> after{0};
    StepGraph graph({per_block("fail", {}, {{0}},
                               [&](BlockId b) {
                                 if (fails && b == 3) throw std::runtime_error("block 3 broke");
                               }),
                     reduce("after", {{0, Reach::all}}, {}, [&](BlockId) { ++after; })},
                    row_of_blocks(6), {"a"});
    Workers workers(threads);
    try {
      graph.run(workers);
      FAIL() << "nothing came out";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "block 3 broke");
    }
    EXPECT_EQ(after, 0);
    fails = false;
    graph.run(workers);
    EXPECT_EQ(after, 1);
  }
}

// Arithmetic with subnormal numbers takes some hundred cycles.
TEST(step_graph, computes_with_zero_in_place_of_subnormal_numbers_and_leaves_the_caller_alone) {
  const volatile float tiny = 1e-20F;
  std::vector<float> square;
  StepGraph graph(
      {per_block("square", {}, {{0}},
                 [&](BlockId b) { square[static_cast<std::size_t>(b)] = tiny * tiny; })},
      row_of_blocks(40), {"square"});
  const std::vector<float> zero(40);
  for (const int threads : {1, 2}) {
    square.assign(zero.size(), 1);
    Workers workers(threads);
    graph.run(workers);
    EXPECT_EQ(square, zero);
  }
  square.assign(zero.size(), 1);
  graph.run_serially(0);
  EXPECT_EQ(square, zero);
  EXPECT_GT(tiny * tiny, 0) << "the caller keeps its settings";
}

TEST(step_graph, can_be_moved_and_replaced_between_steps) {
  Ring ring;
  std::optional<StepGraph> graph;
  Workers workers(2);
  for (int step = 0; step < steps; ++step) {
    graph = ring.graph();
    graph->run(workers);
  }
  EXPECT_EQ(ring.value(), expected_ring());
}

TEST(step_graph, an_empty_step_runs) {
  StepGraph graph({}, {}, {});
  Workers workers(2);
  graph.run(workers);
  graph.run_serially(0);
  EXPECT_TRUE(graph.nodes().empty());
}

TEST(workers, call_a_function_once_for_each_number_and_pass_its_exception_on) {
  for (const int threads : {1, 2, 7}) {
    Workers workers(threads);
    std::vector<int> calls(500);
    workers.for_each(500, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(calls, std::vector<int>(500, 1));
    workers.for_each(0, [&](int) { FAIL() << "there is nothing to do"; });
    EXPECT_THROW(workers.for_each(500,
                                  [](int i) {
                                    if (i == 77) throw std::runtime_error("");
                                  }),
                 std::runtime_error);
  }
}

TEST(workers, need_a_thread) { EXPECT_THROW(Workers(0), std::invalid_argument); }

}  // namespace pliant::scheduler
