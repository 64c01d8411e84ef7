#include "engine/total_lagrangian/fitted_cells.hpp"

#include <algorithm>
#include <vector>

namespace pliant::total_lagrangian {

template <class T, int D>
Eigen::Matrix<double, D, D> shape_of(const Body<T, D>& body, const Cell<D>& cell) {
  const auto corners = body.corners(cell);
  return shape_of<D>(corners, body.moments(corners[0]), body.lattice.spacing,
                     [&](std::int64_t slot) { return column<D>(body.shift(slot)); });
}

namespace {

// [slot] whether a wall holds a particle in all directions.
template <class T, int D>
std::vector<bool> held_wholly(const Body<T, D>& body) {
  std::vector<bool> held(body.layout.slots(), false);
  for (const auto& of_block : body.held) {
    for (const ConstrainedParticle<D>& particle : of_block) {
      held[particle.slot] = particle.normal == Point<D>{};
    }
  }
  return held;
}

}  // namespace

template <class T, int D>
void make_fitted_cells(Body<T, D>& body) {
  const std::vector<bool> held = held_wholly(body);
  for (const Block<D>& block : body.layout.blocks()) {
    body.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      body.regular_fraction[p] = body.fraction[p];
      if (!(body.fraction[p] > 0) || !body.is_fitted(cell)) return;
      body.regular_fraction[p] = 0;
      const Eigen::Matrix<double, D, D> a = shape_of<T, D>(body, cell), inverse = a.inverse();
      FittedCell<D> fitted = {};
      fitted.slot = p;
      fitted.volume = body.fraction[p] * a.determinant();
      for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) fitted.inverse[D * i + j] = inverse(i, j);
      }
      const auto corners = body.corners(cell);
      fitted.moves = !std::ranges::all_of(corners, [&](std::int64_t q) { return held[q]; });
      for (int m = 1; m < (1 << D); ++m) {
        if (kernels::directions_of[m] < 2) continue;
        for (int c = 0; c < (1 << D); ++c) {
          // The contributions of regular nodes cancel.
          const Point<D> shift = body.shift(corners[c]);
          for (int i = 0; i < D; ++i) fitted.start[i][m] += sign_of_mode(m, c) * shift[i];
        }
      }
      body.fitted.push_back(fitted);
    });
  }
}

template Eigen::Matrix2d shape_of<double, 2>(const Body<double, 2>&, const Cell<2>&);
template Eigen::Matrix3d shape_of<double, 3>(const Body<double, 3>&, const Cell<3>&);
template Eigen::Matrix2d shape_of<float, 2>(const Body<float, 2>&, const Cell<2>&);
template Eigen::Matrix3d shape_of<float, 3>(const Body<float, 3>&, const Cell<3>&);
template void make_fitted_cells<double, 2>(Body<double, 2>&);
template void make_fitted_cells<double, 3>(Body<double, 3>&);
template void make_fitted_cells<float, 2>(Body<float, 2>&);
template void make_fitted_cells<float, 3>(Body<float, 3>&);

}  // namespace pliant::total_lagrangian
