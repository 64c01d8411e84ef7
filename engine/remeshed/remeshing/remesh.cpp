#include "engine/remeshed/remeshing/remesh.hpp"

#include <algorithm>
#include <span>

#include "engine/case/attached_walls.hpp"
#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/level_set/initial_surface.hpp"
#include "engine/remeshed/loads/shear_patches.hpp"
#include "engine/remeshed/setup/images.hpp"
#include "engine/remeshed/setup/initial_fields.hpp"
#include "engine/remeshed/state/resources.hpp"

// The remeshing of H&K, section 2.3, in two graphs, since the blocks of the new lattice are known
// only after the first. Over the blocks of the old lattice:
//
//     remesh: ghosts    ghosts take the fitted density, material state and displacement
//     remesh: layout    the packs within reach of any particle become the new lattice
//
// Over the blocks of the new lattice:
//
//     remesh: scatter   M4' sums over particles and ghosts at the new nodes, and the fields from
//                       them (RP.31)-(RP.36)
//     remesh: images    periodic bodies: slots beyond a period copy the nodes one period away
//     remesh: filter    high-order filter (RP.37)
//     level set: initial surface   moves phi of bodies that no wall holds towards the surface that
//                       their displacements give (RP.92)
//     level set: walls  extends phi through walls
//     level set: first order   the paper's reinitialisation, if the case uses it (RP.74)
//     level set: closest points   on the surface, for the nodes near it (RP.41)
//     level set: distances   if due, phi becomes the distance to them, except near edges (RP.82)
//     level set: layers           the same layer by layer further out (RP.40)
//     remesh: kinds     which slots hold particles and ghosts; det F = rho0/rho (RP.38)
//     ghosts: corners   re-entrant corners of the surface, near which fits are others (RP.109)
//     ghosts: fits      the coefficients of the ghosts (RP.43), (RP.44)
//     ghosts: surface   surface records for the particles that fits read
//     ghosts: loads     the loads on the faces nearest to those particles, and on ghosts (RP.78)
//     loaded facets     the facets of {phi = 0} on which loads do work (RP.72), and the particles
//                       behind those under tractions (RP.107)
//     shear shares      for each block, the shares of its particles in these tractions
namespace pliant::remeshed {

using namespace resource;
using enum Group;

namespace {

/// The state of particles and ghosts on the old lattice.
Resources old_state() {
  Resources state = whole(kinds);
  for (const Group group : {drift, velocity, material, constants, memory}) {
    state = state + particles(group) + ghosts(group);
  }
  return state;
}

/// What shares the memory of the filtered state when that is no longer needed.
Resources in_place_of_filtered() { return whole(extended) + whole(closest, 0) + whole(closest, 1); }

/// All fields for which a new layout makes room.
Resources new_lattice() {
  return with_images(new_state) + with_images(new_kinds) + with_images(marks) + whole(filtered) +
         in_place_of_filtered() + whole(particle_counts) + whole(used);
}

}  // namespace

template <class T, int D>
Remeshing<T, D>::Remeshing(const Case& settings, Body<T, D>& body, const Boundaries<D>& boundaries,
                           const kernels::RemeshedTable<T, D>& kernels, scheduler::Workers& workers,
                           Outside outside)
    : body_(body),
      initial_surface_(initial_surface(settings, *body.source)),
      boundaries_(boundaries),
      kernels_(kernels),
      parameters_(parameters_of(settings)),
      treatment_(settings.ghosts),
      stencil_reach_(kernels::stencil_reach(settings.discretisation.kernel)),
      outside_(outside),
      layout_search_(body, !boundaries.walls.empty()),
      fields_(settings, body, kernels, workers),
      level_set_(parameters_.reinitialisation) {}

template <class T, int D>
void Remeshing<T, D>::place_initial(const Case& settings) {
  layout_search_.mark_geometry();
  prepare_spare();
  body_.has_surface = set_initial_fields(settings, body_, fields_.valid());
}

template <class T, int D>
void Remeshing<T, D>::source_phases(std::vector<scheduler::Phase>& phases, int first_block) {
  PhaseRows rows(phases, first_block, body_.population.layout.blocks().size());
  rows.each(
      "remesh: ghosts",
      near(particles(drift) + particles(material) + particles(constants) + particles(memory)) +
          own(ghosts(drift) + whole(fits) + whole(contact)),
      own(ghosts(material) + ghosts(constants) + ghosts(memory)),
      [this](int b) { fill_conserved(body_, b); });
  rows.each("remesh: layout", own(particles(drift) + ghosts(drift) + whole(kinds)),
            own(whole(bounds)), [this](int b) { layout_search_.find_bounds(b); });
  rows.reduce("remesh: layout", all(whole(bounds) + particles(drift) + whole(kinds)),
              all(new_lattice()), [this] {
                has_layout_ = layout_search_.mark_particles();
                if (has_layout_) prepare_spare();
              });
}

template <class T, int D>
void Remeshing<T, D>::prepare_spare() {
  Population<T, D>& to = body_.spare;
  layout_search_.build(to.layout);
  const std::int64_t slots = to.layout.slots();
  const std::size_t blocks = to.layout.blocks().size();
  to.kind.grow(slots, Kind::vacant);
  to.pack_state.grow(slots / Layout<D>::pack + 1, PackState::vacant);
  to.images.resize(blocks);
  particles_.assign(blocks, 0);
  body_.record_of_slot.grow(slots, 0);
  std::fill_n(body_.record_of_slot.get(), slots, 0);
  fields_.prepare();
  level_set_.prepare(body_.lattice, to.layout, body_.stage[1].get(Field::level_set));
  share_with_level_set();
}

// Uses the memory in which the filter has left its fields, after they are swapped in.
template <class T, int D>
void Remeshing<T, D>::share_with_level_set() {
  FieldStore<T, D>& dead = body_.stage[2];
  std::array<T*, D> foot;
  for (int a = 0; a < D; ++a) foot[a] = dead.get(Field::velocity, a);
  level_set_.use(dead.get(Field::material, 0), foot);
}

template <class T, int D>
void Remeshing<T, D>::prepare_target(bool reinitialise, bool is_final) {
  reinitialise_ = reinitialise;
  is_final_ = is_final;
  level_set_.use_layers(is_final ? LevelSet<T, D>::layers : LevelSet<T, D>::observed_layers);
  if (!is_final) return;
  body_.spare.ghosts.swap(body_.population.ghosts);
  body_.spare.ghosts.resize(body_.spare.layout.blocks().size());
  const std::size_t blocks = body_.spare.layout.blocks().size();
  corners_.resize(blocks);
  body_.loaded.resize(blocks);
  body_.shear.resize(blocks);
}

template <class T, int D>
void Remeshing<T, D>::target_phases(std::vector<scheduler::Phase>& phases, int first_block,
                                    bool from_particles) {
  PhaseRows rows(phases, first_block, body_.spare.layout.blocks().size());
  if (from_particles) add_fields(rows);
  if (body_.has_surface) {
    if (from_particles) add_initial_surface(rows);
    add_level_set(rows);
  }
  rows.each("remesh: kinds",
            own(whole(closest, 0) + whole(closest, 1) + particles(new_state) + particles(marks)),
            own(with_images(new_state) + with_images(new_kinds) + with_images(marks) +
                whole(extended) + whole(particle_counts)),
            [this](int b) { find_kinds(b); });
  rows.each("remesh: images", near(particles(new_state) + particles(new_kinds) + particles(marks)),
            own(images(new_state) + images(new_kinds) + images(marks)),
            [this](int b) { fields_.copy_images(b); });
  add_ghosts(rows);
}

// A block gathers from all blocks of the old lattice, which has its own numbering.
template <class T, int D>
void Remeshing<T, D>::add_fields(PhaseRows& rows) {
  const Resources state = with_images(new_state) + with_images(new_kinds) + with_images(marks);
  rows.each("remesh: scatter", all(old_state() + whole(bounds)), own(state),
            [this](int b) { fields_.scatter(b, layout_search_.bounds()); });
  rows.each("remesh: images", near(particles(new_state) + particles(new_kinds) + particles(marks)),
            own(images(new_state) + images(new_kinds) + images(marks)),
            [this](int b) { fields_.copy_images(b); });
  if (!fields_.filters()) return;
  rows.each("remesh: filter", near(with_images(new_state) + with_images(marks)),
            own(whole(filtered)), [this](int b) { fields_.filter(b); });
  rows.reduce("remesh: filter", all(whole(filtered)),
              all(with_images(new_state) + whole(filtered) + in_place_of_filtered()), [this] {
                fields_.swap_in_filtered();
                share_with_level_set();
              });
}

// Near walls, displacements are less accurate than phi, and in periodic cells they pass the ends.
template <class T, int D>
void Remeshing<T, D>::add_initial_surface(PhaseRows& rows) {
  if (boundaries_.have_attached_walls() || body_.lattice.is_periodic() ||
      level_set_.is_first_order()) {
    return;
  }
  rows.each("level set: initial surface", own(with_images(new_state) + with_images(marks)),
            own(with_images(new_state)), [this](int b) {
              recall_initial_surface<T, D>(body_.lattice, body_.spare.layout, b, initial_surface_,
                                           fields_.valid(), body_.stage[1]);
            });
}

template <class T, int D>
void Remeshing<T, D>::add_level_set(PhaseRows& rows) {
  const auto block = [this](int b) -> const Block<D>& { return body_.spare.layout.blocks()[b]; };
  rows.each("level set: walls", near(with_images(new_state) + with_images(marks)),
            own(whole(extended)), [this, block](int b) {
              level_set_.extend_through_walls(block(b), boundaries_, initial_surface_,
                                              fields_.valid());
            });
  if (level_set_.is_first_order()) add_first_order_passes(rows);
  rows.each("level set: closest points", near(whole(extended)),
            own(whole(closest, 0) + with_images(new_state)),
            [this, block](int b) { level_set_.find_closest_points(block(b), kernels_); });
  if (!level_set_.is_first_order()) {
    rows.each("level set: distances", near(whole(extended) + whole(closest, 0)),
              own(with_images(new_state)), [this, block](int b) {
                if (reinitialise_) level_set_.take_distances(block(b));
              });
  }
  for (int layer = 2; layer <= LevelSet<T, D>::layers; ++layer) {
    rows.at_stage(layer).each(
        "level set: layers", near(whole(extended) + whole(closest, layer % 2)),
        own(whole(closest, (layer + 1) % 2) + with_images(new_state)),
        [this, block, layer](int b) { level_set_.add_layer(block(b), layer, kernels_); });
  }
  rows.at_stage(-1);
}

// phi alternates between its two arrays; the memory of closest points holds its former values.
template <class T, int D>
void Remeshing<T, D>::add_first_order_passes(PhaseRows& rows) {
  const Resources phi[] = {whole(extended), with_images(new_state)};
  for (int pass = 0; pass < first_order_passes; ++pass) {
    rows.at_stage(pass).each("level set: first order", near(phi[pass % 2]) + own(whole(closest, 0)),
                             own(phi[1 - pass % 2] + whole(closest, 0)), [this, pass](int b) {
                               if (!reinitialise_) return;
                               level_set_.advance(body_.spare.layout.blocks()[b], pass);
                             });
  }
  rows.at_stage(-1);
}

template <class T, int D>
void Remeshing<T, D>::commit() {
  body_.spare.particles = 0;
  for (const std::int64_t count : particles_) body_.spare.particles += count;
  std::swap(body_.population, body_.spare);
  std::swap(body_.stage[0], body_.stage[1]);
  grow_stages();
}

template <class T, int D>
void Remeshing<T, D>::grow_stages() {
  layout_search_.prepare();
  const std::int64_t slots = body_.population.layout.slots();
  for (auto& buffer : body_.stage) buffer.grow(slots);
  body_.memory.clear();
  for (Buffer<T>& pressure : body_.stage[0][Field::memory_pressure])
    body_.memory.push_back(pressure.get());
  body_.for_each_array([slots](Field, int, auto components) {
    for (auto& component : components) component.grow(slots, 0);
  });
  body_.records.grow(body_.population.slot_of_record.size() * kernels::record_width<D>, T(0));
}

template <class T, int D>
void Remeshing<T, D>::lay_out_again(const std::vector<std::int32_t>& occupancy) {
  layout_search_.restore(occupancy);
  prepare_spare();
  prepare_target(false, true);
  std::swap(body_.population, body_.spare);
  grow_stages();
}

template <class T, int D>
void Remeshing<T, D>::swap_in_restored() {
  grow_stages();
  const int blocks = static_cast<int>(body_.population.images.size());
  for (int b = 0; b < blocks; ++b) {
    list_images(body_.lattice, body_.population, b);
    prepare_slots<T, D>(body_, b);
    find_facets({body_, body_.population, body_.stage[0]}, b);
  }
  for (int b = 0; b < blocks; ++b) list_shear_shares(body_, body_.population.layout, b);
}

template class Remeshing<double, 2>;
template class Remeshing<double, 3>;
template class Remeshing<float, 2>;
template class Remeshing<float, 3>;

}  // namespace pliant::remeshed
