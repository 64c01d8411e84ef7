#pragma once

#include <Eigen/Dense>

#include "engine/total_lagrangian/body.hpp"

/// Cells with a corner that was moved from its lattice node, (TL.11).
namespace pliant::total_lagrangian {

/// A of (TL.11): the gradient over a cell of the places of its corners with respect to its nodes.
template <class T, int D>
Eigen::Matrix<double, D, D> shape_of(const Body<T, D>& body, const Cell<D>& cell);

/// Computes `fitted` and `regular_fraction` of a body from its fitted nodes.
template <class T, int D>
void make_fitted_cells(Body<T, D>& body);

}  // namespace pliant::total_lagrangian
