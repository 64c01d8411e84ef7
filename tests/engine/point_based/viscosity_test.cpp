#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "engine/point_based/forces/node_state.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/deformations.hpp"
#include "tests/engine/point_based/whole_runs.hpp"

// Prony series of the bulk modulus, (PB.70), and of the shear modulus, (TL.24), at nodes.
namespace pliant::test {
namespace {

constexpr double ratios[] = {0.3, 0.2}, times[] = {0.5, 2};

/// The free block, of a material that relaxes by `series`.
std::string relaxing_points(int dimension, const std::string& series) {
  return tests::with(
      free_points(dimension),
      "model = \"neo_hookean\"\ndensity = 1\nyoungs_modulus = 100\npoissons_ratio = 0.3\n",
      "model = \"reduced_polynomial\"\ndensity = 1\ncoefficients = [10]\ncompressibility = 0.05\n" +
          series);
}

// After a sudden deformation of any size the deviatoric stress relaxes by its series, (TL.25), and
// the pressure by its own. With the leapfrog the deformation lasts half a step.
template <int D>
void check_relaxation(const std::string& moduli, const std::string& integrator, double bar,
                      double bulk_modulus = 40) {
  // Too heavy to move.
  const std::string text = tests::with(
      relaxing_points(D, "prony_shear = { ratios = [0.3, 0.2], times = [0.5, 2], moduli = \"" +
                             moduli + "\" }\nprony = { ratios = [0.4], times = [1], moduli = \"" +
                             moduli + "\" }\n"),
      "density = 1\n", "density = 1e20\n");
  PointSolver<D> solver(
      tests::read_text(text,
                       {"point_based.integrator=" + integrator, "time.step=0.01", "time.end=3",
                        fmt::format("material.rubber.compressibility={}", 2 / bulk_modulus)}),
      {1, kernels::widest_supported()});
  auto& body = solver.state().bodies[0];
  const Eigen::Matrix<double, D, D> f = some_deformation<D>();
  deform<D>(body, f, 0);
  Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
  full.template topLeftCorner<D, D>() = f;
  const double j = full.determinant();
  const Eigen::Matrix3d b = std::pow(j, -2. / 3) * full * full.transpose();
  const double sudden = moduli == "instantaneous" ? 10 : 10 / (1 - 0.3 - 0.2);
  const double sudden_bulk = moduli == "instantaneous" ? bulk_modulus : bulk_modulus / (1 - 0.4);
  for (const double t : {0.0, 0.1, 0.333, 1.0, 3.0}) {
    if (t > 0) advance_until<D>(solver, t);
    double share = 1, energy = 0.5;
    for (int i = 0; i < 2; ++i) {
      share -= ratios[i] * (1 - std::exp(-t / times[i]));
      energy += ratios[i] * std::exp(-t / times[i]);
    }
    const auto node = point_based::node_state(body, body.blocks[0], std::int64_t{5});
    const double left = std::exp(-t), of_bulk = sudden_bulk * (j - 1);
    EXPECT_NEAR(node.pressure, -of_bulk * (0.6 + 0.4 * left), bar * std::abs(of_bulk))
        << t << " " << moduli;
    for (int i = 0; i < D; ++i) {
      for (int k = i; k < D; ++k) {
        const double deviator =
            node.stress[kernels::symmetric_index<D>(i, k)] + (i == k ? node.pressure : 0);
        const double exact = 2 * sudden * share / j * (b(i, k) - (i == k ? b.trace() / 3 : 0));
        EXPECT_NEAR(deviator, exact, bar * sudden) << t << " " << i << k << " " << moduli;
      }
    }
    const double held =
        sudden * energy * (b.trace() - 3) + of_bulk * (j - 1) / 2 * (0.6 + 0.4 * left * left);
    EXPECT_NEAR(node.energy / body.volume[5], held, bar * held) << t;
  }
}

TEST(viscosity_of_points, the_stress_of_a_sudden_deformation_relaxes_by_both_prony_series) {
  for (const std::string moduli : {"instantaneous", "long_term"}) {
    check_relaxation<2>(moduli, "kick_drift", 1e-8);
    check_relaxation<3>(moduli, "kick_drift", 1e-8);
    check_relaxation<2>(moduli, "leapfrog", 0.005);
    check_relaxation<3>(moduli, "leapfrog", 0.005);
    // Nodes share the change of volume of their group, (PB.60).
    check_relaxation<3>(moduli, "kick_drift", 1e-8, 1000);
  }
}

// Networks whose links never break are elastic, and so are pressures that never relax.
TEST(viscosity_of_points, series_that_last_move_a_body_as_its_elastic_material_does) {
  const auto moved = [](const std::string& series) {
    PointSolver<3> solver(tests::read_text(relaxing_points(3, series) + tumbling,
                                           {"point_based.stabilisation=0", "time.step=0.004"}),
                          {1, kernels::widest_supported()});
    for (int step = 0; step < 40; ++step) solver.step(HUGE_VAL);
    const auto& body = solver.state().bodies[0];
    std::vector<double> found = {solver.integrals().strain_energy};
    body.for_each_node([&](std::int64_t slot) {
      for (int a = 0; a < 3; ++a) found.push_back(body.displacement[a][slot]);
    });
    return found;
  };
  const std::vector<double> elastic = moved("");
  const std::vector<double> lasting = moved(
      "prony_shear = { ratios = [0.1, 0.2], times = [1e12, 1e13], moduli = "
      "\"instantaneous\" }\nprony = { ratios = [0.3], times = [1e12], moduli = "
      "\"instantaneous\" }\n");
  ASSERT_EQ(lasting.size(), elastic.size());
  EXPECT_GT(elastic[0], 0.01);
  for (std::size_t i = 0; i < elastic.size(); ++i) EXPECT_NEAR(lasting[i], elastic[i], 1e-9) << i;
}

TEST(viscosity_of_points, bytes_do_not_depend_on_threads_and_restarts) {
  const TemporaryFolder folder;
  for (const std::string setting : {"precision=double", "precision=single"}) {
    const Case settings = tests::read_text(
        relaxing_points(3,
                        "prony_shear = { ratios = [0.3, 0.2], times = [0.02, 0.2] }\n"
                        "prony = { ratios = [0.1, 0.3], times = [0.05, 0.1] }\n") +
            tumbling + clamp,
        {"time.end=0.2", "output.every=0.0501", "discretisation.spacing=0.1", setting});
    const FileContent one = result_of(settings, folder / (setting + "1"), 1);
    EXPECT_EQ(result_of(settings, folder / (setting + "2"), 2), one) << setting;
    EXPECT_EQ(result_of(settings, folder / (setting + "1"), 2, true), one) << setting;
  }
}

}  // namespace
}  // namespace pliant::test
