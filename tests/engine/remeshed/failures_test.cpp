#include <gtest/gtest.h>

#include "engine/method/step_failure.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Runs that fail say why, before they fill memory.
namespace pliant::test {
namespace {

/// The message of the failure within a hundred steps; empty if there is none.
std::string failure_of(Solver& solver) {
  try {
    advance(solver, 100);
  } catch (const StepFailure& failure) {
    return failure.what();
  }
  return "";
}

testing::AssertionResult holds(const std::string& text, const std::string& part) {
  if (text.find(part) != text.npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << text << "\nlacks\n" << part;
}

// CFL 2.9, as in the rotating cylinder at spacing 0.004 with its own step: lists of neighbours grew
// to all pairs of particles.
TEST(failures, of_an_unstable_step_name_the_limit_before_memory_is_full) {
  Solver solver(small_case("rotating_cylinder",
                           {"discretisation.spacing=0.02", "time.step=5e-3", "measurement=[]"}),
                {});
  const std::size_t bytes = solver.bytes();
  const std::string message = failure_of(solver);
  EXPECT_TRUE(holds(message, "body `cylinder` strained by "));
  EXPECT_TRUE(holds(message,
                    "; the time step 0.005 s is above the stability limit of 0.00292 s (CFL number "
                    "1.7); set time.step = \"cfl\", or to less than the limit"));
  // Lists of all neighbours within exp(0.56) times the support: 75 neighbours of 12 bytes each,
  // compared with the 400 bytes of a slot.
  EXPECT_LT(solver.bytes(), 4 * bytes);
}

const std::string two_parts = R"(dimension = 2
[discretisation]
spacing = 0.1
[time]
end = 10
[remeshing]
every = 10
[[body]]
name = "pair"
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
geometry = { shape = "union", of = [
  { shape = "box", lower = [-3, 0], upper = [-2, 1] },
  { shape = "box", lower = [2, 0], upper = [3, 1] } ] }
)";

// The parts fly a thousand spacings in one step: a lattice that covers both would not fit into
// memory.
TEST(failures, of_parts_that_fly_apart_name_the_body) {
  Solver solver(tests::read_text(two_parts, {"body.pair.velocity=[\"x > 0 ? 1e9 : -1e9\", \"0\"]"}),
                {});
  EXPECT_TRUE(holds(failure_of(solver),
                    "the particles of body `pair` have flown too far apart for one "
                    "lattice; use a smaller time step (time.cfl), "));
}

// No shorter step would help against what a wall that holds the body tears off at its edge.
TEST(failures, beside_a_wall_do_not_advise_a_smaller_step) {
  Solver solver(
      tests::read_text(tests::block_case +
                           "[[boundary]]\nname = \"clamp\"\nkind = \"fixed\"\ngeometry = { shape = "
                           "\"half_space\", point = [0, 0.5], normal = [0, 1] }\n",
                       {"discretisation.spacing=0.05"}),
      {});
  Body& body = solver.state().bodies[0];
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>& cell) {
    const Point<2> x = body.lattice.node(cell);
    if (std::hypot(x[0] - 0.975, x[1] - 0.525) < 0.03) {
      body.stage[0].get(Field::velocity, 1)[p] = std::nan("");
    }
  });
  const std::string message = failure_of(solver);
  EXPECT_TRUE(holds(message, "beside a wall that holds it; load more slowly, or use a finer "));
  EXPECT_EQ(message.find("smaller"), message.npos) << message;
}

}  // namespace
}  // namespace pliant::test
