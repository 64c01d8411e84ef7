#pragma once

#include <array>
#include <cstdint>

#include "kernels/bulk_relaxation.hpp"
#include "kernels/hyperelastic_material.hpp"
#include "kernels/layout.hpp"
#include "kernels/networks.hpp"

/// Arguments of the kernels of the total Lagrangian method. Particles are the slots of a lattice in
/// the undeformed body. A stress point is the middle of a cell; its slot is the cell's lowest
/// corner.
namespace pliant::kernels {

/// The number of directions in which a mode of a cell's 2^D corner values changes sign, (TL.2). The
/// number of a mode has a bit for each of these directions. A mode with one direction is a gradient
/// mode; with more, an hourglass mode.
inline constexpr int directions_of[] = {0, 1, 1, 2, 1, 2, 2, 3};

/// Rows of corners of a cell: row r contains corners 2 r and 2 r + 1. Corner c is one slot up in
/// every direction whose bit is set in c.
template <int D>
inline constexpr int corner_rows = 1 << (D - 1);

/// Coefficients of the energy of hourglass modes, divided by 2 W1 J^(-2/3)/2.
template <class T>
struct HourglassStiffness {
  T modes = 0;    ///< kappa of (TL.6), for modes with two directions
  T triple = 0;   ///< kappa for the mode with three directions; 3D
  T bending = 0;  ///< additional stiffness of bending over twisting modes, (TL.17); 3D
  T saddle = 0;   ///< coupling of the two modes that bend a cell across one plane, (TL.17); 3D
};

/// A run of cells along x that a block evaluates for its particles. A cell at the edge of a block
/// is evaluated by every block with particles at its corners, so that its forces stay in the
/// scratch memory of the block.
template <int D>
struct CellRun {
  std::int64_t first;  ///< slot, a multiple of slots_per_pack
  std::int32_t count;  ///< slots, a multiple of slots_per_pack
  bool follows;        ///< whether the cell before the first has corners in the run's first pack
  bool continues;      ///< whether the run before it has evaluated that cell
  bool cut;            ///< whether the surface cuts some of the cells
  bool own;            ///< whether the cells belong to the block
  std::array<std::int64_t, corner_rows<D>> row;  ///< slots from a cell to its rows of corners
  std::array<std::int64_t, corner_rows<D>>
      target;  ///< those corners of the first cell, relative to the first slot of the block; -1:
               ///< outside the block
};

/// Cells that a block evaluates together. Each has a corner that was moved from its lattice node X0
/// to another place X of the undeformed body, (TL.11). Lanes from `count` on repeat the last cell.
template <class T, int D>
struct FittedPack {
  static constexpr int corners = 1 << D, lanes = slots_per_pack;

  alignas(64) T volume[lanes];             ///< f det A: volume of the body in the cell, over h^D
  alignas(64) T moves[lanes];              ///< 1, or 0 where walls hold all corners
  alignas(64) T inverse[D * D][lanes];     ///< A^-1, row-major
  alignas(64) T start[D][corners][lanes];  ///< [component][mode] q_b(X) of hourglass modes [m]
  alignas(64) T moment[corners][lanes];    ///< [mode] m_b of (TL.36)
  std::int64_t slot[lanes];
  std::int64_t corner[corners][lanes];  ///< slots of the corners
  /// The corners relative to the first slot of the block; -1 outside it, and from `count` on.
  std::int32_t target[corners][lanes];
  int count;
};

/// Moments m_b of (TL.36) of the cells of a pack with cells that the surface cuts.
template <class T, int D>
struct CutPack {
  alignas(64) T moment[1 << D][slots_per_pack];  ///< [mode][lane]; 1, 0, 0, ... in whole cells
};

/// Computes the stress of the cells around the particles of a block, (TL.3)-(TL.6), and moves these
/// particles, (TL.5), (TL.8). Reads `displacement`, `fraction` and `bulk` also in
/// neighbouring blocks; writes arrays that no block reads.
template <class T, int D>
struct Motion {
  const CellRun<D>* runs;
  int run_count;
  const FittedPack<T, D>* fitted;       ///< cells with corners in the block
  int fitted_count;                     ///< packs
  std::int64_t first_slot, slot_count;  ///< of the block, multiples of slots_per_pack
  T spacing;
  HourglassStiffness<T> hourglass;
  bool examine;  ///< whether to compute the wave speed and to look for states that are not possible
  bool damped;   ///< whether to compute the sums for the work of damping
  T kept;        ///< share of the velocity that remains after damping, (TL.8)
  T gained;      ///< velocity per force over mass [s], (TL.8)
  T time_step;
  HyperelasticMaterial<T> material;  ///< coefficients without the share that relaxes, (TL.24)
  BulkRelaxation<T> bulk;
  Networks<T> networks;
  const T* fraction;        ///< [slot] share of the cell that the body fills; 0 in fitted cells
  const std::int32_t* cut;  ///< [slot / slots_per_pack] number in `cut_packs`
  const CutPack<T, D>* cut_packs;  ///< the first one is for packs of whole cells
  /// [slot] S0 of (TL.14) at the stress points [Pa]; null: none.
  std::array<const T*, symmetric_components<D>> initial_stress;
  const T* inverse_mass;                 ///< [slot], 0 where there is no particle [1/kg]
  std::array<const T*, D> displacement;  ///< d
  std::array<const T*, D> traction;      ///< external force on the particle [N], or nullptr
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
  /// Sums over the particles for the work of damping; 0 unless `damped`.
  double inertia = 0;  ///< sum of v . m v, without mass scaling [J]
  double damped = 0;   ///< the same with the mean of the velocities before and after the step [J]
};

}  // namespace pliant::kernels
