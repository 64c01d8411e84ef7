#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "scheduler/step_graph.hpp"
#include "tests/scheduler/phases.hpp"

namespace pliant::scheduler {

namespace {

using namespace testing;

StepGraph printed_graph() {
  auto advance = per_block("advance", {{0, Reach::neighbours}}, {{1}});
  advance.stage = 2;
  return {{advance, per_block("smooth \"all\"", {{1, Reach::all}}, {{0}}),
           reduce("fold", {{0, Reach::all}, {1}}, {})},
          row_of_blocks(6),
          {"velocity", "next velocity"}};
}

struct Names {
  std::set<std::string> declared, linked;
};

// A line that starts with `name [` declares a node; one with `name -> name [` links two nodes.
Names names_in(const std::string& dot) {
  Names names;
  std::istringstream lines(dot);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, second, third;
    words >> first >> second >> third;
    if (second == "->") names.linked.insert({first, third});
    if (second.starts_with("[") && first != "node") names.declared.insert(first);
  }
  return names;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST(printing, dot_is_well_formed_and_names_every_node_it_links) {
  const StepGraph graph = printed_graph();
  for (const Detail detail : {Detail::blocks, Detail::phases}) {
    const std::string dot = graph.dot(detail);
    EXPECT_EQ(count(dot, "{"), count(dot, "}"));
    EXPECT_EQ((count(dot, "\"") - count(dot, "\\\"")) % 2, 0u);
    const auto [declared, linked] = names_in(dot);
    EXPECT_FALSE(linked.empty());
    for (const auto& name : linked) EXPECT_TRUE(declared.count(name)) << name;
  }
}

TEST(printing, dot_shows_stages_fields_and_reach) {
  const std::string phases = printed_graph().dot(Detail::phases);
  EXPECT_NE(phases.find("advance[2]\\nreads velocity (neighbours)\\nwrites next velocity"),
            std::string::npos);
  EXPECT_NE(phases.find("phase_0 [shape=ellipse, label=\"exchange[2]\\nvelocity (neighbours)\"]"),
            std::string::npos)
      << phases;
  EXPECT_NE(phases.find("fold (reduce)"), std::string::npos) << phases;
  // Values that are read from all blocks come through an exchange.
  EXPECT_NE(phases.find("phase_1 -> phase_2 [label=\"next velocity\"]"), std::string::npos);
  EXPECT_NE(phases.find("phase_2 -> phase_3 [label=\"next velocity\"]"), std::string::npos);
  const std::string blocks = printed_graph().dot();
  EXPECT_NE(blocks.find("label=\"advance[2]\""), std::string::npos);
  EXPECT_NE(blocks.find("smooth \\\"all\\\""), std::string::npos);
}

TEST(printing, one_arrow_carries_every_field_that_causes_it) {
  const StepGraph graph({per_block("write", {}, {{0}, {1}}), per_block("read", {{0}, {1}}, {})},
                        row_of_blocks(1), {"a", "b"});
  EXPECT_NE(graph.dot().find("node_0 -> node_1 [label=\"a, b\"]"), std::string::npos);
}

TEST(printing, json_holds_the_same_graph) {
  const StepGraph graph = printed_graph();
  const auto json = nlohmann::json::parse(graph.json());
  EXPECT_EQ(json["fields"], (std::vector<std::string>{"velocity", "next velocity"}));
  EXPECT_EQ(json["blocks"], 6);
  ASSERT_EQ(json["phases"].size(), 5u);
  EXPECT_EQ(json["phases"][0]["kind"], "exchange");
  EXPECT_EQ(json["phases"][0]["reads"][0]["reach"], "neighbours");
  EXPECT_EQ(json["phases"][1]["kind"], "per_block");
  EXPECT_EQ(json["phases"][4]["kind"], "reduce");
  ASSERT_EQ(json["nodes"].size(), graph.nodes().size());
  std::vector<Edge> edges;
  for (const auto& edge : json["edges"])
    for (const std::string field : edge["fields"])
      edges.push_back({edge["from"], edge["to"], field == "velocity" ? 0 : 1});
  EXPECT_EQ(edges, graph.edges());
}

TEST(printing, phases_are_linked_through_junctions) {
  const StepGraph graph({per_block("write", {}, {{0}}), per_block("read", {{0, Reach::all}}, {})},
                        row_of_blocks(9), {"a"});
  EXPECT_EQ(graph.nodes().size(), 19u);
  EXPECT_EQ(graph.phase_edges(), (std::vector<Edge>{{0, 1, 0}, {1, 2, 0}}));
}

}  // namespace pliant::scheduler
