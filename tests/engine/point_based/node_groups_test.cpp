#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>

#include "engine/point_based/forces/node_groups.hpp"
#include "engine/point_based/forces/node_pressure.hpp"
#include "engine/point_based/forces/node_state.hpp"
#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/deformations.hpp"
#include "tests/engine/point_based/whole_runs.hpp"
#include "tests/engine/undeformed/forces.hpp"

// Irregular nodes of a nearly incompressible body.
namespace pliant::test {
namespace {

template <class Dimension>
struct NodeGroups : testing::Test {
  static constexpr int dimension = Dimension::value;
  TemporaryFolder folder;

  std::string text(const std::string& law) const {
    std::string text = tests::with(
        tests::with(meshed_block(folder / "block.vtk"), "finite_elements", "point_based"),
        "poissons_ratio = 0.3", "poissons_ratio = 0.49");
    if (law != "reduced_polynomial") return tests::with(text, "neo_hookean", law);
    return tests::with(tests::with(text, "model = \"neo_hookean\"",
                                   "model = \"reduced_polynomial\"\ncoefficients = [20, 5]\n"
                                   "compressibility = 0.002"),
                       "youngs_modulus = 100\npoissons_ratio = 0.49\n", "");
  }

  Case settings(const std::string& law) const {
    write(unit_block<dimension>(dimension == 2 ? 9 : 5), folder / "block.vtk");
    return read_meshed<dimension>(text(law), folder / "block.vtk", {"time.step=1e-9"});
  }

  static auto forces(PointSolver<dimension>& solver) { return forces_on_nodes<dimension>(solver); }
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NodeGroups, Dimensions);

TYPED_TEST(NodeGroups, have_forces_that_are_the_slope_of_the_energy_on_any_instruction_set) {
  constexpr int D = TypeParam::value;
  for (const char* law : {"neo_hookean", "st_venant_kirchhoff", "reduced_polynomial"}) {
    const Case settings = this->settings(law);
    for (const kernels::Isa isa : {kernels::Isa::sse2, kernels::Isa::avx2, kernels::Isa::avx512}) {
      if (!kernels::is_supported(isa)) continue;
      PointSolver<D> solver(settings, {1, isa});
      auto& body = solver.state().bodies[0];
      std::int64_t grouped = 0;
      body.for_each_node([&](std::int64_t slot) { grouped += body.share[slot] > 0 ? 1 : 0; });
      EXPECT_GT(grouped, body.particles / 2);
      deform(body, some_deformation<D>(), 0.01);
      const auto force = this->forces(solver);
      double largest = 0;
      for (const auto& f : force) largest = std::max(largest, std::abs(f[0]));
      for (const std::int64_t slot : {std::int64_t{0}, std::int64_t{3}, body.particles / 2}) {
        SCOPED_TRACE(law);
        expect_slope_of_energy<D>(solver, slot, force[slot], 1e-7 * largest);
      }
    }
  }
}

TYPED_TEST(NodeGroups, neither_push_nor_turn_a_free_body) {
  constexpr int D = TypeParam::value;
  PointSolver<D> solver(this->settings("neo_hookean"), {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  deform(body, some_deformation<D>(), 0.02);
  const auto force = this->forces(solver);
  expect_no_push_and_no_turn<D>(body, force);
}

// The stress of (PB.6) follows from the pressures of the nodes: with the same F everywhere, groups
// change nothing.
TYPED_TEST(NodeGroups, show_the_pressure_of_the_law_in_a_homogeneous_deformation) {
  constexpr int D = TypeParam::value;
  PointSolver<D> solver(this->settings("neo_hookean"), {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  deform(body, some_deformation<D>(), 0);
  const double j = some_deformation<D>().determinant(), mu = 100 / 2.98,
               lambda = 100 * 0.49 / (1.49 * 0.02);
  Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
  full.template topLeftCorner<D, D>() = some_deformation<D>();
  const double pressure = -mu / j * ((full * full.transpose()).trace() / 3 - 1) - lambda * (j - 1);
  for (const auto& block : body.blocks) {
    for (int i = 0; i < block.nodes; ++i) {
      const auto node = point_based::node_state(body, block, block.first + i);
      EXPECT_NEAR(node.pressure, pressure, 1e-9 * std::abs(pressure));
    }
  }
}

struct CutGroups : NodeGroups<std::integral_constant<int, 3>> {
  static std::string blade(const std::string& path, const std::string& end) {
    return "[[cut]]\nname = \"blade\"\nfrom = [-0.1, -0.1, 0.45]\nto = [-0.1, 1.1, 0.45]\npath = "
           "[\"" +
           path + "\", 0, 0]\nend = " + end + "\n";
  }
};

// A node of a group has the volume change of its group, and keeps it when a cut dissolves the
// group.
TEST_F(CutGroups, dissolve_where_a_cut_parts_them_and_inject_no_energy) {
  write(unit_block<3>(9), folder / "block.vtk");
  const Case settings =
      tests::read_text(text("neo_hookean") + blade("6e8*t", "2e-9"), {"time.step=1e-9"});
  PointSolver<3> solver(settings, {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  body.for_each_node([&](std::int64_t slot) {
    for (int i = 0; i < 3; ++i) {
      body.displacement[i][slot] = 0.02 * std::sin(3 * body.start[slot][(i + 1) % 3]);
    }
  });
  const auto grouped = [&] {
    std::int64_t count = 0;
    body.for_each_node([&](std::int64_t slot) { count += body.share[slot] > 0 ? 1 : 0; });
    return count;
  };
  const std::int64_t whole = grouped();
  const double before = solver.integrals().strain_energy;
  for (int step = 0; step < 3; ++step) solver.step(HUGE_VAL);
  EXPECT_LT(grouped(), whole);
  EXPECT_GT(grouped(), 0);
  // No group has nodes on both sides.
  std::map<std::int64_t, bool> is_above;
  body.for_each_node([&](std::int64_t slot) {
    if (!(body.share[slot] > 0)) return;
    const bool above = body.start[slot][2] > 0.45;
    EXPECT_EQ(is_above.emplace(point_based::first_of_group<3>(slot), above).first->second, above);
  });
  const double last = solver.integrals().strain_energy;
  EXPECT_LT(last, before * (1 + 1e-3));
  for (int step = 0; step < 100; ++step) solver.step(HUGE_VAL);
  EXPECT_LE(solver.integrals().strain_energy, last * (1 + 1e-9));
}

// A cube of Poisson's ratio 0.499 between plates that hold it took 1.10 of the energy. The total
// Lagrangian method has 0.08036 J with 20 cells across, and 1.03 of it with 8.
TEST(node_groups, keep_a_lattice_that_is_squeezed_from_locking) {
  PointSolver<3> solver(tests::read_text(R"toml(dimension = 3
method = "point_based"
discretisation = { spacing = 0.125, damping = "adaptive" }
time = { end = 0.4 }
[[body]]
name = "cube"
geometry = { shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] }
[body.material]
model = "reduced_polynomial"
coefficients = [2]
compressibility = 0.00100066711
density = 0.01
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [0, 1, 0] }
[[boundary]]
name = "plate"
kind = "moving_wall"
displacement = [0, "-0.1*min(t/0.2, 1)", 0]
geometry = { shape = "half_space", point = [0, 1, 0], normal = [0, -1, 0] }
)toml"),
                        {1, kernels::widest_supported()});
  advance_until(solver, 0.4);
  EXPECT_NEAR(solver.integrals().strain_energy, 0.08036, 0.03 * 0.08036);
}

TEST_F(CutGroups, continue_after_a_restart_to_the_same_bytes) {
  write(unit_block<3>(6), folder / "block.vtk");
  const std::string moving = tests::with(text("neo_hookean"), "name = \"block\"\n",
                                         "name = \"block\"\nvelocity = [\"2*z\", 0, 0]\n");
  const Case settings =
      tests::read_text(moving + blade("2.5*t", "0.5"), {"time.end=0.3", "output.every=0.125"});
  const FileContent through = result_of(settings, folder / "run", 1);
  EXPECT_EQ(result_of(settings, folder / "run", 2, true), through);
}

}  // namespace
}  // namespace pliant::test
