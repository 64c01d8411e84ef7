#pragma once

#include <array>
#include <cstdint>

#include "kernels/isa.hpp"
#include "kernels/layout.hpp"
#include "kernels/remeshed/evolving.hpp"

/// Arguments of the kernels of remeshing: scatter, filter, level set.
namespace pliant::kernels {

/// Nodes of a remeshing tile store the sums of (RP.32): W, W m, W m u (D), W v, W v d (D), W phi,
/// then W v S or W v F. They are padded to whole cache lines of doubles.
template <int D>
inline constexpr int node_fields = 4 + 2 * D + material_components<D>;
/// Values of a node if `components` of S or F are remeshed, and the largest number of values.
template <int D>
constexpr int node_width_for(int components) {
  return (4 + 2 * D + components + 7) / 8 * 8;
}
template <int D>
inline constexpr int node_width = node_width_for<D>(material_components<D>);
template <int D>
struct NodeField {
  static constexpr int weight = 0, mass = 1, momentum = 2, volume = 2 + D, displacement = 3 + D,
                       level_set = 3 + 2 * D, material = 4 + 2 * D;
};

/// The nodes of a tile in one lattice row, contiguous in storage; empty if begin == end.
struct NodeRow {
  std::int32_t begin, end;  ///< along x, from the lower corner of the tile
  std::int64_t first;       ///< the node at `begin`
};

/// Adds the particles of a source block (slots that are neither vacant nor images) to the nodes of
/// a tile, (RP.31) and (RP.32), in slot order. Nodes of a particle outside the tile are skipped.
template <class T, int D>
struct Scatter {
  const Segment<D>* segments;
  int segment_count;
  const Kind* kind;
  T inverse_spacing;
  std::array<std::int32_t, D> shift;  ///< whole cells added to every particle (periodic images)
  int material_component_count;       ///< of S or F
  const T* mass;
  const T* level_set;
  std::array<const T*, D> displacement;  ///< d at the last remeshing; d + xi is remeshed
  Evolving<const T, D> state;
  T* nodes;                            ///< [node][node_width_for(material_component_count)]
  const NodeRow* rows;                 ///< [z][y]
  std::array<std::int32_t, D> lower;   ///< lattice cell at the lower corner of the tile
  std::array<std::int32_t, D> extent;  ///< of the box around the tile
};

/// Filters one field over a block, (RP.37), with fluxes between slots inside.
template <class T, int D>
struct Filter {
  const Segment<D>* segments;
  int segment_count;
  T strength;       ///< gamma
  const T* inside;  ///< [slot] 1 or 0
  const T* field;
  T* filtered;
};

/// Closest points on the zero set of the tensor-cubic interpolant of nodal values, (RP.41).
/// Positions are in cells: node c is at c. Arrays of nodes contain whole packs, padded with
/// arbitrary nodes.
template <class T, int D>
struct ClosestPoints {
  const T* values;                     ///< [z][y][x] of a box of nodes; NaN: no value
  std::array<std::int32_t, D> lower;   ///< cell of the box's first node
  std::array<std::int32_t, D> extent;  ///< nodes of the box
  int count;                           ///< number of nodes that need a closest point
  int iterations;                      ///< at most
  T flattest;                          ///< square of the smallest usable gradient
  T shortest_step;                     ///< steps below it have converged
  T smallest_value;              ///< values below it are on the surface, after the last iteration
  std::array<const T*, D> node;  ///< [node]
  std::array<T*, D> point;       ///< [node] start, then closest point
  T* converged;                  ///< [node] 1 or 0
};

template <class T, int D>
struct RemeshingKernels {
  void (*scatter)(const Scatter<T, D>&);
  void (*filter)(const Filter<T, D>&);
  void (*find_closest_points)(const ClosestPoints<T, D>&);
};

template <Isa isa, class T, int D>
RemeshingKernels<T, D> remeshing_kernels();

}  // namespace pliant::kernels
