#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/lattice/layout.hpp"
#include "engine/remeshed/neighbours/body_neighbours.hpp"
#include "engine/remeshed/runge_kutta.hpp"
#include "engine/remeshed/state/field_store.hpp"
#include "engine/remeshed/state/loaded_facets.hpp"
#include "engine/storage/buffer.hpp"
#include "kernels/remeshed/ghosts/ghost_state.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

using kernels::Kind;
using kernels::PackState;

/// The ghosts of one block that are on other bodies in the present step, and their tractions.
template <class T, int D>
struct ContactPoints {
  std::vector<std::int32_t> ghost;    ///< in the order of the ghosts
  std::vector<std::int32_t> contact;  ///< index in the case
  std::vector<T> gap;   ///< to the surface of the other body, negative where they overlap [m]
  std::vector<T> area;  ///< share of the surface, (RP.68) [m^(D-1)]
  std::vector<std::int64_t> begin;         ///< [contact point + 1] into the two below
  std::vector<std::int32_t> record;        ///< records of the other body
  std::vector<T> coefficient;              ///< of the linear fit at the foot point
  std::vector<std::array<T, D>> traction;  ///< on this body, (RP.56) [Pa]

  /// Calls f(field, list) for every list of the contact points.
  template <class F>
  static void for_each_list(F&& f) {
    using P = ContactPoints;
    f(Field::contact_ghost, &P::ghost);
    f(Field::contact_number, &P::contact);
    f(Field::gap, &P::gap);
    f(Field::area, &P::area);
    f(Field::contact_begin, &P::begin);
    f(Field::contact_record, &P::record);
    f(Field::contact_coefficient, &P::coefficient);
    f(Field::traction, &P::traction);
  }

  void clear() {
    for_each_list([this](Field, auto list) { (this->*list).clear(); });
    begin.push_back(0);
  }
};

template <class T, int D>
struct Body;

/// The ghosts of one block, and the surface particles of the block that any ghosts read. Ghosts
/// that the stencil of a particle reaches, and those needed for the force of walls, come first, in
/// the order of the slots. The others, which only drift, follow in the same order.
template <class T, int D>
struct BlockGhosts {
  std::vector<std::int32_t> slot;
  std::size_t reached_count = 0;      ///< number of ghosts that come first
  std::vector<std::int8_t> wall;      ///< wall of a wall or contact ghost; -1: free surface
  std::vector<std::uint8_t> active;   ///< whether the ghost sets its slot; see `contact`
  std::vector<std::int8_t> pressure;  ///< load on it; see record_loads.hpp
  /// [ghost * D + i] the faces near a ghost under several loads: the normal at the remeshing, zero
  /// where there is no face, the load, and the share of the face on which it acts, (RP.78).
  std::vector<std::array<T, D>> face;
  std::vector<std::int8_t> face_load;
  std::vector<T> face_share;
  std::vector<std::int32_t> edge;  ///< slot at the edge of contact next to it, (RP.81)
  std::vector<Point<D>> normal;    ///< of the wall; next to an edge, that of the body's side
  std::vector<Point<D>> foot;      ///< foot point at xi = 0 [m]
  std::vector<kernels::FitTerms<T, D>> terms;  ///< of the fits (RP.43), (RP.44)
  std::vector<T> constrained_sum;              ///< sum of the coefficients b
  std::vector<T> surface_sum;                ///< sum of a: 1, or 0 where the surface ends at a wall
  std::vector<std::array<T, D>> correction;  ///< (RP.50) of the present stage [m/s]
  std::vector<std::array<T, D>> lasting;     ///< lasting part of it, (RP.50) [m/s]
  std::vector<std::array<T, D>> initial_drift;    ///< [reached] drift before the step [m]
  std::vector<std::array<T, D>> drift_increment;  ///< [reached] change of the drift since then [m]
  std::vector<std::int64_t> begin;                ///< [ghost + 1] into `pairs`
  std::vector<kernels::FitPair> pairs;            ///< with interior particles
  std::vector<std::int64_t> wall_begin;           ///< into `wall_distance`; -1: free surface
  std::vector<T> wall_distance;                   ///< of the particles of walls' ghosts, over h
  /// A slot beyond a contact wall has two ghosts, one of the free surface and, next in order, one
  /// of the wall. The latter are listed here. One of the two is active, (RP.52).
  std::vector<std::int32_t> contact;
  /// [contact] height of the surface above the wall, with xi = 0 and the wall at t = 0, (RP.52) [m]
  std::vector<double> contact_height;
  std::vector<double> contact_area;  ///< [contact] share of the wall, (RP.65) [m^(D-1)]
  /// Ghosts of the free surface behind a no-slip wall, (RP.116), in the order of the ghosts.
  std::vector<std::int32_t> rim_ghost;
  std::vector<std::int8_t> rim_wall;  ///< [rim ghost] the wall
  std::vector<T> rim_share;           ///< [rim ghost] part of the velocity that it determines
  std::vector<Point<D>> rim_point;    ///< [rim ghost] x_w of (RP.114) [m]
  std::vector<std::array<T, D>> rim_normal;        ///< [rim ghost] of the wall, at the remeshing
  std::vector<kernels::FitTerms<T, D>> rim_terms;  ///< [rim ghost] b of (RP.46)
  ContactPoints<T, D> contact_points;              ///< with other bodies
  std::vector<kernels::SurfacePack> packs;
  std::int32_t first_record = 0, record_count = 0;

  /// Calls f(field, list) for every list of the ghosts, without those of their contact points.
  template <class F>
  static void for_each_list(F&& f) {
    using G = BlockGhosts;
    f(Field::ghost_slot, &G::slot);
    f(Field::wall, &G::wall);
    f(Field::active, &G::active);
    f(Field::pressure, &G::pressure);
    f(Field::ghost_face, &G::face);
    f(Field::ghost_face_load, &G::face_load);
    f(Field::ghost_face_share, &G::face_share);
    f(Field::edge, &G::edge);
    f(Field::normal, &G::normal);
    f(Field::foot, &G::foot);
    f(Field::terms, &G::terms);
    f(Field::constrained_sum, &G::constrained_sum);
    f(Field::surface_sum, &G::surface_sum);
    f(Field::correction, &G::correction);
    f(Field::lasting_correction, &G::lasting);
    f(Field::initial_drift, &G::initial_drift);
    f(Field::drift_increment, &G::drift_increment);
    f(Field::pairs_begin, &G::begin);
    f(Field::pairs, &G::pairs);
    f(Field::wall_begin, &G::wall_begin);
    f(Field::wall_distance, &G::wall_distance);
    f(Field::contact, &G::contact);
    f(Field::contact_height, &G::contact_height);
    f(Field::contact_area, &G::contact_area);
    f(Field::rim_ghost, &G::rim_ghost);
    f(Field::rim_wall, &G::rim_wall);
    f(Field::rim_share, &G::rim_share);
    f(Field::rim_point, &G::rim_point);
    f(Field::rim_normal, &G::rim_normal);
    f(Field::rim_terms, &G::rim_terms);
  }

  /// Ends the ghosts that come first.
  void end_reached(std::size_t count) {
    reached_count = count;
    initial_drift.resize(count);
    drift_increment.resize(count);
  }

  /// Removes the ghosts; the records stay.
  void clear() {
    for_each_list([this](Field, auto list) { (this->*list).clear(); });
    begin.push_back(0);
    reached_count = 0;
    contact_points.clear();
  }

  /// Values in the sums of a ghost.
  static constexpr int sums_of_ghost = 3 * kernels::record_width<D>;

  /// Arguments for the sums of ghosts first..first+count-1 of a body.
  kernels::GhostSums<T, D> sums(std::size_t first, std::size_t count, const Body<T, D>& body,
                                T* into) const {
    return {static_cast<std::int64_t>(first),
            static_cast<std::int64_t>(count),
            begin.data(),
            pairs.data(),
            terms.data(),
            wall_begin.data(),
            wall_distance.data(),
            body.population.surface_distance.data(),
            body.records.get(),
            into};
  }

  /// The fits of ghost g from its sums.
  kernels::GhostFits<T, D> fits(std::size_t g, const T* of) const {
    constexpr int width = kernels::record_width<D>;
    return {{of}, {of + width}, {of + 2 * width}, constrained_sum[g], surface_sum[g]};
  }
};

/// The slots of a body after a remeshing: places, kinds, and how ghosts read them.
template <class T, int D>
struct Population {
  Layout<D> layout;
  Buffer<Kind> kind;
  Buffer<PackState> pack_state;
  std::vector<BlockGhosts<T, D>> ghosts;  ///< [block]
  std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>>
      images;  ///< [block] (image, source)
  std::vector<std::int32_t> slot_of_record;
  std::vector<T> surface_distance;      ///< [record] phi over h at the remeshing
  std::vector<std::int8_t> load;        ///< [record] load on the nearest face
  std::vector<T> loaded_share;          ///< [record] share of the face there on which it acts
  std::vector<std::array<T, D>> face;   ///< [record] its normal at the remeshing, (RP.78)
  std::vector<std::array<T, D>> slope;  ///< [record] grad phi there
  std::int64_t particles = 0;           ///< interior
};

/// One body: its lattice, material, particles and surface. It shares nothing with other bodies.
///
/// A remeshing writes `spare` and `stage[1]`, which are not in use between steps, and then swaps
/// them with the current ones. Measuring between remeshings is a remeshing without the swap. Its
/// temporary data are in `stage[2]`, also unused between steps. During steps, the stress of the odd
/// stages uses the memory of those fields of `stage[1]` that do not evolve.
template <class T, int D>
struct Body {
  std::string name;
  const BodyCase* source = nullptr;
  kernels::Material<T> material;  ///< its density includes mass scaling, (RP.87)
  double mass_scaling = 1;        ///< M of (RP.87), included in the masses of the particles
  bool bears_loads = false;       ///< whether loads, body forces or ties act in the case
  bool has_surface = true;  ///< whether it has a surface phi = 0; false if it fills a periodic cell
  Lattice<D> lattice;
  Population<T, D> population, spare;
  std::array<FieldStore<T, D>, 3> stage;  ///< see buffer_of, drift_buffer_of; 0, 1: all fields
  std::array<Buffer<T>, kernels::symmetric_components<D>> stress;  ///< of the even stages
  Buffer<T> last_odd_stress;       ///< the component of the odd stages that has no other memory
  Buffer<kernels::Mark> interior;  ///< [slot] of `population`
  std::vector<kernels::PronyTerm<T>> prony;
  std::vector<T*> memory;   ///< [term] p_i of `stage[0]`
  Buffer<T> volume_change;  ///< J - 1 at the start of the step; empty without p_i
  Buffer<T> records;        ///< [record][record_width] of surface particles
  Buffer<std::int32_t> record_of_slot;
  std::vector<std::vector<LoadedFacet<D>>> loaded;  ///< [block]
  std::vector<BlockShear<D>> shear;                 ///< [block]
  BodyNeighbours<D> neighbours;

  /// Q of (RP.21) at a stage.
  template <class U = T>
  kernels::Evolving<U, D> evolving(int of_stage) {
    kernels::Evolving<U, D> view = stage[buffer_of(of_stage)].template evolving<U>();
    view.drift = stage[drift_buffer_of(of_stage)].template evolving<U>().drift;
    return view;
  }

  /// Calls f(field, copy, buffers) for every array of slots that the body's material needs and that
  /// is not in `stage`.
  template <class F>
  void for_each_array(F&& f) {
    visit_arrays(*this, f);
  }
  template <class F>
  void for_each_array(F&& f) const {
    visit_arrays(*this, f);
  }

  /// A component of sigma of the even or of the odd stages.
  Buffer<T>& stress_component(int parity, int component) {
    return stress_component_of(*this, parity, component);
  }
  std::array<T*, kernels::symmetric_components<D>> stress_view(int parity) {
    return stress_view_of<T>(*this, parity);
  }
  std::array<const T*, kernels::symmetric_components<D>> stress_view(int parity) const {
    return stress_view_of<const T>(*this, parity);
  }

  kernels::BulkViscosity<T> viscosity(const kernels::Relaxation<T>* relaxation = nullptr) {
    return {static_cast<int>(prony.size()), relaxation, memory.data(), volume_change.get()};
  }

  /// Position of a slot's particle [m].
  Point<D> position(std::int64_t slot, const Cell<D>& cell) const {
    Point<D> x = lattice.node(cell);
    for (int a = 0; a < D; ++a) x[a] += stage[0].get(Field::drift, a)[slot];
    return x;
  }

 private:
  static constexpr bool has_own_odd_stress =
      odd_stress_storage<D>.size() < kernels::symmetric_components<D>;

  template <class Self, class F>
  static void visit_arrays(Self& body, F&& f) {
    using std::span;
    f(Field::stress, 0, span(body.stress));
    if (has_own_odd_stress) f(Field::stress, 1, span(&body.last_odd_stress, 1));
    f(Field::interior, 0, span(&body.interior, 1));
    if (!body.prony.empty()) f(Field::volume_change, 0, span(&body.volume_change, 1));
  }
  template <class Self>
  static auto& stress_component_of(Self& body, int parity, int component) {
    if (parity == 0) return body.stress[component];
    if (component == std::ssize(odd_stress_storage<D>)) return body.last_odd_stress;
    const StateComponent& place = odd_stress_storage<D>[component];
    return body.stage[1][place.field][place.component];
  }
  template <class U, class Self>
  static std::array<U*, kernels::symmetric_components<D>> stress_view_of(Self& body, int parity) {
    std::array<U*, kernels::symmetric_components<D>> view;
    for (std::size_t c = 0; c < view.size(); ++c) {
      view[c] = stress_component_of(body, parity, static_cast<int>(c)).get();
    }
    return view;
  }
};

}  // namespace pliant::remeshed
