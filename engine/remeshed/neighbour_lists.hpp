#pragma once

#include "engine/remeshed/body.hpp"

/// The parts of a search for neighbours in space, one after another.
namespace pliant::remeshed {

/// Where the particles and ghosts of a block are, at the start of a step.
template <class T, int D>
void find_sites(Body<T, D>& body, int block);

/// Makes the cell list of a body of the sites of its blocks.
template <class T, int D>
void sort_sites(Body<T, D>& body);

/// Lists the neighbours of a block's interior particles within the search radius, in the order of
/// the stencil, if any of them is (reach + 1) h or more away on the lattice.
template <class T, int D>
void list_neighbours(Body<T, D>& body, int block, int reach);

extern template void find_sites<double, 2>(Body<double, 2>&, int);
extern template void find_sites<double, 3>(Body<double, 3>&, int);
extern template void sort_sites<double, 2>(Body<double, 2>&);
extern template void sort_sites<double, 3>(Body<double, 3>&);
extern template void list_neighbours<double, 2>(Body<double, 2>&, int, int);
extern template void list_neighbours<double, 3>(Body<double, 3>&, int, int);

}  // namespace pliant::remeshed
