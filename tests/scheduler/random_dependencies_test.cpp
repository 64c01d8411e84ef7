#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

#include "scheduler/dependencies.hpp"
#include "tests/scheduler/phases.hpp"

// The reference does not track last writers and readers: it compares all pairs of (phase, block)
// calls, and checks whether both access the same value and one of them writes it.
namespace pliant::scheduler {

namespace {

using namespace testing;
using Reachable = std::vector<std::vector<bool>>;

struct Problem {
  std::vector<Phase> phases;
  Blocks blocks;
  std::vector<std::string> fields;
};

int below(std::mt19937& random, int bound) {
  return static_cast<int>(random() % static_cast<unsigned>(bound));
}

Problem random_problem(std::mt19937& random) {
  Problem problem;
  const int block_count = 1 + below(random, 7);
  const int field_count = 1 + below(random, 5);
  problem.fields.assign(static_cast<std::size_t>(field_count), "field");
  problem.blocks.neighbours.resize(static_cast<std::size_t>(block_count));
  for (int i = 0; i < block_count; ++i)
    for (int j = 0; j < i; ++j)
      if (below(random, 3) == 0) {
        problem.blocks.neighbours[static_cast<std::size_t>(i)].push_back(j);
        problem.blocks.neighbours[static_cast<std::size_t>(j)].push_back(i);
      }
  const int phase_count = 1 + below(random, 10);
  for (int p = 0; p < phase_count; ++p) {
    Phase phase = per_block("phase", {}, {});
    if (below(random, 4) == 0) phase.kind = Phase::Kind::reduce;
    for (int r = below(random, 3); r > 0; --r)
      phase.reads.push_back({below(random, field_count), static_cast<Reach>(below(random, 3))});
    for (int w = below(random, 3); w > 0; --w)
      phase.writes.push_back(
          {below(random, field_count), below(random, 5) == 0 ? Reach::all : Reach::own});
    if (phase.kind == Phase::Kind::per_block && below(random, 3) == 0)
      for (int b = 0; b < block_count; ++b)
        if (below(random, 2) == 0) phase.blocks.push_back(b);
    problem.phases.push_back(phase);
  }
  return problem;
}

using Values = std::set<std::pair<FieldId, BlockId>>;

Values values(const std::vector<Access>& accesses, BlockId block, const Blocks& blocks) {
  Values result;
  for (const Access& access : accesses) {
    result.insert({access.field, block});
    for (int other = 0; other < blocks.count(); ++other) {
      const auto& near = blocks.neighbours[static_cast<std::size_t>(block)];
      const bool is_near = std::find(near.begin(), near.end(), other) != near.end();
      if (access.reach == Reach::all || (access.reach == Reach::neighbours && is_near))
        result.insert({access.field, other});
    }
  }
  return result;
}

bool overlap(const Values& one, const Values& other) {
  return std::any_of(one.begin(), one.end(), [&](const auto& v) { return other.count(v) > 0; });
}

struct Call {
  int phase;
  BlockId block;
  Values reads, writes;
};

std::vector<Call> calls_of(const Problem& problem) {
  std::vector<Call> calls;
  for (int p = 0; p < static_cast<int>(problem.phases.size()); ++p) {
    const Phase& phase = problem.phases[static_cast<std::size_t>(p)];
    for (int b = 0; b < problem.blocks.count(); ++b) {
      const bool is_listed =
          phase.blocks.empty() ||
          std::find(phase.blocks.begin(), phase.blocks.end(), b) != phase.blocks.end();
      if (phase.kind == Phase::Kind::reduce ? b == 0 : is_listed)
        calls.push_back({p, b, values(phase.reads, b, problem.blocks),
                         values(phase.writes, b, problem.blocks)});
    }
  }
  return calls;
}

bool conflict(const Call& x, const Call& y) {
  return overlap(x.writes, y.writes) || overlap(x.writes, y.reads) || overlap(x.reads, y.writes);
}

void close(Reachable& reachable) {
  for (std::size_t k = 0; k < reachable.size(); ++k)
    for (std::size_t i = 0; i < reachable.size(); ++i)
      if (reachable[i][k])
        for (std::size_t j = 0; j < reachable.size(); ++j)
          if (reachable[k][j]) reachable[i][j] = true;
}

Reachable nothing_reachable(std::size_t count) {
  return Reachable(count, std::vector<bool>(count, false));
}

Reachable order_by_conflicts(const std::vector<Call>& calls) {
  auto result = nothing_reachable(calls.size());
  for (std::size_t i = 0; i < calls.size(); ++i)
    for (std::size_t j = i + 1; j < calls.size(); ++j)
      if (calls[i].phase != calls[j].phase && conflict(calls[i], calls[j])) result[i][j] = true;
  close(result);
  return result;
}

bool blocks_disturb_each_other(const std::vector<Call>& calls) {
  for (std::size_t i = 0; i < calls.size(); ++i)
    for (std::size_t j = i + 1; j < calls.size(); ++j)
      if (calls[i].phase == calls[j].phase && conflict(calls[i], calls[j])) return true;
  return false;
}

Reachable order_by_edges(const Dependencies& derived) {
  auto result = nothing_reachable(derived.nodes.size());
  for (const Edge& edge : derived.edges)
    result[static_cast<std::size_t>(edge.from)][static_cast<std::size_t>(edge.to)] = true;
  close(result);
  return result;
}

bool is_derivable(const Problem& problem) {
  try {
    derive_dependencies(problem.phases, problem.blocks, problem.fields);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace

TEST(random_dependencies, order_exactly_the_calls_that_conflict) {
  std::mt19937 random(1);
  int compared = 0;
  while (compared < 1000) {
    const Problem problem = random_problem(random);
    const auto calls = calls_of(problem);
    ASSERT_EQ(is_derivable(problem), !blocks_disturb_each_other(calls));
    if (!is_derivable(problem)) continue;
    ++compared;

    const auto derived = derive_dependencies(problem.phases, problem.blocks, problem.fields);
    const auto by_edges = order_by_edges(derived);
    const auto by_conflicts = order_by_conflicts(calls);
    std::vector<std::size_t> node_of_call;
    for (std::size_t n = 0; n < derived.nodes.size(); ++n)
      if (!derived.nodes[n].is_junction()) node_of_call.push_back(n);
    ASSERT_EQ(node_of_call.size(), calls.size());
    for (std::size_t i = 0; i < calls.size(); ++i) {
      ASSERT_EQ(derived.nodes[node_of_call[i]].phase, calls[i].phase);
      ASSERT_EQ(derived.nodes[node_of_call[i]].block, calls[i].block);
      for (std::size_t j = 0; j < calls.size(); ++j)
        ASSERT_EQ(by_edges[node_of_call[i]][node_of_call[j]], by_conflicts[i][j]);
    }
  }
}

TEST(random_dependencies, hold_no_edge_that_others_imply) {
  std::mt19937 random(2);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const Problem problem = random_problem(random);
    if (!is_derivable(problem)) continue;
    const auto derived = derive_dependencies(problem.phases, problem.blocks, problem.fields);
    const auto reachable = order_by_edges(derived);
    for (const Edge& edge : derived.edges) {
      ASSERT_LT(edge.from, edge.to);
      for (std::size_t via = 0; via < derived.nodes.size(); ++via)
        ASSERT_FALSE(reachable[static_cast<std::size_t>(edge.from)][via] &&
                     reachable[via][static_cast<std::size_t>(edge.to)]);
    }
  }
}

}  // namespace pliant::scheduler
