#pragma once

#include <array>
#include <cstdint>

#include "kernels/bulk_relaxation.hpp"
#include "kernels/hyperelastic_material.hpp"
#include "kernels/layout.hpp"
#include "kernels/networks.hpp"

/// Arguments of the kernels of the point-based method. Nodes are slots; those of a block are
/// contiguous, padded to whole packs with slots without mass.
///
///     local numbers of a block:   0 ........ count | count ........ count + halo_count
///                                  its own slots   |   neighbours in other blocks (halo)
///
/// Displacements of both are copied into an array of points with `point_stride` values each, so
/// that one load gets any neighbour: bonds store the position of the neighbour in such arrays, its
/// local number times `point_stride`. Forces are summed in another such array. Those on the halo
/// are added to the nodes of other blocks in a later phase, in the order of the blocks, so that
/// sums do not depend on the number of threads.
namespace pliant::kernels {

/// Values of a point in arrays of points.
inline constexpr int point_stride = 4;

/// Most bonds that a node can have.
inline constexpr int most_bonds = 64;

/// Largest number of adjacent slots in a group that shares a change of volume, (PB.60).
template <int D>
inline constexpr int slots_per_group = 1 << (D - 1);

/// Forces of the nodes of a block on themselves and on their neighbours, (PB.4)-(PB.8).
template <class T, int D>
struct PointForces {
  std::int64_t first;              ///< slot
  int count;                       ///< slots, a multiple of slots_per_pack
  int bonds;                       ///< of each node
  const std::uint16_t* neighbour;  ///< [pack][bond][lane] local numbers times point_stride
  const T* bond;                   ///< [pack][bond][D + 1][lane] g_ij [1/m], w_ij
  int halo_count;
  const std::int32_t* halo;  ///< [halo_count] slots
  std::array<const T*, D> displacement;
  const T* volume;                                       ///< [slot] V [m^D]
  const T* stiffness;                                    ///< [slot] V kappa [N/m]
  const T* frequency2;                                   ///< [slot] lambda of (PB.12) [1/s^2]
  std::array<const T*, symmetric_components<D>> moment;  ///< [slot] A [m^2]
  std::array<const T*, D> load;  ///< [slot] pressure times undeformed area [N]; null: none
  /// E of the last step, read and updated; null without viscosity.
  std::array<T*, symmetric_components<D>> strain;
  /// [slot] S0 of (TL.14) [Pa]; null: none.
  std::array<const T*, symmetric_components<D>> initial_stress;
  std::array<const T*, D * D> kept;  ///< [slot] D of (PB.14); null: I
  const T* share;    ///< [slot] share in the volume of its group, (PB.60); null: no groups
  T shared_modulus;  ///< lambda - 3/2 mu of (PB.60) [Pa]
  T viscosity;       ///< beta over the time step, (PB.9)
  bool examine;      ///< whether to compute PointForcesResult
  HyperelasticMaterial<T> material;  ///< coefficients without the share that relaxes, (TL.24)
  Networks<T> networks;              ///< [slot] read and updated; without terms: none
  BulkRelaxation<T> bulk;            ///< [slot] read and updated; without terms: none
  T* point;  ///< [count + halo_count][point_stride] scratch for displacements
  T* force;  ///< [count + halo_count][point_stride] [N]
};

struct PointForcesResult {
  std::int64_t non_finite = -1;  ///< a slot whose F is not finite or whose J <= 0, or -1
  double frequency2 = 0;         ///< largest lambda q^2 of (PB.12) [1/s^2]; 0 unless examined
};

/// Forces that another block has collected for nodes of this one.
template <class T>
struct CollectedForces {
  const T* force;            ///< [count][point_stride] [N]
  const std::int32_t* slot;  ///< [count]
  int count;
};

/// Moves the nodes of a block, (PB.10), after adding the forces that other blocks have collected.
template <class T, int D>
struct PointMotion {
  std::int64_t first;
  int count;
  const CollectedForces<T>* collected;
  int collected_count;
  T* force;                  ///< [count][point_stride] of the block itself; at the end the sum [N]
  T kept;                    ///< share of the velocity that remains after damping
  T gained;                  ///< velocity per force over mass [s]
  T drift;                   ///< how long nodes move after the kick [s]
  const T* inverse_mass;     ///< [slot], 0 where there is no node [1/kg]
  std::array<T, D> gravity;  ///< acceleration of all nodes [m/s^2]
  std::array<const T*, D> external;  ///< [slot] external force [N]; null: none
  const T* mass;                     ///< [slot] [kg]; null: no sums are needed
  std::array<T*, D> velocity, displacement;
};

/// Sums over the nodes of a block, u their velocities before they were moved and u' after it.
struct PointMotionSums {
  double inertia = 0;           ///< of m u^2 [J]
  double inertia_of_means = 0;  ///< of m ((u + u')/2)^2 [J]
};

/// Nodes of a block whose momentum is asked for.
template <class T, int D>
struct PointMomentum {
  std::int64_t first;
  int count;
  const T* mass;  ///< [slot] [kg]
  std::array<const T*, D> velocity;
};

/// Moves the nodes of a block at their velocities.
template <class T, int D>
struct PointDrift {
  std::int64_t first;
  int count;
  T drift;  ///< [s]
  std::array<const T*, D> velocity;
  std::array<T*, D> displacement;
};

}  // namespace pliant::kernels
