#include "scheduler/exchanges.hpp"

#include <gtest/gtest.h>

#include <random>

#include "scheduler/step_graph.hpp"
#include "tests/scheduler/phases.hpp"

namespace pliant::scheduler {

namespace {

using namespace testing;

enum : FieldId { a, b, c };

std::vector<std::string> names_of(const std::vector<Phase>& phases) {
  std::vector<std::string> names;
  for (const Phase& phase : phases) names.push_back(phase.name);
  return names;
}

using Names = std::vector<std::string>;

/// Blocks in separate processes: each has its own values and copies of all others, which only
/// exchange and reduce phases update. A value is the number of the write that set it.
class Processes {
 public:
  Processes(const Blocks& blocks, int fields) : blocks_(blocks), fields_(fields) {
    const auto count = static_cast<std::size_t>(blocks.count());
    seen_.assign(count, std::vector<int>(count * static_cast<std::size_t>(fields), 0));
    // Before the step nothing is known about other blocks.
    for (int b = 0; b < blocks.count(); ++b) write(b, 1);
  }

  /// Whether everything that the phase reads is up to date.
  bool run(const Phase& phase) {
    bool is_up_to_date = true;
    const bool is_exchange = phase.kind == Phase::Kind::exchange;
    if (phase.kind != Phase::Kind::reduce) {  // which gathers values from all processes itself
      for (int block = 0; block < blocks_.count(); ++block)
        for (const Access& read : phase.reads)
          for (const int other : reached(block, read.reach)) {
            int& seen = value(block, read.field, other);
            const int current = value(other, read.field, other);
            if (is_exchange) seen = current;
            is_up_to_date = is_up_to_date && seen == current;
          }
    }
    ++writes_;
    for (const Access& write : phase.writes) {
      for (int block = 0; block < blocks_.count(); ++block)
        value(block, write.field, block) = writes_;
      if (phase.kind == Phase::Kind::reduce) send_to_all(write.field);
    }
    return is_up_to_date;
  }

 private:
  int& value(int process, FieldId field, int block) {
    return seen_[static_cast<std::size_t>(process)]
                [static_cast<std::size_t>(field * blocks_.count() + block)];
  }
  void write(int block, int number) {
    for (FieldId f = 0; f < fields_; ++f) value(block, f, block) = number;
  }
  void send_to_all(FieldId field) {
    for (int to = 0; to < blocks_.count(); ++to)
      for (int from = 0; from < blocks_.count(); ++from)
        value(to, field, from) = value(from, field, from);
  }
  std::vector<int> reached(int block, Reach reach) const {
    if (reach == Reach::own) return {block};
    if (reach == Reach::neighbours) return blocks_.neighbours[static_cast<std::size_t>(block)];
    std::vector<int> all;
    for (int other = 0; other < blocks_.count(); ++other) all.push_back(other);
    return all;
  }

  Blocks blocks_;
  int fields_, writes_ = 1;
  std::vector<std::vector<int>> seen_;  // [process][field, block]
};

}  // namespace

TEST(exchanges, send_what_is_read_of_other_blocks_once_after_each_write) {
  const auto phases = with_exchanges({per_block("read", {{a, Reach::neighbours}, {b}}, {{c}}),
                                      per_block("read again", {{a, Reach::neighbours}}, {{b}}),
                                      per_block("write", {}, {{a}}), per_block("own", {{a}}, {}),
                                      per_block("read", {{a, Reach::neighbours}}, {})});
  EXPECT_EQ(names_of(phases),
            (Names{"exchange", "read", "read again", "write", "own", "exchange", "read"}));
  ASSERT_EQ(phases[0].reads.size(), 1u);
  EXPECT_EQ(phases[0].reads[0].field, a);
  EXPECT_EQ(phases[0].reads[0].reach, Reach::neighbours);
}

TEST(exchanges, send_again_where_a_phase_reads_farther) {
  const auto phases = with_exchanges({per_block("read", {{a, Reach::neighbours}}, {}),
                                      per_block("read all", {{a, Reach::all}}, {}),
                                      per_block("read", {{a, Reach::neighbours}}, {})});
  EXPECT_EQ(names_of(phases), (Names{"exchange", "read", "exchange", "read all", "read"}));
  EXPECT_EQ(phases[2].reads[0].reach, Reach::all);
}

TEST(exchanges, reduce_phases_gather_and_spread_by_themselves) {
  const auto phases = with_exchanges({per_block("write", {}, {{a}}),
                                      reduce("fold", {{a, Reach::all}}, {{b, Reach::all}}),
                                      per_block("read", {{b, Reach::all}}, {})});
  EXPECT_EQ(names_of(phases), (Names{"write", "fold", "read"}));
}

TEST(exchanges, let_blocks_in_other_processes_see_what_they_would_see_in_one) {
  std::mt19937 random(3);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Phase> phases;
    for (int p = 0; p < 12; ++p) {
      const bool reduces = below(4) == 0;
      std::vector<Access> reads = {{below(3), reduces ? Reach::all : static_cast<Reach>(below(3))},
                                   {below(3), reduces ? Reach::all : static_cast<Reach>(below(3))}};
      std::vector<Access> writes = {{below(3), reduces ? Reach::all : Reach::own}};
      phases.push_back(reduces ? reduce("fold", reads, writes) : per_block("p", reads, writes));
    }
    Processes without(row_of_blocks(4), 3), with(row_of_blocks(4), 3);
    for (const Phase& phase : with_exchanges(phases)) ASSERT_TRUE(with.run(phase));
    bool is_up_to_date = true;
    for (const Phase& phase : phases) is_up_to_date = without.run(phase) && is_up_to_date;
    if (is_up_to_date) {
      EXPECT_EQ(with_exchanges(phases).size(), phases.size());
    }
  }
}

TEST(exchanges, are_part_of_a_step_graph_without_nodes_or_timers) {
  StepGraph graph({per_block("write", {}, {{a}}), per_block("read", {{a, Reach::neighbours}}, {})},
                  row_of_blocks(3), {"a"});
  EXPECT_EQ(names_of(graph.phases()), (Names{"write", "exchange", "read"}));
  EXPECT_EQ(graph.timer_names(), (Names{"write", "read"}));
  EXPECT_EQ(graph.nodes().size(), 6u);
  Workers workers(2);
  graph.run(workers);
  EXPECT_EQ(graph.record().phase_seconds.size(), 2u);
}

}  // namespace pliant::scheduler
