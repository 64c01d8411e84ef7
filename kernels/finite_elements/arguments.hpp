#pragma once

#include <array>
#include <cstdint>

#include "kernels/layout.hpp"
#include "kernels/point_based/arguments.hpp"

/// Arguments of the kernels of finite elements: tetrahedra in 3D, triangles in 2D, with a constant
/// gradient. Nodes are in blocks, and displacements and forces in arrays of points, as in the
/// point-based method. An element belongs to one block; its corners are own nodes or nodes of the
/// halo. Packs are padded with elements without volume.
namespace pliant::kernels {

/// Values of an element in arrays of shapes: gradients of corners 1 to D, and the volume.
template <int D>
inline constexpr int element_values = D* D + 1;

/// The elements of a block and the nodes at their corners.
template <class T, int D>
struct ElementBlock {
  std::int64_t first;  ///< slot
  int count;           ///< slots, a multiple of slots_per_pack
  int halo_count;
  const std::int32_t* halo;     ///< [halo_count] slots
  int elements;                 ///< a multiple of slots_per_pack
  const std::uint16_t* corner;  ///< [pack][D + 1][lane] local numbers times point_stride
  const T* shape;               ///< [pack][element_values][lane] [1/m], [m^D]
  const T* initial_stress;      ///< [pack][component][lane] S0 of (TL.14) [Pa]; null: none
  std::array<const T*, D> displacement;
  HyperelasticMaterial<T> material;  ///< without its volumetric modulus
  T volumetric_modulus;              ///< Lambda of (FE.3) [Pa]
  bool examine;                      ///< whether to look for states that are not possible
  const T* pressure;                 ///< [slot] p of (FE.4) [Pa]; null: (FE.3) in each element
  T* point;  ///< [count + halo_count][point_stride] scratch for displacements
  T* force;  ///< [count + halo_count][point_stride] sums at corners
};

/// Computes the pressures of the nodes of a block, (FE.4) and (FE.8), from the sums that elements
/// have added.
template <class T>
struct NodalPressures {
  std::int64_t first;
  int count;
  const CollectedForces<T>* collected;  ///< by other blocks
  int collected_count;
  T* force;                ///< [count][point_stride] own sums; at the end those of all blocks [m^D]
  T modulus;               ///< Lambda of (FE.3) [Pa]
  const T* volume;         ///< [slot] V [m^D], 0 where there is no node
  BulkRelaxation<T> bulk;  ///< [slot] read and updated; without terms: none
  T* pressure;             ///< [slot] [Pa]
};

}  // namespace pliant::kernels
