#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Loads on a part of a face, (RP.78), at any place of their ends between the rows of particles.
namespace pliant::test {
namespace {

std::string block(double across, const std::string& lower, const std::string& upper) {
  return fmt::format(
      "discretisation = {{ spacing = \"1/{}\", damping = \"adaptive\" }}\ntime.end = 2\n[[body]]\n"
      "name = \"block\"\ngeometry = {{ shape = \"box\", lower = [{}], upper = [{}] }}\n"
      "material = {{ model = \"linear\", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 "
      "}}\n",
      across, lower, upper);
}

const std::string floor_below = half_space("floor", "kind = \"fixed\"\n", "[0, 0]", "[0, 1]");

std::string load(const std::string& kind, const std::string& value, const std::string& lower,
                 const std::string& upper) {
  return fmt::format(
      "[[boundary]]\nname = \"load\"\nkind = \"{0}\"\n{0} = {1}\ngeometry = {{ shape = \"box\", "
      "lower = [{2}], upper = [{3}] }}\n",
      kind, value, lower, upper);
}

// The total Lagrangian method gives 5.25e-4 m with 40 and 80 across. With 12 and 14 it was 1.3 and
// 1.7 times that.
TEST(partial_loads, push_a_block_sideways_as_in_the_total_lagrangian_method) {
  for (const int across : {12, 14, 16, 20}) {
    const std::vector<double> found = values_at_end(
        block(across, "-0.5, 0", "0.5, 0.5") + floor_below +
        load("traction", "[\"min(t, 1)\", 0]", "-3, 0.1", "3, 0.4") +
        measurement("top", "kind = \"point_displacement\"\npoint = [0.01, 0.47]\naxis = \"x\"\n"));
    EXPECT_NEAR(found[0], 5.25e-4, 0.1 * 5.25e-4) << across;
  }
}

// 0.00993 m by the total Lagrangian method with 80 across. With 8 it was 1.30 times that, with 12
// 0.91.
TEST(partial_loads, dent_a_block_as_in_the_total_lagrangian_method) {
  for (const int across : {12, 14, 20}) {
    const std::vector<double> found = values_at_end(
        block(across, "0, 0", "1, 1") + floor_below +
        load("pressure", "\"20*min(t, 1)\"", "0.3, 0.9", "0.7, 1.1") +
        measurement("dent", "kind = \"point_displacement\"\npoint = [0.5, 0.93]\naxis = \"y\"\n"));
    EXPECT_NEAR(found[0], -0.00993, 0.035 * 0.00993) << across;
  }
}

// Pressures on both sides balance. The closest point of a particle on the bisector of one corner
// was on the corner, so that the block slid by 0.04 m along its floor.
TEST(partial_loads, on_both_sides_do_not_move_a_block_along_its_floor) {
  const std::vector<double> found =
      values_at_end(block(10, "-0.5, 0", "0.5, 1") +
                    half_space("floor", "kind = \"slip_wall\"\n", "[0, 0]", "[0, 1]") +
                    load("pressure", "\"20*min(t, 1)\"", "-9, 0.85", "9, 9") +
                    measurement("along", "kind = \"centre_of_mass\"\naxis = \"x\"\n"));
  EXPECT_NEAR(found[0], 0, 1e-4);
}

// A block on a floor, pulled by a traction on its top and on strips of its sides. The two corners
// of the top are cut off differently where the sides are between rows of particles. The parts of
// their facets were loaded as one, along a mean normal, and the block bent by up to 0.5 of its
// extension.
TEST(partial_loads, pull_a_block_straight) {
  const auto place = [](const std::string& axis) {
    return measurement(
        axis, "kind = \"point_displacement\"\npoint = [0, 2.4]\naxis = \"" + axis + "\"\n");
  };
  // By the total Lagrangian method with 40 across.
  const std::map<double, double> extension = {{0.001, 0.01085}, {0.02, 0.01126}, {0.1, 0.01293}};
  for (const auto& [strip, right] : extension) {
    for (const double across : {10., 13.3, 16.6}) {
      const std::vector<double> found = values_at_end(
          block(across, "-0.5, 0", "0.5, 3") + floor_below +
          load("traction", "[0, \"5*min(t, 1)\"]", fmt::format("-9, {}", 3 - strip), "9, 9") +
          place("x") + place("y"));
      EXPECT_NEAR(found[0], 0, 0.03 * right) << strip << ", " << across;
      EXPECT_NEAR(found[1], right, 0.015 * right) << strip << ", " << across;
    }
  }
}

// In 3D by up to 0.27 of its extension, with 0.91 of its load.
TEST(partial_loads, pull_a_bar_straight_in_3d) {
  const std::string at_end = "kind = \"point_displacement\"\npoint = [1.6, 0.4, 0.4]\n";
  const std::vector<double> found = values_at_end<3>(R"toml(dimension = 3
discretisation = { spacing = "1/10", damping = "adaptive" }
time.end = 2
[[body]]
name = "bar"
geometry = { shape = "box", lower = [0, 0, 0], upper = [2, 0.8, 0.77] }
material = { model = "neo_hookean", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "wall"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] }
)toml" + load("traction", "[\"10*min(t, 1)\", 0, 0]", "1.9, -9, -9", "9, 9, 9") +
                                                     measurement("x", at_end + "axis = \"x\"\n") +
                                                     measurement("y", at_end + "axis = \"y\"\n") +
                                                     measurement("z", at_end + "axis = \"z\"\n"));
  EXPECT_NEAR(found[1], 0, 0.04 * found[0]);
  EXPECT_NEAR(found[2], 0, 0.04 * found[0]);
}

TEST(closest_points, of_particles_on_the_bisectors_of_corners_are_on_the_sides) {
  const Case settings = tests::read_text(block(10, "-0.5, 0", "0.5, 1"));
  const Solver solver(settings, {1, kernels::widest_supported()});
  const Body& body = solver.state().bodies[0];
  const double* phi = body.stage[0].get(Field::level_set);
  const auto& population = body.population;
  for (std::size_t r = 0; r < population.slot_of_record.size(); ++r) {
    const double depth = phi[population.slot_of_record[r]] / body.lattice.spacing;
    EXPECT_NEAR(population.surface_distance[r], depth, 0.02) << r;
  }
}

}  // namespace
}  // namespace pliant::test
