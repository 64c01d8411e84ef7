#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/deformations.hpp"
#include "tests/engine/undeformed/closed_surface.hpp"
#include "tests/engine/undeformed/homogeneous.hpp"

namespace pliant::test {
namespace {

template <int D>
void measure_points() {
  const SquareMatrix<D> f = some_deformation<D>();
  const std::string block = free_points(D) + velocity_errors(D);
  PointSolver<D> solver(tests::read_text(block + homogeneous_measurements<D>(f)),
                        {1, kernels::widest_supported()});
  expect_velocity_errors(solver);
  deform<D>(solver.state().bodies[0], f, 0);
  expect_homogeneous<D>(solver, f, 1e-10);
}

template <int D>
void expect_closed_surface_of_points() {
  PointSolver<D> solver(tests::read_text(free_points(D) + walls_of_corner(D)),
                        {1, kernels::widest_supported()});
  expect_closed(*solver.frame({.surface = true}).surface);
}

TEST(point_based, frames_have_closed_surfaces_where_walls_hold_bodies) {
  expect_closed_surface_of_points<2>();
  expect_closed_surface_of_points<3>();
}

TEST(point_based, measures_fields_and_surfaces_of_a_homogeneous_block) {
  measure_points<2>();
  measure_points<3>();
}

}  // namespace
}  // namespace pliant::test
