#pragma once

#include <array>
#include <cstdint>

#include "kernels/layout.hpp"
#include "kernels/material.hpp"
#include "kernels/remeshed/stage/relaxation.hpp"

/// What the kernels of the total Lagrangian method work on. Particles are the slots of a lattice in
/// the undeformed body; a stress point is the middle of the cell whose lowest corner is its slot.
namespace pliant::kernels {

/// Modes of a cell's 2^D corner values apart from their mean, numbered 1 .. 2^D - 1 by a bit for
/// each direction in which they change sign, (TL.2). Those of one bit are gradients, the others
/// hourglass modes. Arrays over modes leave out number 0.
template <int D>
inline constexpr int cell_modes = (1 << D) - 1;

/// The number of directions in which a mode changes sign: one in gradients, more in hourglass
/// modes.
inline constexpr int directions_of[] = {0, 1, 1, 2, 1, 2, 2, 3};

/// [component][mode - 1][slot]
template <class T, int D>
using ModeArrays = std::array<std::array<T*, cell_modes<D>>, D>;

/// A cell of which a corner has left its lattice node X0 for another place X of the undeformed
/// body, (TL.11).
template <class T, int D>
struct FittedCell {
  std::int64_t slot;
  T volume;            ///< f det A: that of the body in the cell over h^D
  T inverse[D * D];    ///< A^-1, row by row
  T start[D][1 << D];  ///< [component][mode] q_b(X) of the hourglass modes [m]
};

/// The p_i of (RP.10) at the stress points of a body; a body without Prony terms has none.
template <class T>
struct CellViscosity {
  int terms = 0;
  const Relaxation<T>* relaxation = nullptr;  ///< [term], since the last stress
  T* const* pressure = nullptr;               ///< [term][slot] p_i [Pa]
  T* volume_change = nullptr;                 ///< [slot] J - 1 at the last stress
};

/// Stress at the stress points of a block, (TL.3)-(TL.6): reads displacement also in neighbouring
/// blocks, writes `force` in every slot of the block, zero where the body is not.
template <class T, int D>
struct StressPoints {
  const Segment<D>* segments;
  int segment_count;
  const FittedCell<T, D>* fitted;
  int fitted_count;
  T spacing;
  T hourglass;   ///< kappa of (TL.6)
  bool examine;  ///< whether to look for the wave speed and for states that are not possible
  Material<T> material;
  CellViscosity<T> viscosity;
  const T* fraction;  ///< [slot] share of the cell that the body fills; 0 in fitted cells
  std::array<const T*, D> displacement;  ///< d
  ModeArrays<T, D> force;                ///< [N]
};

struct StressPointsResult {
  double wave_speed;        ///< largest c of (TL.9) [m/s]; 0 unless examined
  std::int64_t non_finite;  ///< a slot whose stress is not finite or whose J <= 0, or -1
};

/// Moves the particles of a block, (TL.5), (TL.8): reads `force` also in neighbouring blocks.
template <class T, int D>
struct Motion {
  const Segment<D>* segments;
  int segment_count;
  T kept;    ///< share of the velocity that damping leaves, (TL.8)
  T gained;  ///< velocity per force over mass [s], (TL.8)
  T time_step;
  const T* inverse_mass;             ///< [slot], 0 where there is no particle [1/kg]
  ModeArrays<const T, D> force;      ///< of the stress points
  std::array<const T*, D> traction;  ///< force on the particle from outside [N]
  std::array<T*, D> internal;        ///< force from the stress points, of this step [N]
  std::array<T*, D> velocity, displacement;
};

/// Sums over the particles of a block, for adaptive damping (TL.10).
struct MotionResult {
  double stiffness = 0;  ///< sum of v . (F_before - F) [W]
  double inertia = 0;    ///< sum of v . m v, without scaling of the mass [J]
};

}  // namespace pliant::kernels
