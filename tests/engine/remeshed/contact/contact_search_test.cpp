#include "engine/remeshed/contact/contact_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {
namespace {

constexpr double spacing = 0.1;

/// Two blocks of width 1, the upper one `gap` above the top of the lower one, y = 1, with the speed
/// `rise` upwards.
Solver blocks_apart(double gap, double rise = 0) {
  const auto block = [](const std::string& name, double bottom) {
    return "[[body]]\nname = \"" + name + "\"\ngeometry = { shape = \"box\", lower = [0, " +
           std::to_string(bottom) + "], upper = [1, " + std::to_string(bottom + 1) +
           "] }\nmaterial = { model = \"linear\", youngs_modulus = 100, poissons_ratio = 0.3, "
           "density = 2 }\n";
  };
  const Case settings =
      tests::read_text("discretisation = { spacing = 0.1 }\ntime = { end = 1 }\n" +
                       block("lower", 0) + block("upper", 1 + gap) + "velocity = [0, " +
                       std::to_string(rise) + "]\n[[contact]]\nbodies = [\"lower\", \"upper\"]\n");
  return Solver(settings, {1, kernels::Isa::sse2});
}

/// Calls f(foot, gap, area) for each contact point of a body.
template <class F>
void for_each_contact_point(const Body& body, F&& f) {
  for (const auto& ghosts : body.population.ghosts) {
    const auto& points = ghosts.contact_points;
    for (std::size_t i = 0; i < points.ghost.size(); ++i) {
      f(ghosts.foot[points.ghost[i]], points.gap[i], points.area[i]);
    }
  }
}

// Gaps follow from phi and its slopes (RP.61) at the particles; for plane surfaces phi is exact,
// and the slopes are to 2e-5. Areas are shares of one surface: away from corners they add up to its
// length.
TEST(contact_search, finds_the_gap_and_the_length_of_plane_surfaces_that_face_each_other) {
  for (const double gap : {0.0002, 0.0008}) {
    Solver solver = blocks_apart(gap);
    solver.step(1e-7);
    for (int b = 0; b < 2; ++b) {
      double length = 0;
      for_each_contact_point(solver.state().bodies[b],
                             [&](const Point<2>& foot, double found, double area) {
                               if (std::abs(foot[0] - 0.5) > 0.2) return;
                               EXPECT_NEAR(foot[1], b == 0 ? 1 : 1 + gap, 1e-6);
                               EXPECT_NEAR(found, gap, 2e-5 * spacing);
                               length += area;
                             });
      // Columns of ghosts between 0.3 and 0.7.
      EXPECT_NEAR(length, 0.4, spacing / 100) << "body " << b;
    }
  }
}

// Surfaces that pressed each other may stay in contact up to a tenth of a cell. Those that approach
// each other do not push before they touch.
TEST(contact_search, finds_no_push_where_bodies_are_more_than_a_hundredth_of_a_cell_apart) {
  for (const double gap : {0.0005, 0.002, 0.3, 3.}) {
    Solver solver = blocks_apart(gap, -0.1);
    solver.step(1e-7);
    double push = 0;
    for (const Body& body : solver.state().bodies) {
      for (const auto& ghosts : body.population.ghosts) {
        for (const auto& traction : ghosts.contact_points.traction) push += std::abs(traction[1]);
      }
    }
    EXPECT_EQ(push > 0, gap < 0.001) << gap;
  }
}

}  // namespace
}  // namespace pliant::test
