#include "engine/remeshed/ghosts/ghost_fitter.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Fits of a ghost above the top, y = 1, of a block at rest. Each fit must be exact for the
// functions that it is made for, whatever its particles.
namespace pliant::test {
namespace {

constexpr double cell_size = 0.1;  // h
constexpr double ghost_height = 0.07;
// Coefficients below 1e2 add up to one.
constexpr double fit_tolerance = 1e-12;

using Ghosts = remeshed::BlockGhosts<double, 2>;
using Place = Point<2>;

/// A block of width 1 between y = `bottom` and 1.
Solver block_from(double bottom, const std::string& boundaries = "") {
  return Solver(
      tests::read_text("discretisation = { spacing = 0.1 }\ntime = { end = 1 }\n[[body]]\n"
                       "name = \"block\"\ngeometry = { shape = \"box\", lower = [0, " +
                       std::to_string(bottom) +
                       "], upper = [1, 1] }\nmaterial = { model = \"linear\", "
                       "youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }\n" +
                       boundaries),
      {1, kernels::Isa::sse2});
}

/// A wall on the half-space x < 0, or on another one with this normal.
std::string wall_at_origin(const std::string& kind, const std::string& normal) {
  return "[[boundary]]\nname = \"wall\"\nkind = \"" + kind +
         "\"\ngeometry = { shape = \"half_space\", point = [0, 0], normal = " + normal + " }\n";
}

struct Fitted {
  Ghosts ghosts;
  std::vector<std::int32_t> used;  ///< [slot]
  Place foot;
};

using Fitting = std::function<void(remeshed::GhostFitter<double, 2>& fitter, const Place& foot)>;

Fitted fitted_above(const Solver& solver, double x, const Fitting& fit) {
  const Body& body = solver.state().bodies[0];
  std::vector<double> distance(body.population.layout.slots());
  for_each(body.population, Kind::interior, [&](std::int64_t slot, const Cell<2>& cell) {
    distance[slot] = body.lattice.node(cell)[1] - 1;
  });
  remeshed::LevelSet<double, 2> level_set;
  level_set.use(distance.data(), {});
  Fitted fitted;
  fitted.ghosts.clear();
  fitted.used.assign(distance.size(), 0);
  fitted.foot = {x, 1};
  remeshed::GhostFitter<double, 2> fitter(
      body, body.population, fitted.ghosts, level_set, solver.state().boundaries, {},
      kernels::RemeshedTable<double, 2>::of(kernels::Isa::sse2), fitted.used.data());
  fit(fitter, fitted.foot);
  fitter.finish();
  return fitted;
}

/// The fit of a ghost straight above its foot point.
Fitted fitted_above(const Solver& solver, double x) {
  return fitted_above(solver, x, [](auto& fitter, const Place& foot) {
    remeshed::FitSite<2> site;
    site.ghost = {0, ghost_height / cell_size};
    site.normal = {0, 1};
    site.surface_distance = ghost_height / cell_size;
    fitter.fit(site, foot, nullptr, false);
  });
}

/// Calls f(place, linear, constrained, surface) with the coefficients of each particle in the fits.
template <class F>
void for_each_coefficient(const Solver& solver, const Fitted& fitted, F&& f) {
  const Body& body = solver.state().bodies[0];
  const auto& terms = fitted.ghosts.terms.at(0);
  for (std::int64_t k = 0; k < fitted.ghosts.begin.at(1); ++k) {
    const auto pair = fitted.ghosts.pairs[k];
    const Place x = body.lattice.node(body.population.layout.cell(kernels::record_of(pair)));
    const double r[] = {kernels::cells_along(pair, 0) + terms.start[0],
                        kernels::cells_along(pair, 1) + terms.start[1]};
    const auto c = kernels::fit_coefficients(terms, r, (x[1] - 1) / cell_size);
    f(x, c.linear, c.constrained, c.surface);
  }
}

double linear_function(const Place& x) { return 0.7 - 1.3 * x[0] + 2.1 * x[1]; }

void expect_exact_fits(const Solver& solver, const Fitted& fitted) {
  double linear = 0, constrained = 0, sum_of_constrained = 0, surface = 0;
  for_each_coefficient(solver, fitted, [&](const Place& x, double c, double b, double a) {
    linear += c * linear_function(x);
    surface += a * linear_function(x);
    constrained += b * (x[1] - 1);
    sum_of_constrained += b;
  });
  EXPECT_NEAR(linear, linear_function({fitted.foot[0], 1 + ghost_height}), fit_tolerance);
  EXPECT_NEAR(surface, fitted.ghosts.surface_sum[0] * linear_function(fitted.foot), fit_tolerance);
  EXPECT_NEAR(constrained, ghost_height, fit_tolerance);
  EXPECT_NEAR(sum_of_constrained, fitted.ghosts.constrained_sum[0], fit_tolerance);
}

TEST(ghost_fitter, is_exact_above_a_plane_surface) {
  const Solver solver = block_from(0);
  for (const double x : {0.35, 0.5, 0.62}) expect_exact_fits(solver, fitted_above(solver, x));
}

// At a corner there are fewer particles, all on one side.
TEST(ghost_fitter, is_exact_at_a_corner) {
  const Solver solver = block_from(0);
  expect_exact_fits(solver, fitted_above(solver, 0));
}

TEST(ghost_fitter, is_exact_where_it_looks_less_far_near_a_contact_wall) {
  const Solver free = block_from(0),
               solver = block_from(0, wall_at_origin("contact_wall", "[1, 0]"));
  const Fitted fitted = fitted_above(solver, 0.1);
  expect_exact_fits(solver, fitted);
  EXPECT_LT(fitted.ghosts.begin[1], fitted_above(free, 0.1).ghosts.begin[1]);
}

TEST(ghost_fitter, finds_no_traction_at_the_rim_of_a_wall) {
  const Solver solver = block_from(0, wall_at_origin("fixed", "[1, 0]"));
  const Fitted at_rim = fitted_above(solver, 0.05), far = fitted_above(solver, 0.5);
  EXPECT_EQ(at_rim.ghosts.surface_sum[0], 0);
  EXPECT_EQ(far.ghosts.surface_sum[0], 1);
  expect_exact_fits(solver, at_rim);
  expect_exact_fits(solver, far);
}

// One row of particles does not determine a plane: values are copied, and values that vanish at the
// surface stay proportional to the distance from it.
TEST(ghost_fitter, takes_fewer_terms_where_particles_lie_in_a_row) {
  const Solver solver = block_from(0.89);
  double sum = 0, constrained = 0;
  for_each_coefficient(solver, fitted_above(solver, 0.5),
                       [&](const Place& x, double c, double b, double) {
                         sum += c;
                         constrained += b * (x[1] - 1);
                       });
  EXPECT_NEAR(sum, 1, fit_tolerance);
  EXPECT_NEAR(constrained, ghost_height, fit_tolerance);
}

TEST(ghost_fitter, marks_the_particles_of_its_fits_and_no_others) {
  const Solver solver = block_from(0);
  const Fitted fitted = fitted_above(solver, 0.5);
  std::vector<std::int32_t> expected(fitted.used.size(), 0);
  for (std::int64_t k = 0; k < fitted.ghosts.begin[1]; ++k) {
    expected[kernels::record_of(fitted.ghosts.pairs[k])] = 1;
  }
  EXPECT_EQ(fitted.used, expected);
}

TEST(ghost_fitter, gives_all_particles_the_same_share_of_an_average) {
  const Solver solver = block_from(0);
  const Body& body = solver.state().bodies[0];
  const Fitted fitted = fitted_above(solver, 0.55, [&](auto& fitter, const Place&) {
    Cell<2> above = {};
    for_each(body.population, Kind::free_ghost, [&](std::int64_t, const Cell<2>& cell) {
      const Place x = body.lattice.node(cell);
      if (std::abs(x[0] - 0.55) < cell_size / 2 && x[1] > 1 && x[1] < 1 + cell_size) above = cell;
    });
    fitter.average(above);
  });
  const auto count = static_cast<double>(fitted.ghosts.begin.at(1));
  EXPECT_GT(count, 5);
  for_each_coefficient(solver, fitted, [&](const Place&, double c, double b, double) {
    EXPECT_NEAR(c, 1 / count, fit_tolerance);
    EXPECT_EQ(b, 0);
  });
}

}  // namespace
}  // namespace pliant::test
