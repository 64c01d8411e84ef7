#include "scheduler/dependencies.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <tuple>

#include "tests/scheduler/phases.hpp"

namespace pliant::scheduler {

namespace {

using namespace testing;

constexpr FieldId a = 0, b = 1;
const std::vector<std::string> names{"a", "b"};

// An edge, by (phase, block) of its ends; junctions have block -1.
using End = std::tuple<int, BlockId>;
using Ends = std::set<std::pair<End, End>>;

Ends edges_of(const std::vector<Phase>& phases, const Blocks& blocks) {
  const auto derived = derive_dependencies(phases, blocks, names);
  Ends result;
  for (const Edge& edge : derived.edges) {
    const Node& from = derived.nodes[static_cast<std::size_t>(edge.from)];
    const Node& to = derived.nodes[static_cast<std::size_t>(edge.to)];
    result.insert({{from.phase, from.block}, {to.phase, to.block}});
  }
  return result;
}

std::string complaint_about(const std::vector<Phase>& phases, const Blocks& blocks) {
  try {
    derive_dependencies(phases, blocks, names);
  } catch (const std::invalid_argument& refusal) {
    return refusal.what();
  }
  return "";
}

}  // namespace

TEST(dependencies, a_reader_follows_the_writer_of_its_own_block) {
  const Ends expected{{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}};
  EXPECT_EQ(
      edges_of({per_block("write", {}, {{a}}), per_block("read", {{a}}, {})}, row_of_blocks(2)),
      expected);
}

TEST(dependencies, a_writer_follows_the_readers_since_the_last_write) {
  const Ends expected{{{0, 0}, {1, 0}}};
  EXPECT_EQ(
      edges_of({per_block("read", {{a}}, {}), per_block("write", {}, {{a}})}, row_of_blocks(1)),
      expected);
}

TEST(dependencies, a_writer_follows_the_last_writer) {
  const Ends expected{{{0, 0}, {1, 0}}};
  EXPECT_EQ(
      edges_of({per_block("first", {}, {{a}}), per_block("second", {}, {{a}})}, row_of_blocks(1)),
      expected);
}

TEST(dependencies, phases_that_touch_different_fields_or_only_read_are_independent) {
  EXPECT_TRUE(
      edges_of({per_block("one", {{b}}, {{a}}), per_block("two", {{b}}, {})}, row_of_blocks(3))
          .empty());
}

TEST(dependencies, an_edge_that_follows_from_others_is_left_out) {
  // The write of a in phase 0 is overwritten in phase 2 after the reader in phase 1.
  const Ends expected{{{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}};
  EXPECT_EQ(edges_of({per_block("write", {}, {{a}}), per_block("read", {{a}}, {{b}}),
                      per_block("again", {{b}}, {{a}})},
                     row_of_blocks(1)),
            expected);
}

TEST(dependencies, reading_neighbours_follows_their_writers_and_own) {
  const Ends expected{{{0, 0}, {1, 0}}, {{0, 1}, {1, 0}}, {{0, 0}, {1, 1}}, {{0, 1}, {1, 1}},
                      {{0, 2}, {1, 1}}, {{0, 1}, {1, 2}}, {{0, 2}, {1, 2}}};
  EXPECT_EQ(
      edges_of({per_block("write", {}, {{a}}), per_block("read", {{a, Reach::neighbours}}, {{b}})},
               row_of_blocks(3)),
      expected);
}

TEST(dependencies, a_reduce_phase_that_reaches_all_stands_between_all_blocks) {
  const Ends expected{{{0, 0}, {1, 0}}, {{0, 1}, {1, 0}}, {{0, 2}, {1, 0}},
                      {{1, 0}, {2, 0}}, {{1, 0}, {2, 1}}, {{1, 0}, {2, 2}}};
  EXPECT_EQ(
      edges_of({per_block("write", {}, {{a}}), reduce("fold", {{a, Reach::all}}, {{b, Reach::all}}),
                per_block("use", {{b}}, {})},
               row_of_blocks(3)),
      expected);
}

TEST(dependencies, a_reduce_phase_without_reach_accesses_block_zero) {
  const Ends expected{{{0, 0}, {1, 0}}};
  EXPECT_EQ(edges_of({reduce("set", {}, {{a}}), per_block("use", {{a}}, {})}, row_of_blocks(3)),
            expected);
}

TEST(dependencies, a_phase_has_nodes_only_where_it_has_work) {
  Phase partial = per_block("ghosts", {{a}}, {{b}});
  partial.blocks = {2};
  const std::vector<Phase> phases{per_block("write", {}, {{a}}), partial,
                                  per_block("read", {{b, Reach::neighbours}}, {})};
  const Ends expected{{{0, 2}, {1, 2}}, {{1, 2}, {2, 1}}, {{1, 2}, {2, 2}}};
  EXPECT_EQ(edges_of(phases, row_of_blocks(3)), expected);
  EXPECT_EQ(derive_dependencies(phases, row_of_blocks(3), names).nodes.size(), 3u + 1u + 3u);
}

TEST(dependencies, blocks_that_each_read_all_share_a_junction) {
  const int count = 20;
  const auto derived = derive_dependencies(
      {per_block("write", {}, {{a}}), per_block("read", {{a, Reach::all}}, {{b}}),
       per_block("write again", {}, {{a}})},
      row_of_blocks(count), names);
  // Two junctions, each with an edge from every block and an edge to every block.
  EXPECT_EQ(derived.nodes.size(), 3u * count + 2u);
  EXPECT_EQ(derived.edges.size(), 4u * count);
}

TEST(dependencies, reduce_phases_run_even_without_blocks) {
  const auto derived = derive_dependencies(
      {per_block("write", {}, {{a}}), reduce("fold", {{a, Reach::all}}, {})}, Blocks{}, names);
  EXPECT_EQ(derived.nodes.size(), 1u);
}

TEST(dependencies, an_exchange_has_no_node_and_neither_runs_nor_writes) {
  const Phase exchange = {.name = "exchange",
                          .reads = {{a, Reach::neighbours}},
                          .kind = Phase::Kind::exchange,
                          .run = {}};
  const auto derived = derive_dependencies(
      {per_block("write", {}, {{a}}), exchange, per_block("read", {{a, Reach::neighbours}}, {})},
      row_of_blocks(2), names);
  EXPECT_EQ(derived.nodes.size(), 4u);
  EXPECT_EQ(derived.edges.size(), 4u);
  Phase writes = exchange, runs = exchange;
  writes.writes = {{b}};
  runs.run = do_nothing;
  EXPECT_NE(complaint_about({writes}, row_of_blocks(2)).find("only sends"), std::string::npos);
  EXPECT_NE(complaint_about({runs}, row_of_blocks(2)).find("only sends"), std::string::npos);
}

TEST(dependencies, edges_tell_every_field_that_causes_them) {
  const auto derived =
      derive_dependencies({per_block("write", {}, {{b}, {a}}), per_block("read", {{a}, {b}}, {})},
                          row_of_blocks(1), names);
  EXPECT_EQ(derived.edges, (std::vector<Edge>{{0, 1, a}, {0, 1, b}}));
}

TEST(dependencies, a_phase_whose_blocks_disturb_each_other_is_refused_with_a_remedy) {
  const auto in_place =
      complaint_about({per_block("smooth", {{a, Reach::neighbours}}, {{a}})}, row_of_blocks(2));
  EXPECT_NE(in_place.find("smooth writes a of block"), std::string::npos) << in_place;
  EXPECT_NE(in_place.find("write another field"), std::string::npos) << in_place;
  EXPECT_NE(complaint_about({per_block("scatter", {}, {{a, Reach::all}})}, row_of_blocks(2)), "");
  // A reduce phase, or a phase on a single block, has no other calls to conflict with.
  EXPECT_EQ(
      complaint_about({reduce("smooth", {{a, Reach::all}}, {{a, Reach::all}})}, row_of_blocks(2)),
      "");
  EXPECT_EQ(complaint_about({per_block("smooth", {{a, Reach::all}}, {{a, Reach::all}})},
                            row_of_blocks(1)),
            "");
}

TEST(dependencies, what_does_not_exist_is_refused) {
  const Blocks blocks = row_of_blocks(2);
  Phase phase = per_block("p", {{7}}, {});
  EXPECT_NE(complaint_about({phase}, blocks).find("no field 7"), std::string::npos);
  phase = per_block("p", {}, {});
  phase.blocks = {0, 2};
  EXPECT_NE(complaint_about({phase}, blocks).find("no block 2"), std::string::npos);
  phase.blocks = {1, 1};
  EXPECT_NE(complaint_about({phase}, blocks).find("listed twice"), std::string::npos);
  phase = per_block("p", {}, {{a, Reach::neighbours}});
  EXPECT_NE(complaint_about({phase}, blocks), "");
  phase = per_block("p", {}, {}, nullptr);
  EXPECT_NE(complaint_about({phase}, blocks).find("no function"), std::string::npos);
  EXPECT_NE(complaint_about({}, Blocks{{{1}, {2}}}).find("block 2"), std::string::npos);
}

}  // namespace pliant::scheduler
