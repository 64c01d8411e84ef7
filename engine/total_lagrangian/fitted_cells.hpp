#pragma once

#include <Eigen/Dense>

#include "engine/lattice/column.hpp"
#include "engine/total_lagrangian/body.hpp"

/// Cells with a corner that was moved from its lattice node, (TL.11).
namespace pliant::total_lagrangian {

/// A of (TL.11): the mean gradient over the part of a cell with the moments `moment` of the places
/// of its corners with respect to its nodes. `shift_of(slot)` is how far a corner starts from its
/// node [m].
template <int D, class F>
Eigen::Matrix<double, D, D> shape_of(const std::array<std::int64_t, (1 << D)>& corners,
                                     const CellMoments<D>& moment, double spacing, F&& shift_of) {
  Eigen::Matrix<double, D, D> a = Eigen::Matrix<double, D, D>::Identity();
  for (int c = 0; c < (1 << D); ++c) {
    const Column<D> shift = shift_of(corners[c]);
    for (int j = 0; j < D; ++j) {
      a.col(j) += mean_slope<D>(moment, c, j) * 2 / ((1 << D) * spacing) * shift;
    }
  }
  return a;
}

/// The same for a cell of a body that is fitted.
template <class T, int D>
Eigen::Matrix<double, D, D> shape_of(const Body<T, D>& body, const Cell<D>& cell);

/// Computes `fitted` and `regular_fraction` of a body from its fitted nodes.
template <class T, int D>
void make_fitted_cells(Body<T, D>& body);

}  // namespace pliant::total_lagrangian
