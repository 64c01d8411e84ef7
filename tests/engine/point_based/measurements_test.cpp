#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/deformations.hpp"
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

TEST(point_based, measures_fields_and_surfaces_of_a_homogeneous_block) {
  measure_points<2>();
  measure_points<3>();
}

}  // namespace
}  // namespace pliant::test
