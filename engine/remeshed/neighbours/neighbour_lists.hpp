#pragma once

#include <cmath>

#include "engine/remeshed/state/body.hpp"

/// The parts of a search for neighbours by position, one after another.
namespace pliant::remeshed {

/// The site of a particle.
template <class T, int D>
SlotSite<D> site_of(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell) {
  SlotSite<D> site = {{}, {cell, static_cast<std::int32_t>(slot)}};
  for (int a = 0; a < D; ++a) {
    site.position[a] = cell[a] + body.stage[0].get(Field::drift, a)[slot] / body.lattice.spacing;
    const std::int32_t n = body.lattice.period[a];
    if (n == 0) continue;
    const double periods = std::floor(site.position[a] / n);
    site.position[a] -= periods * n;
    site.label.cell[a] -= static_cast<std::int32_t>(periods) * n;
  }
  return site;
}

/// Finds the places of the particles and ghosts of a block at the start of a step.
template <class T, int D>
void find_sites(Body<T, D>& body, int block);

/// Makes the cell list of a body from the sites of its blocks.
template <class T, int D>
void sort_sites(Body<T, D>& body);

/// Lists the neighbours of a block's interior particles within the search radius, in the order of
/// the stencil, if any of them is at least (reach + 1) h away on the lattice, or if `in_any_case`.
template <class T, int D>
void list_neighbours(Body<T, D>& body, int block, int reach, bool in_any_case);

extern template void find_sites<double, 2>(Body<double, 2>&, int);
extern template void find_sites<double, 3>(Body<double, 3>&, int);
extern template void sort_sites<double, 2>(Body<double, 2>&);
extern template void sort_sites<double, 3>(Body<double, 3>&);
extern template void list_neighbours<double, 2>(Body<double, 2>&, int, int, bool);
extern template void list_neighbours<double, 3>(Body<double, 3>&, int, int, bool);
extern template void find_sites<float, 2>(Body<float, 2>&, int);
extern template void find_sites<float, 3>(Body<float, 3>&, int);
extern template void sort_sites<float, 2>(Body<float, 2>&);
extern template void sort_sites<float, 3>(Body<float, 3>&);
extern template void list_neighbours<float, 2>(Body<float, 2>&, int, int, bool);
extern template void list_neighbours<float, 3>(Body<float, 3>&, int, int, bool);

}  // namespace pliant::remeshed
