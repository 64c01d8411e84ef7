#include <gtest/gtest.h>

#include "tests/engine/remeshed/neighbours/neighbourhood.hpp"
#include "tests/invariants/sample_runs.hpp"

// No particle loses a neighbour, however large the strain between remeshings.
namespace pliant::test {
namespace {

struct NeighboursOfRuns : OfSampleRuns {};
INSTANTIATE_TEST_SUITE_P(runs, NeighboursOfRuns, testing::ValuesIn(sample_runs()), name_of);
INSTANTIATE_TEST_SUITE_P(listed_runs, NeighboursOfRuns, testing::ValuesIn(listed_runs()), name_of);

/// Number of particles within the support of a particle of the block that its sums miss.
int lost(const Body& body, int block, const std::vector<Site>& sites, kernels::Kernel kernel) {
  const bool has_lists = body.neighbours.are_listed && body.neighbours.blocks[block].are_listed;
  const int reach = kernels::stencil_reach(kernel);
  const int periods = body.lattice.period == Cell<2>{} ? 0 : 1;
  int count = 0;
  const Layout<2>& layout = body.population.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<2>& cell) {
    if (body.population.kind[p] != Kind::interior) return;
    const Neighbours met = has_lists ? listed(body, block, p) : Neighbours();
    for (const auto& neighbour :
         found_by_trying_all(body, sites, {p, cell}, kernels::support(kernel), periods)) {
      const Offset& offset = neighbour.first;
      count += has_lists ? !met.contains(neighbour)
                         : std::max(std::abs(offset[0]), std::abs(offset[1])) > reach;
    }
  });
  return count;
}

TEST_P(NeighboursOfRuns, are_all_met_in_every_step) {
  Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
  const Body& body = solver.state().bodies[0];
  int listed_steps = 0;
  for (int step = 1; step <= GetParam().steps; ++step) {
    advance(solver, 1);
    listed_steps += body.neighbours.are_listed;
    if (step == GetParam().middle) {
      EXPECT_EQ(body.neighbours.are_listed, GetParam().has_lists);
    }
    const auto sites = sites_of(body);
    for (int b = 0; b < static_cast<int>(body.population.layout.blocks().size()); ++b) {
      ASSERT_EQ(lost(body, b, sites, solver.settings().discretisation.kernel), 0)
          << "after step " << step;
    }
  }
  EXPECT_EQ(listed_steps > 20, GetParam().has_lists);
}

}  // namespace
}  // namespace pliant::test
