#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/engine/undeformed/loads.hpp"

/// Measurements of a block [0, 1] x [0, 1] (x [0, 1]) whose points X are now at x = F X.
namespace pliant::test {

template <int D>
using SquareMatrix = Eigen::Matrix<double, D, D>;
template <int D>
using Column = Eigen::Matrix<double, D, 1>;

/// A vector in the syntax of case files.
template <int D>
std::string list_of(const Column<D>& x) {
  std::string text;
  for (int a = 0; a < D; ++a) text += fmt::format("{}{:.17g}", a > 0 ? ", " : "[", x[a]);
  return text + "]";
}

template <int D>
Column<D> material_point() {
  return Eigen::Vector3d(0.3, 0.6, 0.45).head<D>();
}
template <int D>
Column<D> ray() {
  return Eigen::Vector3d(0.6, -0.8, 0).head<D>();
}

template <int D>
std::string homogeneous_measurements(const SquareMatrix<D>& f) {
  const std::string start = list_of<D>(material_point<D>());
  const std::string now = list_of<D>(f * material_point<D>());
  const std::string middle = list_of<D>(f * Column<D>::Constant(0.5));
  std::string text;
  for (const std::string field : {"strain_xy", "displacement_y", "stress_xx", "pressure"}) {
    text += measurement(
        field, "kind = \"material_value\"\npoint = " + start + "\nfield = \"" + field + "\"\n");
  }
  for (const std::string field : {"displacement_y", "stress_xx", "density"}) {
    text += measurement(field + "_here",
                        "kind = \"point_value\"\npoint = " + now + "\nfield = \"" + field + "\"\n");
  }
  return text +
         measurement("nowhere",
                     "kind = \"point_value\"\npoint = " + list_of<D>(Column<D>::Constant(9)) +
                         "\nfield = \"density\"\n") +
         measurement("mean_stress_xx",
                     "kind = \"mean_value\"\nfield = \"stress_xx\"\nwhere = \"x > 0.2\"\n") +
         measurement("volume", "kind = \"volume\"\n") +
         measurement("distance", "kind = \"surface_distance\"\npoint = " + middle +
                                     "\ndirection = " + list_of<D>(ray<D>()) +
                                     "\nreference = 0.1\n") +
         measurement("radius", "kind = \"mean_radius\"\npoint = " + middle + "\n");
}

/// How accurately the surface of a body follows its geometry [m].
constexpr double surface_tolerance = 1e-9;

/// Distance from the middle to the faces of the block along a direction.
template <int D>
double distance_from_middle(const SquareMatrix<D>& f, const Column<D>& direction) {
  return 0.5 / (f.inverse() * direction).cwiseAbs().maxCoeff();
}

template <int D>
void expect_homogeneous(pliant::Solver& solver, const SquareMatrix<D>& f, double tolerance) {
  auto found = values(solver);
  const SquareMatrix<D> strain = (f.transpose() * f - SquareMatrix<D>::Identity()) / 2;
  const Column<D> displacement = f * material_point<D>() - material_point<D>();
  EXPECT_NEAR(found["strain_xy"], strain(0, 1), tolerance);
  EXPECT_NEAR(found["displacement_y"], displacement[1], tolerance);
  EXPECT_NEAR(found["displacement_y_here"], displacement[1], tolerance);
  EXPECT_NEAR(found["density_here"], 1 / f.determinant(), tolerance);
  EXPECT_NEAR(found["volume"], f.determinant(), tolerance);
  EXPECT_GT(std::abs(found["stress_xx"]), 1);
  EXPECT_NEAR(found["stress_xx_here"], found["stress_xx"], 100 * tolerance);
  EXPECT_NEAR(found["mean_stress_xx"], found["stress_xx"], 100 * tolerance);
  EXPECT_TRUE(std::isnan(found["nowhere"]));
  EXPECT_NEAR(found["distance"], distance_from_middle<D>(f, ray<D>()) - 0.1, surface_tolerance);
  double radii = 0;
  for (int k = 0; k < 64; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / 64;
    Column<D> direction = Column<D>::Zero();
    direction[0] = std::cos(angle);
    direction[1] = std::sin(angle);
    radii += distance_from_middle<D>(f, direction) / 64;
  }
  EXPECT_NEAR(found["radius"], radii, surface_tolerance);
}

/// An initial velocity, and measurements of its difference from two formulas.
inline std::string velocity_errors(int dimension) {
  const std::string zero = dimension == 2 ? "" : ", 0";
  std::string text = "velocity = [\"3*y\", \"sin(x)\"" + zero + "]\n";
  for (const std::string name : {"exact", "offset"}) {
    const std::string shift = name == "exact" ? "" : " + 0.1";
    text += measurement(name, "kind = \"velocity_error\"\nreference = 2\nexact = [\"3*y" + shift +
                                  "\", \"sin(x)\"" + zero + "]\n");
  }
  return text;
}

inline void expect_velocity_errors(pliant::Solver& solver) {
  auto found = values(solver);
  EXPECT_NEAR(found["exact"], 0, 1e-15);
  EXPECT_NEAR(found["offset"], 0.05, 1e-15);
}

}  // namespace pliant::test
