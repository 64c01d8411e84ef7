#pragma once

#include <Eigen/Dense>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/total_lagrangian/body.hpp"

/// Fits particles to the rims at which walls end on a free surface, (TL.11).
namespace pliant::total_lagrangian {

/// The particles of a body that leave their nodes, in the order of their slots. Reads the level
/// set, the particles and what walls hold of them.
template <class T, int D>
std::vector<FittedNode<D>> fit_to_rims(const Boundaries<D>& boundaries, const Body<T, D>& body);

/// A of (TL.11): the gradient over a cell of the places of its corners by those of its nodes.
template <class T, int D>
Eigen::Matrix<double, D, D> shape_of(const Body<T, D>& body, const Cell<D>& cell);

/// Fills in `fitted`, `first_fitted` and `regular_fraction` of a body from its fitted nodes.
template <class T, int D>
void make_fitted_cells(Body<T, D>& body);

}  // namespace pliant::total_lagrangian
