#pragma once

#include "engine/remeshed/state/field_store.hpp"

/// The cost of one particle in one Runge-Kutta stage, from the equations and the list of fields;
/// docs/performance/step.md shows the sums. Ghosts, empty slots, remeshing and the level set are
/// overheads and do not count here.
namespace pliant::bench {

/// Additions, multiplications, divisions and roots count as one each, fused operations as two.
constexpr double flop_per_stage(kernels::Kernel kernel, kernels::Model model, int dimension = 2) {
  using kernels::Kernel;
  using kernels::Model;
  const bool plane = dimension == 2, deforms = carries_deformation(model);
  const int neighbours = kernel == Kernel::compact ? (plane ? 8 : 26) : (plane ? 24 : 92);
  // omega of (RP.15): s^2 1, 1/s 20, s 1, two cubes 12, the polynomial near zero 1; (RP.16): t 3,
  // series 4, powers 3; (RP.17): t 3, powers 2.
  const int omega = kernel == Kernel::quartic_spline ? 35 : kernel == Kernel::compact ? 5 : 10;
  // In 2D d 4, r^2 3, omega d 2, A 6, five differences 5, five times omega d (f_q - f_p) 20.
  // In 3D d 6, r^2 5, omega d 3, A 12, nine differences 9, three times omega d (u_q - u_p) 18,
  // A^-1 omega d 15, div sigma 18.
  const int pair = (plane ? 40 : 86) + omega;
  // In 2D A^-1 8, five gradients 30, div sigma 2; in 3D A^-1 30, three gradients 45.
  const int gradients = plane ? 40 : 75;
  const int dissipation = plane ? 70 : 170;                              // (RP.23)
  const int law = plane ? (deforms ? 120 : 45) : (deforms ? 300 : 120);  // rates and stress
  const int fields = plane ? (deforms ? 9 : 8) : (deforms ? 16 : 13);
  return neighbours * pair + gradients + dissipation + law + 3.5 * fields;  // (RP.21): 2, 2, 5, 5
}

template <int D>
constexpr double bytes_per_stage_in(kernels::Model model) {
  int state = 0;
  for (const remeshed::Declaration& f : remeshed::state_fields) {
    if (!remeshed::is_evolving(f) || f.field == remeshed::Field::drift) continue;
    state += remeshed::components<D>(f.rank, kernels::material_component_count<D>(model));
  }
  constexpr int stress = kernels::symmetric_components<D>, mass = 1, interior = 1;
  const double states_read = (1 + 2 + 3 + 3) / 4.0, states_written = (1 + 1 + 2 + 1) / 4.0;
  const double drifts_read = (1 + 2 + 1 + 2) / 4.0, drifts_written = 1;
  const double read = states_read * state + drifts_read * D + stress + mass + interior / 4.0;
  return sizeof(double) * (read + states_written * state + drifts_written * D + stress);
}

/// Values that a stage reads and writes, averaged over the four stages. The third overwrites Q0 and
/// Q2, the last Q0. For the drift, every stage except the first overwrites an older value.
constexpr double bytes_per_stage(kernels::Model model, int dimension = 2) {
  return dimension == 2 ? bytes_per_stage_in<2>(model) : bytes_per_stage_in<3>(model);
}

/// The cost of a node of the point-based method in one step.
struct NodeCost {
  double flop, bytes;
};

/// For a neo-Hookean material without viscosity, loads and cuts.
constexpr NodeCost point_based_cost(int dimension, int neighbours, int value_size) {
  const bool plane = dimension == 2;
  // d 3, d g^T 18, (V kappa w) d 4, B g 18, two sums 6; in 2D 2, 8, 3, 8, 4.
  const int bond = plane ? 25 : 49;
  // cof F 27, J 5, factor 4, P 27, V kappa A 6, B 63; the update 20.
  const int node = plane ? 65 : 152;
  // g, w and the position of the neighbour; V, V kappa, A, 1/m, and five vectors.
  const int bond_bytes = (dimension + 1) * value_size + 2;
  const int values = 3 + dimension * (dimension + 1) / 2 + 5 * dimension;
  return {static_cast<double>(neighbours * bond + node),
          static_cast<double>(neighbours * bond_bytes + values * value_size)};
}

/// The cost of a particle of the total Lagrangian method in one step, with the cell above it, for a
/// neo-Hookean material without viscosity, damping and loads.
constexpr NodeCost total_lagrangian_cost(int dimension, int value_size) {
  const bool plane = dimension == 2;
  // Modes 72, F 12, hourglass squares and their derivatives 156, cof F and J 32, the stress 81, its
  // modes 24, corner forces 66, their sums 24; the update 9. In 2D 16, 6, 6, 7, 56, 10, 8, 8, 6.
  const double flop = plane ? 123 : 476;
  // d, the next d, velocity (read and written) and force; 1/m and f.
  return {flop, static_cast<double>((5 * dimension + 2) * value_size)};
}

}  // namespace pliant::bench
