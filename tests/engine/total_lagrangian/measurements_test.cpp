#include "tests/engine/point_based/deformations.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"
#include "tests/engine/undeformed/closed_surface.hpp"
#include "tests/engine/undeformed/homogeneous.hpp"

namespace pliant::test {
namespace {

template <int D>
void measure_cells() {
  const SquareMatrix<D> f = some_deformation<D>();
  const std::string block = free_block(D) + velocity_errors(D);
  LagrangianSolver<D> solver(tests::read_text(block + homogeneous_measurements<D>(f)),
                             {1, kernels::widest_supported()});
  expect_velocity_errors(solver);
  auto& body = solver.state().bodies[0];
  for_each_particle<D>(body, [&](std::int64_t p, const Point<D>& x) {
    const Column<D> start = Eigen::Map<const Column<D>>(x.data());
    const Column<D> displacement = f * start - start;
    for (int a = 0; a < D; ++a) body.displacement[a][p] = displacement[a];
  });
  expect_homogeneous<D>(solver, f, 1e-10);
}

template <int D>
void expect_closed_surface_of_cells() {
  LagrangianSolver<D> solver(tests::read_text(free_block(D) + walls_of_corner(D)),
                             {1, kernels::widest_supported()});
  expect_closed(*solver.frame({.surface = true}).surface);
}

TEST(total_lagrangian, frames_have_closed_surfaces_where_walls_hold_bodies) {
  expect_closed_surface_of_cells<2>();
  expect_closed_surface_of_cells<3>();
}

TEST(total_lagrangian, measures_fields_and_surfaces_of_a_homogeneous_block) {
  measure_cells<2>();
  measure_cells<3>();
}

}  // namespace
}  // namespace pliant::test
