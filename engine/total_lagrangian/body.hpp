#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/lattice/layout.hpp"
#include "engine/storage/buffer.hpp"
#include "engine/total_lagrangian/cell_moments.hpp"
#include "engine/total_lagrangian/fields.hpp"
#include "engine/undeformed/body.hpp"
#include "kernels/total_lagrangian/table.hpp"

namespace pliant::total_lagrangian {

using undeformed::area_vector;
using undeformed::ConstrainedParticle;
using undeformed::Vertex;

/// A piece of the surface {phi = 0} inside one cell. The order of its corners makes its normal
/// point out of the body.
template <int D>
struct Facet {
  std::array<Vertex<D>, D> vertex;
  bool free;  ///< not on a wall
};

inline constexpr int whole_facet = -1;

/// The part of a facet on which a load acts, (TL.29).
template <int D>
struct SurfacePatch {
  int facet;
  double share;  ///< share of the facet's area, or of its area vector for a pressure
  int pressure;
  int corner;  ///< of which it is the share in the facet, (PB.67), or `whole_facet`
  /// For a pressure on only some faces of those that the facet represents: the rest of the loaded
  /// area vector per facet area, as components along the facet's sides from its first corner [m].
  std::array<double, D - 1> aside = {};
};

/// A cell with a corner that was moved from its lattice node X0 to another place X of the
/// undeformed body, (TL.11).
template <int D>
struct FittedCell {
  std::int64_t slot;
  double volume;            ///< f det A: volume of the body in the cell, over h^D
  bool moves;               ///< whether walls leave a corner free
  double inverse[D * D];    ///< A^-1, row-major
  double start[D][1 << D];  ///< [component][mode] q_b(X) of the hourglass modes [m]
};

/// A particle that was moved from its lattice node onto a wall or its rim, (TL.11).
template <int D>
struct FittedNode {
  std::int32_t slot;
  Point<D> shift;  ///< from the node [m]
};

/// Nodal loads of patches on a block: for k from begin[i] to begin[i + 1], particle `slot[i]` takes
/// `weight[k]` of the force on patch `patch[k]`.
struct NodalLoads {
  std::vector<std::int32_t> slot, begin = {0}, patch;
  std::vector<double> weight;
};

/// The cells around the particles of a block.
template <class T, int D>
struct BlockCells {
  std::vector<kernels::CellRun<D>> runs;  ///< runs of regular cells, in the order of their slots
  std::vector<kernels::FittedPack<T, D>> fitted;
};

/// One body in its undeformed shape: particles on the nodes of a lattice, stress points in the
/// middle of its cells.
template <class T, int D>
struct Body : undeformed::Body<T, D> {
  using Points = undeformed::Body<T, D>;
  using Points::position;

  kernels::HyperelasticMaterial<T> material;  ///< coefficients without the share that relaxes
  kernels::HourglassStiffness<double> hourglass;
  Lattice<D> lattice;
  Layout<D> layout;
  Buffer<T> level_set;            ///< phi of the undeformed body [m]
  Buffer<T> fraction;             ///< share of the cell above the slot that the body fills, (TL.1)
  Buffer<T> regular_fraction;     ///< the same, 0 in fitted cells
  std::vector<std::int32_t> cut;  ///< [slot / slots_per_pack] number in `cut_packs`
  std::vector<kernels::CutPack<T, D>> cut_packs;  ///< the first one is for packs of whole cells
  /// S0 of (TL.14) at the stress points [Pa]; empty without initial stress.
  std::array<Buffer<T>, kernels::symmetric_components<D>> initial_stress;
  std::vector<kernels::PronyTerm<double>> prony;
  std::vector<Buffer<T>>
      memory_pressure;      ///< [term] p_i of (RP.10) at the last stress evaluation [Pa]
  Buffer<T> volume_change;  ///< J - 1 there; only with Prony terms
  /// The same for the next stress: blocks write it during a step, then the arrays are swapped.
  std::vector<Buffer<T>> next_memory_pressure;
  Buffer<T> next_volume_change;
  std::vector<kernels::PronyTerm<double>> prony_shear;
  /// [tensor * network_components + component] A_i - I of (TL.24) at the last stress evaluation,
  /// then J^(2/3) C^-1 - I there; empty without prony_shear.
  std::vector<Buffer<T>> network;
  std::vector<Buffer<T>> next_network;      ///< the same for the next stress
  double memory_age = 0;                    ///< time since the last stress evaluation [s]
  std::vector<FittedNode<D>> fitted_nodes;  ///< in the order of the slots
  std::vector<FittedCell<D>> fitted;        ///< block by block
  std::vector<BlockCells<T, D>> cells;      ///< [block]
  std::vector<Facet<D>> facets;
  std::vector<SurfacePatch<D>> patches;
  std::vector<int> first_patch;         ///< [block + 1]
  std::vector<Point<D>> patch_force;    ///< [patch] [N]
  std::vector<NodalLoads> nodal_loads;  ///< [block]

  bool is_prestressed() const { return this->source != nullptr && this->source->stress; }

  /// Calls f(declaration, buffers) for every array of slots.
  template <class F>
  void for_each_array(F&& f) {
    visit_arrays(*this, f);
  }
  template <class F>
  void for_each_array(F&& f) const {
    visit_arrays(*this, f);
  }

  /// Size of its arrays of slots [B].
  std::size_t bytes() const {
    std::size_t sum = 0;
    for_each_array([&sum](const Declaration&, auto components) {
      for (const Buffer<T>& component : components) sum += component.bytes();
    });
    return sum;
  }

  std::array<const T*, D> displacement_view() const {
    std::array<const T*, D> view;
    for (int a = 0; a < D; ++a) view[a] = this->displacement[a].get();
    return view;
  }

  /// Makes the results of a step the present state.
  void take_next() {
    std::swap(this->displacement, this->end_displacement);
    std::swap(memory_pressure, next_memory_pressure);
    std::swap(volume_change, next_volume_change);
    std::swap(network, next_network);
  }

  /// Distance of a particle's undeformed place from its node [m].
  Point<D> shift(std::int64_t slot) const {
    const auto at =
        std::lower_bound(fitted_nodes.begin(), fitted_nodes.end(), slot,
                         [](const FittedNode<D>& node, std::int64_t s) { return node.slot < s; });
    return at != fitted_nodes.end() && at->slot == slot ? at->shift : Point<D>{};
  }
  /// Undeformed place of a particle [m].
  Point<D> place(std::int64_t slot, const Cell<D>& cell) const {
    Point<D> x = lattice.node(cell);
    const Point<D> from_node = shift(slot);
    for (int a = 0; a < D; ++a) x[a] += from_node[a];
    return x;
  }
  /// Whether a corner of a slot's cell was moved from its node.
  bool is_fitted(const Cell<D>& cell) const {
    if (fitted_nodes.empty()) return false;
    const auto around = corners(cell);
    return std::any_of(around.begin(), around.end(),
                       [this](std::int64_t slot) { return shift(slot) != Point<D>{}; });
  }

  /// Moments of the part of a slot's cell in the body, (TL.36).
  CellMoments<D> moments(std::int64_t slot) const {
    const kernels::CutPack<T, D>& pack = cut_packs[cut[slot / kernels::slots_per_pack]];
    CellMoments<D> of_cell;
    for (int m = 0; m < (1 << D); ++m) of_cell[m] = pack.moment[m][slot % kernels::slots_per_pack];
    return of_cell;
  }

  /// Slots of the corners of a slot's cell; they all exist if the body fills some of the cell.
  std::array<std::int64_t, (1 << D)> corners(const Cell<D>& cell) const {
    std::array<std::int64_t, (1 << D)> found;
    for (int c = 0; c < (1 << D); ++c) {
      Cell<D> at = cell;
      for (int a = 0; a < D; ++a) at[a] += c >> a & 1;
      found[c] = layout.slot(at);
    }
    return found;
  }

  /// Slot offsets from a slot's cell to its rows of corners.
  std::array<std::int64_t, kernels::corner_rows<D>> corner_rows(std::int64_t slot) const {
    const auto& segments = layout.segments();
    const auto& segment = *std::prev(std::upper_bound(
        segments.begin(), segments.end(), slot,
        [](std::int64_t s, const kernels::Segment<D>& other) { return s < other.first; }));
    std::array<std::int64_t, kernels::corner_rows<D>> rows;
    for (int r = 0; r < kernels::corner_rows<D>; ++r) {
      rows[r] = segment.neighbour_row[kernels::row_index<D>(r & 1, r >> 1)];
    }
    return rows;
  }

 private:
  template <class Self, class F>
  static void visit_arrays(Self& body, F&& f) {
    using std::span;
    f(field_list[Field::displacement], span(body.displacement));
    f(field_list[Field::end_displacement], span(body.end_displacement));
    f(field_list[Field::velocity], span(body.velocity));
    f(field_list[Field::internal_force], span(body.internal));
    if (body.is_sampled()) {
      f(field_list[Field::sampled_displacement], span(body.sampled_displacement));
      f(field_list[Field::sampled_force], span(body.sampled_force));
    }
    f(field_list[Field::traction], span(body.traction));
    f(field_list[Field::mass], span(&body.mass, 1));
    f(field_list[Field::inverse_mass], span(&body.inverse_mass, 1));
    f(field_list[Field::level_set], span(&body.level_set, 1));
    f(field_list[Field::fraction], span(&body.fraction, 1));
    f(field_list[Field::regular_fraction], span(&body.regular_fraction, 1));
    if (body.is_prestressed()) {
      f(field_list[Field::initial_stress], span(body.initial_stress));
    }
    f(field_list[Field::memory_pressure], span(body.memory_pressure));
    f(field_list[Field::volume_change], span(&body.volume_change, body.prony.empty() ? 0 : 1));
    f(field_list[Field::next_memory_pressure], span(body.next_memory_pressure));
    f(field_list[Field::next_volume_change],
      span(&body.next_volume_change, body.prony.empty() ? 0 : 1));
    f(field_list[Field::network], span(body.network));
    f(field_list[Field::next_network], span(body.next_network));
  }
};

/// Present normal of a facet; its length is the area [m^(D-1)].
template <class T, int D>
Point<D> area_vector(const Body<T, D>& body, const Facet<D>& facet) {
  std::array<Point<D>, D> x;
  for (int v = 0; v < D; ++v) x[v] = body.position(facet.vertex[v]);
  return area_vector<D>(x);
}

}  // namespace pliant::total_lagrangian
