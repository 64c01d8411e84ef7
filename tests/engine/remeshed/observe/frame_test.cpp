
#include <gtest/gtest.h>

#include <set>

#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {
namespace {

struct Frames : testing::Test {
  Solver solver{
      small_case("rotating_cylinder", {"discretisation.spacing=0.1", "remeshing.every=4"}),
      {1, kernels::widest_supported()}};
  Frames() { advance(solver, 6); }

  static const std::vector<double>& values(const Frame& frame, const std::string& name) {
    for (const FrameField& field : frame.fields) {
      if (field.name == name) return std::get<std::vector<double>>(field.values);
    }
    throw std::out_of_range(name);
  }
};

TEST_F(Frames, hold_every_particle_once_where_it_is) {
  const Frame frame = solver.frame({});
  EXPECT_EQ(frame.time, solver.clock().time);
  EXPECT_EQ(frame.step, 6);
  const Body& body = solver.state().bodies[0];
  std::set<std::array<double, 3>> positions;
  for (std::size_t i = 0; i < frame.position.size(); i += 3) {
    positions.insert({frame.position[i], frame.position[i + 1], frame.position[i + 2]});
  }
  EXPECT_EQ(static_cast<std::int64_t>(positions.size()), solver.particles());
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>& cell) {
    const Point<2> x = body.position(p, cell);
    EXPECT_TRUE(positions.contains({x[0], x[1], 0}));
  });
}

TEST_F(Frames, have_a_stress_whose_trace_is_the_pressure) {
  const Frame frame = solver.frame({});
  const std::vector<double>&stress = values(frame, "stress"), &p = values(frame, "pressure");
  ASSERT_EQ(stress.size(), 6 * p.size());
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(stress[6 * i] + stress[6 * i + 1] + stress[6 * i + 2], -3 * p[i], 1e-13);
    EXPECT_EQ(stress[6 * i + 4], 0);
    EXPECT_EQ(stress[6 * i + 5], 0);
    largest = std::max(largest, std::abs(p[i]));
  }
  EXPECT_GT(largest, 0.01);
}

TEST_F(Frames, show_ghosts_on_demand) {
  const Frame alone = solver.frame({}), all = solver.frame({.ghosts = true});
  EXPECT_EQ(alone.fields.size(), all.fields.size());
  EXPECT_GT(all.position.size(), alone.position.size());
  EXPECT_GT(*std::max_element(values(all, "level_set").begin(), values(all, "level_set").end()),
            0.2);
  EXPECT_LT(*std::max_element(values(alone, "level_set").begin(), values(alone, "level_set").end()),
            0.0);
}

TEST_F(Frames, show_the_surface_on_demand) {
  EXPECT_FALSE(solver.frame({}).surface);
  const Frame frame = solver.frame({.surface = true});
  ASSERT_TRUE(frame.surface);
  const std::vector<double>& x = frame.surface->position;
  EXPECT_EQ(frame.surface->corners, 2);
  EXPECT_EQ(frame.surface->vertex.size(), x.size() / 3 * 2);
  for (std::size_t v = 0; v < x.size(); v += 3) {
    EXPECT_NEAR(std::hypot(x[v], x[v + 1]), 1, 0.05);
    EXPECT_EQ(x[v + 2], 0);
  }
}

}  // namespace
}  // namespace pliant::test
