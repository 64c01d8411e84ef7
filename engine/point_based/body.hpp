#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/point_based/fields.hpp"
#include "engine/storage/buffer.hpp"
#include "engine/undeformed/body.hpp"
#include "kernels/point_based/table.hpp"
#include "scheduler/blocks.hpp"

namespace pliant::point_based {

/// A run of nodes along the Hilbert curve, padded to whole packs with slots without mass.
struct NodeBlock {
  std::int64_t first;       ///< slot
  int count;                ///< slots
  int nodes;                ///< slots that hold nodes
  std::int64_t first_halo;  ///< first element of the block in `Body::halo`
  int halo_count;

  /// First point of the block in arrays that store own slots and halo of one block after another.
  std::int64_t first_point() const { return first + first_halo; }
};

using undeformed::ConstrainedParticle;

/// A node and its share of the undeformed surface under one pressure or traction.
template <int D>
struct PressedNode {
  std::int32_t slot;
  std::int32_t pressure;
  Point<D> area;        ///< outwards [m^(D-1)]
  double size;          ///< of the area, negative where other nodes bear more [m^(D-1)]
  Point<D> middle;      ///< centre of the share [m]
  Point<D> force = {};  ///< present [N]
};

/// A node on which a blade acts.
template <int D>
struct BladedNode {
  std::int32_t slot;
  Point<D> force;  ///< in this step [N]
};

/// A node whose bonds span only a plane or a line.
template <int D>
struct DegenerateNode {
  std::int64_t slot;
  int rank;                           ///< number of directions that they span
  std::array<Point<D>, D> direction;  ///< Q of (PB.13)
  double volume;                      ///< [m^D]
};

/// The displacement u(X) = u_i + sum_j (u_j - u_i) g_j.(X - X_i) around a node i.
template <int D>
struct SurfaceFit {
  std::vector<std::int32_t> slot;  ///< [neighbour]
  std::vector<Point<D>> gradient;  ///< [neighbour] g of (PB.4) [1/m]
};

/// The undeformed surface of a body: segments (2D) or triangles (3D). Each corner moves with the
/// node nearest to it.
template <int D>
struct BodySurface {
  std::vector<Point<D>> start;     ///< [corner] [m]
  std::vector<std::int32_t> node;  ///< [corner] slot
  /// [slot of such a node] how corners beside the node move, (TL.15); empty with elements or cuts
  std::map<std::int32_t, SurfaceFit<D>> fit;
  std::vector<std::array<std::int32_t, D>> facet;  ///< corners, ordered as seen from outside
  std::vector<bool> is_free;                       ///< [facet] not on a wall
  /// [facet] that fills a rectangle with it, or -1, see rectangles.hpp; empty: none does
  std::vector<std::int32_t> other_half;
  const Shape* shape =
      nullptr;         ///< shape on which facets lie approximately; null for elements and meshes
  double spacing = 0;  ///< of the lattice that the surface comes from, if there is a shape [m]
};

/// One body: the nodes of its undeformed shape, and the bonds between them.
template <class T, int D>
struct Body : undeformed::Body<T, D> {
  using undeformed::Body<T, D>::position;
  static constexpr int symmetric = kernels::symmetric_components<D>;

  kernels::HyperelasticMaterial<T> material;
  int bonds = 0;              ///< of each node, with bonds of zero weight
  int most_points = 0;        ///< largest number of own slots and halo of a block
  double resolution = 0;      ///< H, the smallest V^(1/D) [m]
  double volume_at_rest = 0;  ///< [m^D]
  std::vector<NodeBlock> blocks;
  scheduler::Blocks adjacency;                 ///< blocks that bonds connect
  std::vector<Point<D>> start;                 ///< [slot] undeformed positions [m]
  std::vector<std::int64_t> number;            ///< [slot] number of the node in its cloud; -1: none
  Buffer<T> volume;                            ///< [m^D], 0 at degenerate nodes
  Buffer<T> stiffness;                         ///< [N/m]
  Buffer<T> frequency2;                        ///< of (PB.12) [1/s^2]
  std::array<Buffer<T>, D * D> kept_gradient;  ///< D of (PB.14); only with cuts
  std::array<Buffer<T>, symmetric> moment, strain;
  Buffer<T> share;       ///< share in the volume of its group, (PB.60); only with groups
  T shared_modulus = 0;  ///< [Pa]
  std::vector<kernels::PronyTerm<double>> prony;  ///< of the bulk modulus of the material
  std::vector<Buffer<T>> memory_pressure;         ///< [term] p_i of (PB.70) at the last forces [Pa]
  Buffer<T> volume_change;                        ///< theta there; only with `prony`
  std::vector<kernels::PronyTerm<double>> prony_shear;  ///< of its shear modulus
  /// [tensor * network_components + component] A_i - I of (TL.24) at the last forces, and then
  /// J^(2/3) C^-1 - I; empty without `prony_shear`.
  std::vector<Buffer<T>> network;
  double memory_age = 0;  ///< time since then [s]
  std::array<Buffer<T>, symmetric>
      initial_stress;                      ///< S0 of (TL.14) [Pa]; empty without initial stress
  std::array<Buffer<T>, D> pressure_load;  ///< [N]; only with pressures
  Buffer<std::uint16_t> neighbour;         ///< [pack][bond][lane] local numbers times point_stride
  Buffer<T> bond;                          ///< [pack][bond][D + 1][lane] g, w
  std::vector<std::int32_t> halo;          ///< slots, ascending in each block
  Buffer<T> force;                         ///< [slots and halos][point_stride]
  std::vector<std::vector<kernels::CollectedForces<T>>> collected;  ///< [block]
  std::vector<std::vector<PressedNode<D>>> pressed;                 ///< [block]
  std::vector<std::vector<BladedNode<D>>> bladed;  ///< [block]; only where blades exert forces
  std::vector<std::vector<DegenerateNode<D>>> degenerate;  ///< [block]
  BodySurface<D> surface;
  /// [element] slots; only for the nodes of a mesh with cuts
  std::vector<std::array<std::int32_t, D + 1>> elements;

  bool is_pressed() const { return pressure_load[0].bytes() > 0; }
  bool is_loaded() const { return this->traction[0].bytes() > 0; }
  bool has_cuts() const { return kept_gradient[0].bytes() > 0; }
  bool is_prestressed() const { return initial_stress[0].bytes() > 0; }
  bool has_groups() const { return share.bytes() > 0; }
  bool is_viscous() const { return strain[0].bytes() > 0; }

  /// Calls f(declaration, buffers) for every array of slots.
  template <class F>
  void for_each_array(F&& f) {
    visit_arrays(*this, f);
  }
  template <class F>
  void for_each_array(F&& f) const {
    visit_arrays(*this, f);
  }

  /// Size of its arrays [B].
  std::size_t bytes() const {
    std::size_t sum =
        neighbour.bytes() + bond.bytes() + force.bytes() + halo.size() * sizeof(halo[0]);
    for_each_array([&sum](const Declaration&, auto components) {
      for (const Buffer<T>& component : components) sum += component.bytes();
    });
    return sum;
  }

  /// Calls f(slot) for every node, in the order of the slots.
  template <class F>
  void for_each_node(F&& f) const {
    for (const NodeBlock& block : blocks) {
      for (int i = 0; i < block.nodes; ++i) f(block.first + i);
    }
  }

  const NodeBlock& block_of(std::int64_t slot) const {
    const auto after =
        std::upper_bound(blocks.begin(), blocks.end(), slot,
                         [](std::int64_t s, const NodeBlock& block) { return s < block.first; });
    return *(after - 1);
  }

  /// Slot of a point that a block knows by a local number.
  std::int64_t slot_of(const NodeBlock& block, int local) const {
    return local < block.count ? block.first + local
                               : halo[block.first_halo + (local - block.count)];
  }

  /// Local number in a block of an own slot or a halo slot.
  std::int64_t local_number(const NodeBlock& block, std::int64_t slot) const {
    if (slot >= block.first && slot < block.first + block.count) return slot - block.first;
    const auto begin = halo.begin() + block.first_halo;
    return block.count + (std::lower_bound(begin, begin + block.halo_count, slot) - begin);
  }

  /// Local number of the neighbour of a bond, in the block of the node.
  int local_neighbour(std::int64_t slot, int k) const {
    constexpr int lanes = kernels::slots_per_pack;
    return neighbour[(slot / lanes * bonds + k) * lanes + slot % lanes] / kernels::point_stride;
  }

  /// Calls f(k, slot of the neighbour, g, w) for the bonds of a node, with g and w as stored for
  /// kernels.
  template <class F>
  void for_each_bond(const NodeBlock& block, std::int64_t slot, F&& f) const {
    constexpr int lanes = kernels::slots_per_pack;
    const std::int64_t pack = slot / lanes, lane = slot % lanes;
    for (int k = 0; k < bonds; ++k) {
      const std::int64_t at = pack * bonds + k;
      Point<D> g;
      for (int a = 0; a < D; ++a) g[a] = bond[(at * (D + 1) + a) * lanes + lane];
      const double w = bond[(at * (D + 1) + D) * lanes + lane];
      if (w > 0) f(k, slot_of(block, local_neighbour(slot, k)), g, w);
    }
  }

  /// Present position of a node [m].
  Point<D> position(std::int64_t slot) const {
    Point<D> x = start[slot];
    for (int a = 0; a < D; ++a) x[a] += this->displacement[a][slot];
    return x;
  }

 private:
  template <class Self, class F>
  static void visit_arrays(Self& body, F&& f) {
    using std::span;
    f(field_list[Field::displacement], span(body.displacement));
    f(field_list[Field::end_displacement], span(body.end_displacement));
    f(field_list[Field::velocity], span(body.velocity));
    f(field_list[Field::end_velocity], span(body.end_velocity));
    f(field_list[Field::velocity_gain], span(body.velocity_gain));
    if (body.is_viscous()) f(field_list[Field::strain], span(body.strain));
    f(field_list[Field::memory_pressure], span(body.memory_pressure));
    f(field_list[Field::volume_change], span(&body.volume_change, body.prony.empty() ? 0 : 1));
    f(field_list[Field::network], span(body.network));
    if (body.is_sampled()) {
      f(field_list[Field::sampled_displacement], span(body.sampled_displacement));
      f(field_list[Field::sampled_force], span(body.sampled_force));
    }
    f(field_list[Field::mass], span(&body.mass, 1));
    f(field_list[Field::inverse_mass], span(&body.inverse_mass, 1));
    f(field_list[Field::volume], span(&body.volume, 1));
    f(field_list[Field::stiffness], span(&body.stiffness, 1));
    f(field_list[Field::frequency2], span(&body.frequency2, 1));
    f(field_list[Field::moment], span(body.moment));
    if (body.has_groups()) f(field_list[Field::share], span(&body.share, 1));
    if (body.is_prestressed()) {
      f(field_list[Field::initial_stress], span(body.initial_stress));
    }
    if (body.has_cuts()) f(field_list[Field::kept_gradient], span(body.kept_gradient));
    if (body.is_pressed()) f(field_list[Field::pressure_load], span(body.pressure_load));
    if (body.is_loaded()) f(field_list[Field::traction], span(body.traction));
  }
};

}  // namespace pliant::point_based
