#pragma once

#include "engine/remeshed/state.hpp"

namespace pliant::remeshed {

/// What the boundaries impose at one moment.
template <int D>
struct BoundaryValues {
  std::vector<Point<D>> wall_velocity;
  std::vector<double> pressure;

  void evaluate(const Boundaries<D>& boundaries, double t);
};

/// Velocity and stress of a block's ghosts in stage buffer `stage` from the records of the surface
/// particles, (RP.34)-(RP.39).
template <class T, int D>
void fill_ghosts(Body<T, D>& body, int block, int stage, int parity,
                 const Boundaries<D>& boundaries, const BoundaryValues<D>& values,
                 GhostTreatment treatment, const kernels::Table<T, D>& kernels);

/// Density, material state and displacement of a block's ghosts by the linear fit (RP.32), and
/// v = h^d: what remeshing scatters.
template <class T, int D>
void fill_conserved(Body<T, D>& body, int block);

}  // namespace pliant::remeshed
