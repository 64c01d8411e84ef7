#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/deformations.hpp"

// The estimate of the highest frequency, which determines the time step, (PB.12).
namespace pliant::test {
namespace {

PointSolver<3> still_block(const std::vector<std::string>& more = {},
                           const std::string& cuts = "") {
  std::vector<std::string> settings = {"time.step=1e-9"};
  settings.insert(settings.end(), more.begin(), more.end());
  return PointSolver<3>(tests::read_text(free_points(3) + cuts, settings),
                        {1, kernels::widest_supported()});
}

/// The largest eigenvalue of the stiffness over the mass [1/s^2], by power iteration with
/// accelerations in steps so short that nothing moves.
template <int D>
double largest_frequency2(PointSolver<D>& solver) {
  constexpr double dt = 1e-9, small = 1e-6;
  auto& body = solver.state().bodies[0];
  double found = 0, size = 0;
  for (int iteration = 0; iteration < 60; ++iteration) {
    body.for_each_node([&](std::int64_t slot) {
      for (int a = 0; a < D; ++a) {
        double& u = body.velocity[a][slot];
        const double next = iteration == 0 ? std::sin(37. * slot + 5 * a) : u / size;
        body.displacement[a][slot] = small * next;
        u = 0;
      }
    });
    std::vector<Point<D>> before(body.slots);
    for (std::int64_t s = 0; s < body.slots; ++s) {
      for (int a = 0; a < D; ++a) before[s][a] = body.displacement[a][s];
    }
    solver.step(dt);
    double power = 0, square = 0;
    size = 0;
    body.for_each_node([&](std::int64_t slot) {
      for (int a = 0; a < D; ++a) {
        const double u = body.velocity[a][slot], d = before[slot][a];
        power -= body.mass[slot] * u / dt * d;
        square += body.mass[slot] * d * d;
        size = std::max(size, std::abs(u));
      }
    });
    found = power / square;
  }
  return found;
}

/// The default CFL number, 0.9, has a margin of 1/0.81. The estimate is least accurate for nearly
/// incompressible bodies: 1/1.056 of the truth on a lattice with nu = 0.45.
template <int D>
void expect_near_estimate(PointSolver<D>& solver, const std::string& what) {
  const double found = largest_frequency2(solver), estimate = solver.state().frequency2;
  EXPECT_LT(found, 1.06 * estimate) << what;
  EXPECT_GT(found, 0.55 * estimate) << what;
}

TEST(frequency, of_lattices_and_octrees_is_near_its_estimate) {
  for (const char* spacing : {"0.125", "0.14", "0.155"}) {
    auto solver = still_block(
        {std::string("discretisation.spacing=") + spacing, "material.rubber.poissons_ratio=0.45"});
    expect_near_estimate(solver, spacing);
  }
  auto octree = still_block({"point_based.nodes=octree", "point_based.coarsest_spacing=0.25"});
  expect_near_estimate(octree, "octree");
  PointSolver<2> plane(tests::read_text(free_points(2), {"time.step=1e-9"}),
                       {1, kernels::widest_supported()});
  expect_near_estimate(plane, "2D");
}

// Many large nodes pull at each small one: there the factor 2 for lattices is too small.
TEST(frequency, of_tetrahedra_of_unequal_size_is_near_its_estimate) {
  const TemporaryFolder folder;
  for (const double grading : {1., 2., 3.}) {
    BlockMesh<3> mesh = unit_block<3>(7);
    mesh.grading = grading;
    write(mesh, folder / "block.vtk");
    PointSolver<3> solver(read_meshed<3>(tests::with(meshed_block(folder / "block.vtk"),
                                                     "finite_elements", "point_based"),
                                         folder / "block.vtk", {"time.step=1e-9"}),
                          {1, kernels::widest_supported()});
    expect_near_estimate(solver, fmt::format("grading {}", grading));
  }
}

TEST(frequency, grows_where_cuts_cross_as_its_estimate_does) {
  auto solver = still_block({"material.rubber.poissons_ratio=0.45", "discretisation.spacing=0.155"},
                            R"toml([[cut]]
name = "one"
from = [-0.1, 0.42, -0.1]
to = [-0.1, 0.42, 0.6]
path = ["6e8*t", "1e8*t", "-1e8*t"]
end = 2e-9
[[cut]]
name = "two"
from = [0.41, -0.1, 0.45]
to = [0.53, -0.1, 1.1]
path = ["1e8*t", "6e8*t", 0]
end = 2e-9
)toml");
  const double whole = solver.state().frequency2;
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  EXPECT_GT(solver.state().frequency2, 1.2 * whole);
  expect_near_estimate(solver, "cut");
}

// All nodes of two layers see neighbours on one side only, and swing together: 2.5 to 2.9 of what
// the stiffest of them does alone. The default step is stable up to 1/0.81 of the estimate.
TEST(frequency, of_two_layers_lets_the_step_be_stable) {
  for (const char* ratio : {"0.3", "0.45"}) {
    const std::string nu = std::string("material.rubber.poissons_ratio=") + ratio;
    for (const char* upper : {"[1, 0.1, 1]", "[1, 0.1, 0.2]"}) {
      auto plate = still_block(
          {nu, "discretisation.spacing=0.1",
           std::string(R"(body.block.geometry={ shape = "box", lower = [0, 0, 0], upper = )") +
               upper + " }"});
      expect_near_estimate(plate, upper);
    }
    auto flap = still_block({nu, "discretisation.spacing=0.1"}, R"toml([[cut]]
name = "flap"
from = [-0.1, 0.833, 0.38]
to = [-0.1, 0.833, 1.2]
path = ["4.15e8*t", 0, 0]
end = 2e-9
)toml");
    for (int step = 0; step < 4; ++step) flap.step(HUGE_VAL);
    EXPECT_LT(0.81 * largest_frequency2(flap), flap.state().frequency2) << ratio;
  }
}

TEST(frequency, grows_with_compression_and_not_with_rotation) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const double mu = 100 / 2.6, lambda = 100 * 0.3 / (1.3 * 0.4);
  for (const double squeeze : {1., 0.5}) {
    auto solver = still_block();
    const double before = solver.state().frequency2;
    const Eigen::Vector3d stretch(squeeze, 1 / std::sqrt(squeeze), 1 / std::sqrt(squeeze));
    deform<3>(solver.state().bodies[0], turn * stretch.asDiagonal(), 0);
    solver.step(HUGE_VAL);
    // Waves along the axis of compression, with abs(cof F) = 1/squeeze.
    const double modulus = mu + (lambda + mu) / (squeeze * squeeze);
    EXPECT_NEAR(solver.state().frequency2 / before, modulus / (lambda + 2 * mu), 1e-9);
  }
}

TEST(frequency, sets_the_step_with_the_damping_that_shortens_it) {
  const std::vector<std::string> free_step = {"time.step=cfl"};
  auto plain = still_block(free_step);
  const double limit = 2 / std::sqrt(plain.state().frequency2);
  EXPECT_NEAR(plain.time_step(), 0.9 * limit, 1e-12 * limit);
  auto damped = still_block({"time.step=cfl", "point_based.stiffness_damping=0.003"});
  const double shorter = std::sqrt(limit * limit + 0.003 * 0.003) - 0.003;
  EXPECT_NEAR(damped.time_step(), 0.9 * shorter, 1e-12 * limit);
  // At the limit a mode of that frequency alternates: (PB.10) with the viscous stress of (PB.9).
  EXPECT_NEAR(shorter * shorter + 2 * 0.003 * shorter, limit * limit, 1e-12 * limit * limit);
}

}  // namespace
}  // namespace pliant::test
