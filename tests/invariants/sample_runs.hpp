#pragma once

#include <gtest/gtest.h>

#include <ostream>

#include "tests/engine/remeshed/snapshot.hpp"

namespace pliant::test {

/// A short run of a small case through several remeshings: free surfaces, moving walls, periods;
/// both kinds of material.
struct SampleRun {
  const char* name;
  const char* of;
  Settings settings;
  int steps;
  int middle = 4;          ///< steps to the moment that the run is for
  bool has_lists = false;  ///< whether neighbours come from lists then

  Case settled() const { return small_case(of, settings); }
  friend std::ostream& operator<<(std::ostream& out, const SampleRun& run) {
    return out << run.name;
  }
};

inline std::vector<SampleRun> sample_runs() {
  const Settings disc = {"discretisation.spacing=0.06", "time.step=1e-3", "remeshing.every=5",
                         "remeshing.filter=0.2"};
  const Settings of_many_blocks = {"discretisation.spacing=0.03", "time.step=5e-4"};
  const Settings block = {"discretisation.spacing=1/16", "time.step=5e-5",
                          "remeshing.strain_threshold=0.02"};
  const Settings cell = {"discretisation.spacing=1/24", "remeshing.every=6",
                         "body.medium.velocity=[\"2*sin(2*pi*x)*sin(2*pi*y)\", \"1\"]"};
  // The ball as a disc, shortly before it hits the wall.
  const Settings ball = {
      "dimension=2",
      "discretisation.spacing=0.018",
      "time.step=5e-4",
      "remeshing.every=5",
      "body.ball.geometry={ shape = \"disc\", centre = [0, 0.28], radius = 0.28 }",
      "body.ball.velocity=[0, -1]",
      "boundary.wall.geometry={ shape = \"half_space\", point = [0, 0], normal = [0, 1] }",
      "measurement.height.point=[0, 0.25]",
      "measurement.height.direction=[0, 1]"};
  const Settings sliding = {"boundary.wall.friction=0.05", "body.ball.velocity=[0.2, -1]"};
  const Settings viscous = {
      "body.block.material={ model = \"reduced_polynomial\", coefficients = [2.2, 0, 55], density "
      "= "
      "1, compressibility = 0.02, prony = { ratios = [0.1, 0.2, 0.05, 0.1, 0.15], times = [1e-5, "
      "1e-3, 0.01, 0.1, 10] } }"};
  const Settings loaded = {
      "time.step=1e-3", "remeshing.every=7", "body.block.velocity=[0, 0]",
      "boundary=[{ name = \"push\", kind = \"pressure\", pressure = 5, geometry = "
      "{ shape = \"box\", lower = [-2, 0.9], upper = [2, 2] } }, { name = \"pull\", "
      "kind = \"traction\", traction = [9, 1], geometry = "
      "{ shape = \"box\", lower = [0.4, -0.5], upper = [2, 2] } }]"};
  // Different discs, shortly before they collide off their axis.
  const Settings discs = {
      "discretisation.spacing=0.05",
      "time.step=2e-3",
      "remeshing.every=5",
      "body.left.geometry.centre=[-0.503, 0.1]",
      "body.left.velocity=[2, 0.1]",
      "body.right.geometry.centre=[0.503, 0]",
      "body.right.material={ model = \"reduced_polynomial\", coefficients = [10], "
      "compressibility = 0.02, density = 2 }"};
  // Not in every step, so that there are steps between remeshings to test.
  const Settings scheme_of_the_paper = {"discretisation.kernel=quartic_spline",
                                        "discretisation.dissipation=0",
                                        "remeshing.every=3",
                                        "remeshing.volume=conserved",
                                        "level_set.reinitialise_every=5",
                                        "ghosts.treatment=averaged",
                                        "remeshed.gradient=normalised",
                                        "remeshed.reinitialisation=first_order",
                                        "remeshed.determinant=remeshed"};
  return {
      {"disc", "rotating_cylinder", disc, 22},
      {"disc_of_many_blocks", "rotating_cylinder", disc + of_many_blocks, 17},
      {"compression_linear", "compression_linear", block, 60},
      {"compression_hyperelastic", "compression_hyperelastic", block, 60},
      {"compression_viscous", "compression_hyperelastic", block + viscous, 60},
      {"loaded", "compression_linear", block + loaded, 22},
      {"periodic", "periodic_square", cell, 20},
      {"contact", "bouncing_ball", ball, 20},
      {"friction", "bouncing_ball", ball + sliding, 20},
      {"two_discs", "two_discs", discs, 20, 12},
      {"paper", "compression_hyperelastic", block + scheme_of_the_paper, 12},
      {"paper_periodic", "periodic_square", cell + scheme_of_the_paper, 16},
  };
}

/// Runs with so much strain between remeshings that neighbours come from lists, from `middle` on.
inline std::vector<SampleRun> listed_runs() {
  const Settings block = {"discretisation.spacing=1/16", "remeshing.strain_threshold=0.3",
                          "remeshing.deformation_threshold=1", "time.step=1.5e-4"};
  const Settings cell = {"discretisation.spacing=1/24", "remeshing.every=20",
                         "body.medium.velocity=[\"4*sin(2*pi*x)*sin(2*pi*y)\", \"1\"]"};
  return {
      {"listed_compression", "compression_hyperelastic", block, 92, 36, true},
      {"listed_periodic", "periodic_square", cell, 70, 12, true},
  };
}

/// A test that runs with each of them.
struct OfSampleRuns : testing::TestWithParam<SampleRun> {
  const std::vector<std::string> none = {};
};

inline std::string name_of(const testing::TestParamInfo<SampleRun>& run) { return run.param.name; }

}  // namespace pliant::test
