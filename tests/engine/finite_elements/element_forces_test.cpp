#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>

#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/point_based/deformations.hpp"
#include "tests/engine/undeformed/forces.hpp"

// Forces of finite elements, compared with their energy, invariants, and exact solutions.
namespace pliant::test {
namespace {

template <class Dimension>
struct ElementForces : testing::Test {
  static constexpr int dimension = Dimension::value;
  using Matrix = Eigen::Matrix<double, dimension, dimension>;
  using Vector = Eigen::Matrix<double, dimension, 1>;

  TemporaryFolder folder;

  std::string text(const std::string& law = "neo_hookean", int cells = 4) const {
    const std::filesystem::path mesh = folder / "block.vtk";
    write(unit_block<dimension>(cells), mesh);
    const std::string block = meshed_block(mesh);
    if (law != "reduced_polynomial") return tests::with(block, "neo_hookean", law);
    return tests::with(tests::with(block, "model = \"neo_hookean\"",
                                   "model = \"reduced_polynomial\"\ncoefficients = [20, 5]\n"
                                   "compressibility = 0.02"),
                       "youngs_modulus = 100\npoissons_ratio = 0.3\n", "");
  }

  ElementSolver<dimension> solver(const std::string& text,
                                  std::vector<std::string> more = {}) const {
    more.emplace_back("time.step=1e-9");
    return ElementSolver<dimension>(read_meshed<dimension>(text, folder / "block.vtk", more),
                                    {1, kernels::widest_supported()});
  }

  static auto forces(ElementSolver<dimension>& solver) {
    return forces_on_nodes<dimension>(solver);
  }

  static std::vector<std::string> pressures() {
    return {"finite_elements.pressure=averaged", "finite_elements.pressure=plain"};
  }
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ElementForces, Dimensions);

TYPED_TEST(ElementForces, are_the_slope_of_the_energy) {
  constexpr int D = TypeParam::value;
  for (const char* law : {"neo_hookean", "st_venant_kirchhoff", "reduced_polynomial"}) {
    const std::string text = this->text(law);
    for (const std::string& pressure : this->pressures()) {
      auto solver = this->solver(text, {pressure});
      auto& body = solver.state().bodies[0];
      deform(body, some_deformation<TypeParam::value>(), 0.02);
      const auto force = this->forces(solver);
      double largest = 0;
      for (const auto& f : force) largest = std::max(largest, f.norm());
      for (const std::int64_t slot : {std::int64_t{0}, body.blocks[0].nodes / 2l}) {
        SCOPED_TRACE(law + (" " + pressure));
        expect_slope_of_energy<D>(solver, slot, force[slot], 1e-7 * largest);
      }
    }
  }
}

// (FE.8), in steps that move nothing: forces and energy after a sudden deformation are those of an
// elastic block with the relaxed modulus.
TYPED_TEST(ElementForces, relax_by_the_prony_series_of_the_bulk_modulus) {
  constexpr int D = TypeParam::value;
  constexpr double modulus = 100, ratio = 0.4, time = 1e-8, step = 1e-9;
  const auto text = [&](const std::string& compressibility) {
    return tests::with(this->text("reduced_polynomial"), "compressibility = 0.02", compressibility);
  };
  const std::vector<std::string> settings = {"finite_elements.integrator=kick_drift"};
  const auto energy_of = [&](const std::string& compressibility) {
    auto solver = this->solver(text(compressibility), settings);
    deform(solver.state().bodies[0], some_deformation<D>(), 0.02);
    return solver.integrals().strain_energy;
  };
  auto solver = this->solver(text("compressibility = 0.02\nprony = { ratios = [0.4], times = "
                                  "[1e-8], moduli = \"instantaneous\" }"),
                             settings);
  deform(solver.state().bodies[0], some_deformation<D>(), 0.02);
  for (int k = 0; k < 7; ++k) solver.step(HUGE_VAL);
  const auto relaxed = this->forces(solver);
  const double share = 1 - ratio + ratio * std::exp(-7 * step / time);
  auto elastic =
      this->solver(text(fmt::format("compressibility = {}", 2 / (modulus * share))), settings);
  deform(elastic.state().bodies[0], some_deformation<D>(), 0.02);
  const auto expected = this->forces(elastic);
  double largest = 0;
  for (const auto& f : expected) largest = std::max(largest, f.norm());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((relaxed[i] - expected[i]).norm(), 1e-6 * largest) << i;
  }
  const double soft = energy_of("compressibility = 2e9");
  const double of_volume = energy_of("compressibility = 0.02") - soft;
  const double age = 8 * step;  // `forces` has taken a step
  EXPECT_NEAR(solver.integrals().strain_energy,
              soft + (1 - ratio + ratio * std::exp(-2 * age / time)) * of_volume, 1e-6 * of_volume);
}

TYPED_TEST(ElementForces, neither_push_nor_turn_a_free_body) {
  constexpr int D = TypeParam::value;
  const std::string text = this->text();
  for (const std::string& pressure : this->pressures()) {
    auto solver = this->solver(text, {pressure});
    auto& body = solver.state().bodies[0];
    deform(body, some_deformation<TypeParam::value>(), 0.02);
    const auto force = this->forces(solver);
    SCOPED_TRACE(pressure);
    expect_no_push_and_no_turn<D>(body, force);
  }
}

TYPED_TEST(ElementForces, of_a_turned_body_vanish) {
  constexpr int D = TypeParam::value;
  typename TestFixture::Matrix turn;
  if constexpr (D == 2) {
    turn = Eigen::Rotation2Dd(2).toRotationMatrix();
  } else {
    turn = Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  }
  const std::string text = this->text();
  for (const std::string& pressure : this->pressures()) {
    auto solver = this->solver(text, {pressure});
    deform(solver.state().bodies[0], turn, 0);
    for (const auto& force : this->forces(solver)) EXPECT_LT(force.norm(), 1e-11);
  }
}

// The patch test: irregular elements in a homogeneous deformation, whose energy is that of (PB.6).
TYPED_TEST(ElementForces, hold_an_affine_deformation_with_forces_at_the_surface_alone) {
  constexpr int D = TypeParam::value;
  Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
  full.topLeftCorner<D, D>() = some_deformation<TypeParam::value>();
  const double j = full.determinant(), mu = 100 / 2.6, lambda = 100 * 0.3 / (1.3 * 0.4);
  const double energy = mu / 2 * ((full.transpose() * full).trace() - 3) - mu * std::log(j) +
                        lambda / 2 * (j - 1) * (j - 1);
  const std::string text = this->text();
  for (const std::string& pressure : this->pressures()) {
    auto solver = this->solver(text, {pressure});
    auto& body = solver.state().bodies[0];
    deform(body, some_deformation<TypeParam::value>(), 0);
    EXPECT_NEAR(solver.integrals().strain_energy, energy, 1e-12 * energy);
    EXPECT_NEAR(solver.integrals().volume, j, 1e-13);
    const auto force = this->forces(solver);
    int inside = 0;
    double largest = 0;
    body.for_each_node([&](std::int64_t s) {
      bool is_inside = true;
      for (int a = 0; a < D; ++a) {
        is_inside = is_inside && body.start[s][a] > 0 && body.start[s][a] < 1;
      }
      largest = std::max(largest, force[s].norm());
      if (!is_inside) return;
      ++inside;
      EXPECT_LT(force[s].norm(), 1e-11) << pressure;
    });
    EXPECT_GT(inside, 0);
    EXPECT_GT(largest, 1);
  }
}

// u = (x y, -(x^2 + y^2)/2) does not change volumes: its energy is that of 2 mu (eps : eps)/2 = 2
// mu y^2, whatever nu. Plain elements see spurious changes of volume: they lock. Averages see few,
// at the surface, and all elements see 7 % too much shear.
TYPED_TEST(ElementForces, of_averaged_pressure_do_not_lock) {
  const std::string text =
      tests::with(this->text("neo_hookean", 8), "poissons_ratio = 0.3", "poissons_ratio = 0.499");
  const double bend = 1e-5, exact = 2 * 100 / (2 * 1.499) * bend * bend / 12;
  std::vector<double> over;
  for (const std::string& pressure : this->pressures()) {
    auto solver = this->solver(text, {pressure});
    auto& body = solver.state().bodies[0];
    body.for_each_node([&](std::int64_t s) {
      const double x = body.start[s][0] - 0.5, y = body.start[s][1] - 0.5;
      body.displacement[0][s] = bend * x * y;
      body.displacement[1][s] = -bend * (x * x + y * y) / 2;
    });
    over.push_back(solver.integrals().strain_energy / exact);
  }
  EXPECT_LT(over[0], 1.5);
  EXPECT_GT(over[1], 4);
}

}  // namespace
}  // namespace pliant::test
