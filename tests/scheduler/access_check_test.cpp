#include "scheduler/access_check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "scheduler/step_graph.hpp"
#include "tests/scheduler/phases.hpp"

namespace pliant::scheduler {

namespace {

using namespace testing;

enum : FieldId { a, b, list, field_count };
constexpr int block_count = 4;
constexpr std::size_t slots = 3;  // per block
const std::vector<std::string> names = {"a", "b", "list"};

/// Two arrays with some slots per block, and a list per block that grows and shrinks.
struct Memory {
  std::vector<double> a = std::vector<double>(block_count * slots, 0.5),
                      b = std::vector<double>(block_count * slots, 2.0);
  std::vector<std::vector<double>> list = std::vector<std::vector<double>>(block_count, {1, 2});
  std::vector<unsigned char> flag = std::vector<unsigned char>(block_count, 0);

  double* of(std::vector<double>& array, BlockId block) {
    return array.data() + static_cast<std::size_t>(block) * slots;
  }
  void add_to(FieldMemory& memory, FieldId field, BlockId block) {
    auto& own_list = list[static_cast<std::size_t>(block)];
    if (field == pliant::scheduler::a) memory.add(of(a, block), slots);
    if (field == pliant::scheduler::b) memory.add(of(b, block), slots);
    if (field == pliant::scheduler::list) {
      memory.add(own_list.data(), own_list.size());
      memory.add_flags(&flag[static_cast<std::size_t>(block)], 1);
    }
  }
};

using Work = std::function<void(Memory&, BlockId)>;
using MakePhases = std::function<std::vector<Phase>(Memory&)>;

std::vector<std::string> complaints(const MakePhases& make_phases) {
  const auto accesses = undeclared_accesses([&](AccessProbe& probe) {
    Memory memory;
    Workers workers(1);
    probe.watch(workers, [&](const StepGraph&, FieldId field, BlockId block, FieldMemory& of) {
      memory.add_to(of, field, block);
    });
    StepGraph graph(make_phases(memory), row_of_blocks(block_count), names);
    for (int step = 0; step < 2; ++step) graph.run(workers);
  });
  std::vector<std::string> texts;
  for (const UndeclaredAccess& access : accesses) texts.push_back(text(access));
  return texts;
}

std::vector<std::string> complaints(std::vector<Access> reads, std::vector<Access> writes,
                                    const Work& work) {
  return complaints([&](Memory& memory) {
    return std::vector{
        per_block("work", reads, writes, [&memory, work](BlockId block) { work(memory, block); })};
  });
}

using Texts = std::vector<std::string>;

void copy_from_left(Memory& m, BlockId block) {
  *m.of(m.b, block) = *m.of(m.a, std::max(block - 1, 0));
}

}  // namespace

TEST(access_check, declared_accesses_are_no_fault) {
  EXPECT_EQ(complaints({{a, Reach::neighbours}}, {{b}}, copy_from_left), Texts{});
  EXPECT_EQ(complaints({{a, Reach::all}}, {{b}}, copy_from_left), Texts{});
}

TEST(access_check, a_read_of_an_undeclared_field_is_found) {
  EXPECT_EQ(complaints({}, {{b}}, copy_from_left),
            Texts{"phase work on block 0 reads a of block 0 without declaring it"});
}

TEST(access_check, a_read_beyond_the_declared_reach_is_found) {
  EXPECT_EQ(complaints({{a}}, {{b}}, copy_from_left),
            Texts{"phase work on block 1 reads a of block 0 without declaring it"});
  EXPECT_EQ(complaints({{a, Reach::neighbours}}, {{b}},
                       [](Memory& m, BlockId block) {
                         *m.of(m.b, block) = *m.of(m.a, (block + 2) % block_count);
                       }),
            Texts{"phase work on block 0 reads a of block 2 without declaring it"});
}

TEST(access_check, an_undeclared_write_is_found) {
  EXPECT_EQ(complaints({{a}}, {{b}},
                       [](Memory& m, BlockId block) {
                         *m.of(m.b, block) = *m.of(m.a, block);
                         if (block == 2) m.of(m.a, block)[1] += 1;
                       }),
            Texts{"phase work on block 2 writes a of block 2 without declaring it"});
  EXPECT_EQ(
      complaints({}, {{b}},
                 [](Memory& m, BlockId block) { *m.of(m.b, (block + 1) % block_count) += 1; }),
      Texts{"phase work on block 0 writes b of block 1 without declaring it"});
}

TEST(access_check, lists_that_are_filled_anew_are_followed) {
  const Work fill = [](Memory& m, BlockId block) {
    auto& own = m.list[static_cast<std::size_t>(block)];
    own.assign(own.size() + 100, *m.of(m.a, block));
  };
  EXPECT_EQ(complaints({{a}}, {{list}}, fill), Texts{});
  EXPECT_EQ(complaints({{a}}, {}, fill),
            Texts{"phase work on block 0 writes list of block 0 without declaring it"});
  EXPECT_EQ(complaints({}, {{list}}, fill),
            Texts{"phase work on block 0 reads a of block 0 without declaring it"});
}

TEST(access_check, flags_that_decide_are_read) {
  EXPECT_EQ(complaints({}, {{b}},
                       [](Memory& m, BlockId block) {
                         if (m.flag[static_cast<std::size_t>(block)] == 0) *m.of(m.b, block) += 1;
                       }),
            Texts{"phase work on block 0 reads list of block 0 without declaring it"});
}

TEST(access_check, values_without_effect_are_not_read) {
  EXPECT_EQ(
      complaints({}, {{b}},
                 [](Memory& m, BlockId block) { *m.of(m.b, block) += 0 * *m.of(m.a, block); }),
      Texts{});
}

TEST(access_check, every_phase_and_field_is_found_once) {
  const auto found = complaints([](Memory& m) {
    return std::vector{per_block("first", {}, {{b}},
                                 [&m](BlockId block) {
                                   *m.of(m.b, block) += *m.of(m.a, block);
                                   m.list[static_cast<std::size_t>(block)][1] += 1;
                                 }),
                       reduce("second", {}, {{list, Reach::all}},
                              [&m](BlockId) { m.list[0][0] = *m.of(m.b, block_count - 1); })};
  });
  EXPECT_EQ(found, (Texts{"phase first on block 0 writes list of block 0 without declaring it",
                          "phase first on block 0 reads a of block 0 without declaring it",
                          "phase second on block 0 reads b of block 3 without declaring it"}));
}

TEST(access_check, a_read_that_shows_in_a_later_phase_is_found) {
  double kept = 0;
  EXPECT_EQ(complaints([&kept](Memory& m) {
              return std::vector{
                  reduce("first", {}, {}, [&m, &kept](BlockId) { kept = *m.of(m.a, 1); }),
                  per_block("second", {}, {{b}}, [](BlockId) {}),
                  per_block("third", {}, {{b}},
                            [&m, &kept](BlockId block) { *m.of(m.b, block) = kept; })};
            }),
            Texts{"phase first reads a of block 1 without declaring it"});
}

TEST(access_check, memory_that_fields_share_belongs_to_a_phase_that_declares_one_of_them) {
  const auto found = undeclared_accesses([&](AccessProbe& probe) {
    Memory m;
    Workers workers(1);
    probe.watch(workers, [&](const StepGraph&, FieldId field, BlockId block, FieldMemory& memory) {
      memory.add(m.of(field == list ? m.b : m.a, block), slots);
    });
    StepGraph graph({per_block("work", {{a}}, {{list}},
                               [&m](BlockId block) { *m.of(m.b, block) += *m.of(m.a, block); })},
                    row_of_blocks(block_count), names);
    graph.run(workers);
  });
  EXPECT_TRUE(found.empty());
}

TEST(access_check, a_node_that_throws_what_it_did_not_throw_has_read) {
  EXPECT_EQ(complaints({}, {{b}},
                       [](Memory& m, BlockId block) {
                         if (*m.of(m.a, block) != 0.5) throw std::runtime_error("disturbed");
                       }),
            Texts{"phase work on block 0 reads a of block 0 without declaring it"});
}

TEST(node_runner, runs_every_node_of_a_graph_in_a_legal_order) {
  struct Order : NodeRunner {
    std::vector<std::pair<int, BlockId>> nodes;
    void run(const StepGraph& graph, const Node& node) override {
      nodes.emplace_back(node.phase, node.block);
      graph.phases()[static_cast<std::size_t>(node.phase)].run(node.block);
    }
  } order;
  int calls = 0;
  StepGraph graph({per_block("write", {}, {{a}}, [&](BlockId) { ++calls; }),
                   per_block("read", {{a, Reach::all}}, {{b}}, [&](BlockId) { ++calls; })},
                  row_of_blocks(3), names);
  Workers workers(2);
  workers.delegate(&order);
  graph.run(workers);
  EXPECT_EQ(calls, 6);
  ASSERT_EQ(order.nodes.size(), 6u);
  for (int n = 0; n < 3; ++n)
    EXPECT_LT(order.nodes[static_cast<std::size_t>(n)].first, order.nodes[5].first);
  workers.delegate(nullptr);
  graph.run(workers);
  EXPECT_EQ(calls, 12);
  EXPECT_EQ(order.nodes.size(), 6u);
}

}  // namespace pliant::scheduler
