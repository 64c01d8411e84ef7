#pragma once

#include <array>
#include <cstdint>

#include "kernels/hyperelastic_material.hpp"
#include "kernels/layout.hpp"
#include "kernels/remeshed/stage/relaxation.hpp"

/// What the kernels of the total Lagrangian method work on. Particles are the slots of a lattice in
/// the undeformed body; a stress point is the middle of the cell whose lowest corner is its slot.
namespace pliant::kernels {

/// The number of directions in which a mode of a cell's 2^D corner values changes sign, (TL.2): a
/// mode has a bit for each. One direction: a gradient mode; more: an hourglass mode.
inline constexpr int directions_of[] = {0, 1, 1, 2, 1, 2, 2, 3};

/// Rows of corners of a cell: row r holds corners 2 r and 2 r + 1. Corner c lies one slot up in
/// every direction whose bit of c is set.
template <int D>
inline constexpr int corner_rows = 1 << (D - 1);

/// Coefficients of the energy of hourglass modes, over 2 W1 J^(-2/3)/2.
template <class T>
struct HourglassStiffness {
  T modes = 0;    ///< kappa of (TL.6), for modes of two directions
  T triple = 0;   ///< kappa for the mode of three directions; 3D
  T bending = 0;  ///< what modes that bend a cell have more than those that twist it, (TL.17); 3D
  T saddle = 0;   ///< coupling of the two modes that bend it across one plane, (TL.17); 3D
};

/// A run of cells along x that a block evaluates for its particles. Each cell at the rim of a block
/// is evaluated by every block with particles at its corners, so that its forces stay in the
/// block's scratch memory.
template <int D>
struct CellRun {
  std::int64_t first;  ///< slot, a multiple of slots_per_pack
  std::int32_t count;  ///< slots, a multiple of slots_per_pack
  bool follows;        ///< whether the cell before the first has corners in the run's first pack
  bool own;            ///< whether the cells belong to the block
  std::array<std::int64_t, corner_rows<D>> row;     ///< slots from a cell to its rows of corners
  std::array<std::int64_t, corner_rows<D>> target;  ///< those corners of the first cell, counted
                                                    ///< from the block's first slot; -1: not in it
};

/// A cell of which a corner has left its lattice node X0 for another place X of the undeformed
/// body, (TL.11).
template <class T, int D>
struct FittedCell {
  std::int64_t slot;
  std::array<std::int64_t, corner_rows<D>> row;  ///< slots from it to its rows of corners
  T volume;                                      ///< f det A: that of the body in the cell over h^D
  T inverse[D * D];                              ///< A^-1, row by row
  T start[D][1 << D];  ///< [component][mode] q_b(X) of the hourglass modes [m]
};

/// The p_i of (RP.10) at the stress points of a body; a body without Prony terms has none.
template <class T>
struct CellViscosity {
  int terms = 0;
  const Relaxation<T>* relaxation = nullptr;  ///< [term], since the last stress
  const T* const* pressure = nullptr;         ///< [term][slot] p_i at the last stress [Pa]
  T* const* next_pressure = nullptr;          ///< [term][slot] p_i at this stress [Pa]
  const T* volume_change = nullptr;           ///< [slot] J - 1 at the last stress
  T* next_volume_change = nullptr;            ///< [slot] J - 1 at this stress
};

/// Components of the tensors of a network: xx, xy, yy, zz in plane strain, else symmetric_index.
template <int D>
inline constexpr int network_components = D == 2 ? 4 : 6;

/// The networks of (TL.24) at the stress points of a body; a body without Prony terms of its shear
/// modulus has none.
template <class T>
struct CellNetworks {
  int terms = 0;
  const Relaxation<T>* relaxation = nullptr;  ///< [term], since the last stress; of a modulus of 1
  const T* ratio = nullptr;                   ///< [term] g_i over the share that does not relax
  /// [tensor * network_components + component][slot] at the last stress: A_i - I for each term,
  /// then J^(2/3) C^-1 - I.
  const T* const* tensor = nullptr;
  T* const* next_tensor = nullptr;  ///< the same at this stress
};

/// The stress at the cells around the particles of a block, (TL.3)-(TL.6), and the motion of these
/// particles, (TL.5), (TL.8). Reads `displacement`, `fraction` and the viscosity also in
/// neighbouring blocks, and writes where no block reads.
template <class T, int D>
struct Motion {
  const CellRun<D>* runs;
  int run_count;
  const FittedCell<T, D>* fitted;      ///< of the body
  const std::int32_t* fitted_numbers;  ///< those with corners in the block
  int fitted_count;
  std::int64_t first_slot, slot_count;  ///< of the block, multiples of slots_per_pack
  T spacing;
  HourglassStiffness<T> hourglass;
  bool examine;  ///< whether to look for the wave speed and for states that are not possible
  bool damped;   ///< whether to sum what damping depends on
  T kept;        ///< share of the velocity that damping leaves, (TL.8)
  T gained;      ///< velocity per force over mass [s], (TL.8)
  T time_step;
  HyperelasticMaterial<T> material;  ///< coefficients without the share that relaxes, (TL.24)
  CellViscosity<T> viscosity;
  CellNetworks<T> networks;
  const T* fraction;  ///< [slot] share of the cell that the body fills; 0 in fitted cells
  /// [slot] S0 of (TL.14) at the stress points [Pa]; null: none.
  std::array<const T*, symmetric_components<D>> initial_stress;
  const T* inverse_mass;                 ///< [slot], 0 where there is no particle [1/kg]
  std::array<const T*, D> displacement;  ///< d
  std::array<const T*, D> traction;      ///< force on the particle from outside [N], or nullptr
  std::array<T*, D> internal;            ///< force from the stress points, of this step [N]
  std::array<T*, D> velocity;
  std::array<T*, D> next_displacement;  ///< d at the end of the step
  /// [slot - first_slot] scratch memory for forces from the stress points: zero before and after.
  std::array<T*, D> force;

  bool has(std::int64_t slot) const { return slot >= first_slot && slot < first_slot + slot_count; }
};

struct MotionResult {
  double wave_speed = 0;         ///< largest c of (TL.9) [m/s]; 0 unless examined
  std::int64_t non_finite = -1;  ///< a slot whose stress is not finite or whose J <= 0, or -1
  /// Sums over the particles for the work of damping, and for adaptive damping (TL.10); 0 unless
  /// damped.
  double stiffness = 0;  ///< of v . (F_before - F) [W]
  double inertia = 0;    ///< of v . m v, without scaling of the mass [J]
  double damped = 0;     ///< the same with the mean of the velocities before and after the step [J]
};

}  // namespace pliant::kernels
