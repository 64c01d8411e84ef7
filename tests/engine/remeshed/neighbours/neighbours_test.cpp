#include "engine/remeshed/neighbours/neighbours.hpp"

#include <gtest/gtest.h>

#include <random>

#include "engine/remeshed/neighbours/stencil_reach.hpp"
#include "engine/remeshed/state/resources.hpp"
#include "tests/engine/remeshed/neighbours/neighbourhood.hpp"
#include "tests/engine/remeshed/snapshot.hpp"

namespace pliant::test {
namespace {

using kernels::Kernel;
using Search = remeshed::NeighbourSearch<double, 2>;

constexpr double never_so_much = 1;  // strain above which no stencil is trusted

template <class F>
void displace(Body& body, F&& place) {
  for (const Block<2>& block : body.population.layout.blocks()) {
    body.population.layout.for_each_slot(block, [&](std::int64_t p, const Cell<2>& cell) {
      if (body.population.kind[p] == Kind::vacant) return;
      const Point<2> node = body.lattice.node(cell), x = place(node);
      for (int a = 0; a < 2; ++a) {
        body.stage[0].get(Field::drift, a)[p] = x[a] - node[a];
      }
    });
  }
}

/// Searches for neighbours of the first body, whatever its strain.
void search(Solver& solver, std::uint64_t seed = 0) {
  Body& body = solver.state().bodies[0];
  Search search(solver.state(), solver.settings().discretisation.kernel);
  search.clear();
  body.neighbours.strain = never_so_much;
  ASSERT_TRUE(search.is_due(0));
  scheduler::StepGraph graph(search.phases(),
                             scheduler::Blocks{body.population.layout.neighbours()},
                             remeshed::resource::names());
  solver.workers().execute([&] { graph.run_serially(seed); });
}

/// Compares all neighbours of a body with a search over all pairs; returns how many particles had
/// lists.
int compare_with_trying_all(const Body& body, Kernel kernel, int periods) {
  const auto sites = sites_of(body);
  const int reach = kernels::stencil_reach(kernel);
  int count = 0;
  const auto& blocks = body.population.layout.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const bool has_lists = body.neighbours.blocks[b].are_listed;
    body.population.layout.for_each_slot(blocks[b], [&](std::int64_t p, const Cell<2>& cell) {
      if (body.population.kind[p] != Kind::interior) return;
      const Neighbours expected =
          found_by_trying_all(body, sites, {p, cell}, body.neighbours.radius, periods);
      if (has_lists) {
        EXPECT_EQ(listed(body, static_cast<int>(b), p), expected);
        ++count;
        return;
      }
      for (const auto& [offset, slot] : expected) {
        EXPECT_LE(std::max(std::abs(offset[0]), std::abs(offset[1])), reach);
      }
    });
  }
  return count;
}

/// Compressed to 60 %, sheared, and irregular.
Point<2> compressed(const Point<2>& x) {
  static std::mt19937 random(3);
  std::uniform_real_distribution<double> jitter(-0.01, 0.01);
  return {x[0] + 0.3 * x[1] + jitter(random), 0.6 * x[1] + jitter(random)};
}

TEST(neighbours, are_all_those_within_the_radius_of_irregular_strained_particles) {
  for (const char* kernel : {"quartic_spline", "compact"}) {
    Solver solver(
        small_case("rotating_cylinder", {"discretisation.spacing=0.1",
                                         std::string("discretisation.kernel=\"") + kernel + "\""}),
        {1, kernels::widest_supported()});
    Body& body = solver.state().bodies[0];
    displace(body, compressed);
    search(solver);
    EXPECT_GT(compare_with_trying_all(body, solver.settings().discretisation.kernel, 0), 250);
  }
}

TEST(neighbours, are_all_those_within_the_radius_where_only_some_blocks_have_strained) {
  Solver solver(small_case("compression_linear", {"discretisation.spacing=1/16"}),
                {1, kernels::widest_supported()});
  Body& body = solver.state().bodies[0];
  displace(body, [](const Point<2>& x) {
    return Point<2>{x[0], x[1] > 0.5 ? 0.5 + 0.6 * (x[1] - 0.5) : x[1]};
  });
  search(solver);
  const int count = compare_with_trying_all(body, Kernel::compact, 0);
  EXPECT_GT(count, 50);
  EXPECT_LT(count, body.population.particles - 50);
}

TEST(neighbours, are_found_across_periods_wherever_particles_have_wandered) {
  Solver solver(small_case("periodic_square", {"discretisation.spacing=1/16",
                                               "discretisation.kernel=quartic_spline_fit"}),
                {1, kernels::widest_supported()});
  Body& body = solver.state().bodies[0];
  std::mt19937 random(5);
  std::uniform_int_distribution<int> periods(-2, 2);
  displace(body, [&](const Point<2>& x) {
    constexpr double pi = 3.14159265358979323846;
    return Point<2>{x[0] + 0.1 * std::sin(2 * pi * x[0]) + periods(random),
                    x[1] + 0.1 * std::sin(2 * pi * (x[0] + x[1])) + periods(random)};
  });
  search(solver);
  EXPECT_EQ(compare_with_trying_all(body, Kernel::quartic_spline_fit, 6), 256);
}

TEST(neighbours, do_not_depend_on_the_order_of_the_search) {
  Solver solver(small_case("rotating_cylinder", {"discretisation.spacing=0.05",
                                                 "discretisation.kernel=quartic_spline_fit"}),
                {1, kernels::widest_supported()});
  Body& body = solver.state().bodies[0];
  displace(body, compressed);
  search(solver);
  const auto first = body.neighbours.blocks;
  ASSERT_GT(first.size(), 3u);
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    search(solver, seed);
    for (std::size_t b = 0; b < first.size(); ++b) {
      EXPECT_EQ(first[b].slot, body.neighbours.blocks[b].slot);
      EXPECT_EQ(first[b].offset, body.neighbours.blocks[b].offset);
    }
  }
}

TEST(neighbours, just_outside_the_stencil_are_measured) {
  Solver solver(small_case("rotating_cylinder", {"discretisation.spacing=0.1",
                                                 "discretisation.kernel=quartic_spline_fit"}),
                {1, kernels::widest_supported()});
  Body& body = solver.state().bodies[0];
  displace(body, compressed);
  double least = HUGE_VAL, measured = HUGE_VAL;
  const auto sites = sites_of(body);
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>& cell) {
    for (const Site& q : sites) {
      const Offset offset = {q.cell[0] - cell[0], q.cell[1] - cell[1]};
      if (std::max(std::abs(offset[0]), std::abs(offset[1])) != 3) continue;
      least = std::min(least, distance(body, p, q.slot, offset));
    }
  });
  for (std::size_t b = 0; b < body.population.layout.blocks().size(); ++b) {
    measured =
        std::min(measured, remeshed::closest_outside<double, 2>(body, static_cast<int>(b), 2));
  }
  EXPECT_LT(least, 2.5);
  EXPECT_NEAR(measured, least, 1e-12);
}

const Settings spinning_rubber = {
    "discretisation.spacing=0.1",
    "discretisation.kernel=quartic_spline_fit",
    "discretisation.dissipation=0",
    "remeshing.every=\"never\"",
    "time.step=1e-4",
    R"(body.cylinder.material={ model = "reduced_polynomial", coefficients = [40], compressibility = 0.002, density = 2 })"};

/// The phases of the first stage of a step.
scheduler::StepGraph first_stage_of(const Solver& solver) {
  std::vector<scheduler::Phase> phases;
  for (const scheduler::Phase& phase : solver.step_graph().phases()) {
    if (phase.stage == 0) phases.push_back(phase);
  }
  return {std::move(phases), solver.step_graph().blocks(), remeshed::resource::names()};
}

/// grad u of every interior particle in the first stage of a step, row by row: F is 1 before it,
/// and 1 + dt/2 grad u in Q2 after it. A whole step would search for neighbours first.
std::vector<std::array<double, 4>> gradients_of(const VectorExpression& velocity, bool by_search) {
  Solver solver(small_case("rotating_cylinder", spinning_rubber), {1, kernels::widest_supported()});
  Body& body = solver.state().bodies[0];
  const auto start = [&] {
    displace(body, [](const Point<2>& x) { return Point<2>{x[0], 0.6 * x[1]}; });
    for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>& cell) {
      const Point<2> x = body.position(p, cell);
      for (int a = 0; a < 2; ++a) {
        body.stage[0].get(Field::velocity, a)[p] = velocity[a](x[0], x[1], 0, 0);
      }
      for (int c = 0; c < 4; ++c) {
        body.stage[0].get(Field::material, c)[p] = c % 3 == 0 ? 1 : 0;
      }
      for (Buffer<double>& component : body.stress) component[p] = 0;
    });
  };
  start();
  if (by_search) body.neighbours.strain = never_so_much;
  advance(solver, 1);
  EXPECT_EQ(body.neighbours.are_listed, by_search);
  start();
  first_stage_of(solver).run(solver.workers());
  std::vector<std::array<double, 4>> gradients;
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    std::array<double, 4> gradient;
    for (int c = 0; c < 4; ++c) {
      const double before = c % 3 == 0 ? 1 : 0;
      gradient[c] = (body.stage[1].get(Field::material, c)[p] - before) * 2 / 1e-4;
    }
    gradients.push_back(gradient);
  });
  return gradients;
}

VectorExpression expressions(const std::string& x, const std::string& y) {
  return {Expression(x), Expression(y), Expression()};
}

TEST(neighbours, of_a_body_at_60_percent_of_its_height_give_exact_gradients_of_linear_fields) {
  const std::array<double, 4> exact = {30, -50, 20, -40};
  const auto gradients = gradients_of(expressions("30*x - 50*y", "20*x - 40*y"), true);
  ASSERT_GT(gradients.size(), 300u);
  for (const auto& gradient : gradients) {
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(gradient[c], exact[c], 1e-12 * 50);
  }
}

TEST(neighbours, that_the_stencil_of_such_a_body_misses_count) {
  const auto wave = expressions("sin(4*y)", "0");
  const auto searched = gradients_of(wave, true), stencil = gradients_of(wave, false);
  double largest = 0;
  for (std::size_t i = 0; i < searched.size(); ++i) {
    largest = std::max(largest, std::abs(searched[i][1] - stencil[i][1]));
  }
  EXPECT_GT(largest, 0.01) << "of 4";
}

/// Makes the next step search for neighbours, far beyond the stencil.
void demand_lists(Solver& solver) {
  constexpr double steps_of_skin = 6;
  for (Body& body : solver.state().bodies) {
    body.neighbours.strain = never_so_much;
    body.neighbours.strain_rate = 0.3 / (steps_of_skin * solver.time_step());
  }
}

TEST(neighbours, from_lists_give_the_bits_of_the_stencil) {
  const Settings wave = {R"--(body.medium.velocity=["sin(2*pi*x)*sin(2*pi*y)", "1"])--"};
  for (const char* name : {"rotating_cylinder", "compression_linear", "periodic_square"}) {
    const bool periodic = std::string(name) == "periodic_square";
    const Settings coarse = {"discretisation.spacing=1/16",
                             "discretisation.kernel=quartic_spline_fit", "time.step=5e-5",
                             "remeshing.every=8"};
    const Case settings = small_case(name, periodic ? coarse + wave : coarse);
    Solver stencil(settings, {1, kernels::widest_supported()});
    Solver lists(settings, {2, kernels::widest_supported()});
    for (int step = 0; step < 20; ++step) {
      demand_lists(lists);
      advance(stencil, 1);
      advance(lists, 1);
      if (lists.clock().steps_since_remeshing == 0) continue;
      const auto& blocks = lists.state().bodies[0].neighbours.blocks;
      ASSERT_TRUE(blocks[blocks.size() / 2].are_listed);
    }
    EXPECT_FALSE(stencil.state().bodies[0].neighbours.are_listed);
    EXPECT_EQ(stencil.clock().remeshings, 2);
    EXPECT_EQ(differences(snapshot_of(stencil), snapshot_of(lists)), std::vector<std::string>())
        << name;
  }
}

}  // namespace
}  // namespace pliant::test
