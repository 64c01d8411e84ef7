#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/fields.hpp"
#include "engine/lattice/layout.hpp"
#include "engine/remeshed/body_neighbours.hpp"
#include "engine/storage/buffer.hpp"
#include "kernels/ghost_state.hpp"
#include "kernels/table.hpp"

namespace pliant::remeshed {

using kernels::Kind;
using kernels::PackState;

/// Where ghosts of one block touch other bodies in the present step, and what they feel.
template <class T, int D>
struct BodyTouches {
  std::vector<std::int32_t> ghost;    ///< in the order of the ghosts
  std::vector<std::int32_t> contact;  ///< of the case
  std::vector<T> gap;   ///< to the other body's surface, negative where they overlap [m]
  std::vector<T> area;  ///< share of the surface, (RP.67) [m^(D-1)]
  std::vector<std::int64_t> begin;         ///< [touch + 1] into the two below
  std::vector<std::int32_t> record;        ///< of the other body
  std::vector<T> coefficient;              ///< of its linear fit at the foot point
  std::vector<std::array<T, D>> traction;  ///< on this body, (RP.65) [Pa]

  void clear() {
    ghost.clear();
    contact.clear();
    gap.clear();
    area.clear();
    begin.assign(1, 0);
    record.clear();
    coefficient.clear();
    traction.clear();
  }
};

/// Ghosts of one block that take the state of another body as it is, (RP.66).
template <class T>
struct BodyBonds {
  std::vector<std::int32_t> ghost;
  std::vector<std::int32_t> body;   ///< the other
  std::vector<std::int64_t> begin;  ///< [bond + 1] into the two below
  std::vector<std::int32_t> slot;   ///< of the other body
  std::vector<T> coefficient;       ///< of its linear fit at the ghost

  void clear() {
    ghost.clear();
    body.clear();
    begin.assign(1, 0);
    slot.clear();
    coefficient.clear();
  }
};

/// Ghosts of one block, and the surface particles of the block that ghosts anywhere read. Those of
/// walls and those that the stencil of a particle reaches come first, in the order of the slots;
/// then, likewise, the others, which only drift.
template <class T, int D>
struct BlockGhosts {
  std::vector<std::int32_t> slot;
  std::size_t reached_count = 0;        ///< of the ghosts that come first
  std::vector<std::int8_t> wall;        ///< of a wall or contact ghost; -1: free surface
  std::vector<std::uint8_t> active;     ///< whether the ghost sets its slot; see `contact`
  std::vector<std::int8_t> pressure;    ///< acting at the foot point; -1: none
  std::vector<Point<D>> normal;         ///< of the wall
  std::vector<Point<D>> foot;           ///< foot point at xi = 0 [m]
  std::vector<std::int64_t> begin;      ///< [ghost + 1] into the four below
  std::vector<std::int32_t> neighbour;  ///< slot of an interior particle
  std::vector<std::int32_t> record;     ///< of that particle
  std::vector<T> linear, constrained;   ///< c of (RP.32), b of (RP.33)
  std::vector<T> surface;               ///< a: (RP.32) at the foot point
  std::vector<T> constrained_sum;       ///< [ghost] sum of b
  std::vector<T> surface_sum;  ///< [ghost] sum of a: 1, or 0 where the surface meets a wall
  /// A slot beyond a contact wall has two ghosts, of the free surface and, next in order, of the
  /// wall: the latter are listed here. One of the two is active, (RP.50).
  std::vector<std::int32_t> contact;
  /// [contact] of the surface above the wall at xi = 0 and the wall's place at t = 0, (RP.50) [m]
  std::vector<double> contact_height;
  std::vector<double> contact_area;  ///< [contact] share of the wall, (RP.52) [m^(D-1)]
  BodyTouches<T, D> touches;         ///< with other bodies
  BodyBonds<T> bonds;                ///< at the ends of bonded interfaces
  std::vector<kernels::SurfacePack> packs;
  std::int32_t first_record = 0, record_count = 0;
  Buffer<T> sums;

  /// The sums of ghost g, once they are made.
  kernels::GhostFits<T, D> fits(std::size_t g) const {
    constexpr int width = kernels::record_width<D>;
    const T* of = sums.get() + 3 * width * g;
    return {{of}, {of + width}, {of + 2 * width}, constrained_sum[g], surface_sum[g]};
  }
};

/// Slots of a body after a remeshing: where they lie, what they hold, how ghosts read them.
template <class T, int D>
struct Population {
  Layout<D> layout;
  Buffer<Kind> kind;
  Buffer<PackState> pack_state;
  Buffer<T> interior;                     ///< 1 for interior particles, else 0
  std::vector<BlockGhosts<T, D>> ghosts;  ///< [block]
  std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>>
      images;  ///< [block] (image, source)
  std::int64_t record_count = 0;
  std::int64_t particles = 0;  ///< interior
};

/// One body: its lattice, material, particles and surface. Nothing of it is shared with other
/// bodies.
///
/// A remeshing writes `spare` and `stage[1]` (dead between steps) and then swaps them with the
/// current ones; measuring between remeshings is a remeshing that is not followed by the swap.
template <class T, int D>
struct Body {
  std::string name;
  const BodyCase* source = nullptr;
  kernels::Material<T> material;
  bool is_plain_sph = false;  ///< without ghosts, neighbours always listed
  Lattice<D> lattice;
  Population<T, D> population, spare;
  std::array<FieldStore<T, D>, 4> stage;  ///< Q0, Q2, Q3, Q4 of (RP.19); 0 and 1 hold all fields
  std::array<std::array<Buffer<T>, kernels::symmetric_components<D>>, 2> stress;
  /// sigma/rho^2 and R of plain SPH, (RP.74), (RP.76); empty otherwise.
  std::array<std::array<Buffer<T>, kernels::symmetric_components<D>>, 2> pair_stress;
  std::vector<kernels::PronyTerm<T>> prony;
  std::vector<T*> memory;  ///< [term] p_i of `stage[0]`
  Buffer<T> records;       ///< [record][record_width] of surface particles
  Buffer<std::int32_t> record_of_slot;
  BodyNeighbours<D> neighbours;

  std::array<T*, kernels::symmetric_components<D>> stress_view(int parity) {
    std::array<T*, kernels::symmetric_components<D>> view;
    for (std::size_t c = 0; c < view.size(); ++c) view[c] = stress[parity][c].get();
    return view;
  }
  std::array<const T*, kernels::symmetric_components<D>> stress_view(int parity) const {
    std::array<const T*, kernels::symmetric_components<D>> view;
    for (std::size_t c = 0; c < view.size(); ++c) view[c] = stress[parity][c].get();
    return view;
  }

  kernels::BulkViscosity<T> viscosity(const kernels::Relaxation<T>* relaxation = nullptr) const {
    return {static_cast<int>(prony.size()), relaxation, memory.data()};
  }

  /// Position of a slot's particle [m].
  Point<D> position(std::int64_t slot, const Cell<D>& cell) const {
    Point<D> x = lattice.node(cell);
    for (int a = 0; a < D; ++a) x[a] += stage[0].get(Field::displacement, a)[slot];
    return x;
  }
};

}  // namespace pliant::remeshed
