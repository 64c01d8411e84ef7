#include "engine/remeshed/remeshing/remesh.hpp"

#include <algorithm>

#include "engine/remeshed/images.hpp"
#include "engine/remeshed/initial_fields.hpp"
#include "engine/remeshed/resources.hpp"

// The remeshing of H&K, section 2.3:
//
//   departure   ghosts take up the fitted density, material state and displacement
//               the packs within reach of any particle become the new layout
//   arrival     M4' scatter of particles and ghosts onto the new nodes      (RP.21)-(RP.26)
//               high-order filter                                           (RP.27)
//               det F = rho0/rho                                            (RP.46)
//               level set: continued through walls, rebuilt, reinitialised  (RP.29), (RP.30)
//               kinds of the slots; fits of the ghosts                      (RP.32), (RP.33)
namespace pliant::remeshed {

using scheduler::Access;
using scheduler::Reach;

template <class T, int D>
Remeshing<T, D>::Remeshing(const Case& settings, Body<T, D>& body, const Boundaries<D>& boundaries,
                           const kernels::RemeshedTable<T, D>& kernels, scheduler::Workers& workers)
    : body_(body),
      boundaries_(boundaries),
      kernels_(kernels),
      treatment_(settings.ghosts),
      stencil_reach_(kernels::stencil_reach(settings.discretisation.kernel)),
      layout_search_(body),
      fields_(settings, body, kernels, workers) {}

template <class T, int D>
void Remeshing<T, D>::place_initial(const Case& settings) {
  layout_search_.mark_geometry();
  prepare_spare();
  body_.has_surface = set_initial_fields(settings, body_, fields_.valid());
}

template <class T, int D>
void Remeshing<T, D>::source_phases(std::vector<scheduler::Phase>& all, int first_block) {
  BodyPhases phases(all, first_block, body_.population.layout.blocks().size());
  phases.each("remesh: ghosts",
              {{resource::drift(0), Reach::neighbours},
               {resource::material(0), Reach::neighbours},
               {resource::contact}},
              {{resource::constants}}, [this](int b) { fill_conserved(body_, b); });
  phases.each("remesh: layout", {{resource::drift(0)}, {resource::contact}}, {{resource::bounds}},
              [this](int b) { layout_search_.find_bounds(b); });
  phases.reduce("remesh: layout",
                {{resource::bounds, Reach::all},
                 {resource::drift(0), Reach::all},
                 {resource::contact, Reach::all}},
                {{resource::remeshed, Reach::all}}, [this] {
                  layout_search_.mark_particles();
                  prepare_spare();
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

// Where the filter has left its fields, once they are adopted.
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
  if (!is_final) return;
  body_.spare.ghosts.swap(body_.population.ghosts);
  body_.spare.ghosts.resize(body_.spare.layout.blocks().size());
}

template <class T, int D>
void Remeshing<T, D>::target_phases(std::vector<scheduler::Phase>& all, int first_block,
                                    bool from_particles) {
  BodyPhases phases(all, first_block, body_.spare.layout.blocks().size());
  if (from_particles) add_fields(phases);
  if (body_.has_surface) add_level_set(phases);
  phases.each("remesh: kinds",
              {{resource::closest(0)}, {resource::closest(1)}, {resource::remeshed}},
              {{resource::kinds}, {resource::remeshed}, {resource::extended}},
              [this](int b) { find_kinds(b); });
  phases.each("remesh: images",
              {{resource::kinds, Reach::neighbours}, {resource::remeshed, Reach::neighbours}},
              {{resource::remeshed_images}}, [this](int b) { fields_.copy_images(b); });
  add_ghosts(phases);
}

template <class T, int D>
void Remeshing<T, D>::add_fields(BodyPhases& phases) {
  const Access remeshed_near{resource::remeshed, Reach::neighbours};
  const Access images_near{resource::remeshed_images, Reach::neighbours};
  phases.each("remesh: scatter", {}, {{resource::remeshed}},
              [this](int b) { fields_.scatter(b, layout_search_.bounds()); });
  phases.each("remesh: images", {remeshed_near}, {{resource::remeshed_images}},
              [this](int b) { fields_.copy_images(b); });
  if (!fields_.filters()) return;
  phases.each("remesh: filter", {remeshed_near, images_near}, {{resource::filtered}},
              [this](int b) { fields_.filter(b); });
  phases.reduce("remesh: filter", {{resource::filtered, Reach::all}},
                {{resource::remeshed, Reach::all}}, [this] {
                  fields_.swap_in_filtered();
                  share_with_level_set();
                });
}

template <class T, int D>
void Remeshing<T, D>::add_level_set(BodyPhases& phases) {
  const auto block = [this](int b) -> const Block<D>& { return body_.spare.layout.blocks()[b]; };
  const Access extended_near{resource::extended, Reach::neighbours};
  phases.each("level set: walls", {{resource::remeshed, Reach::neighbours}}, {{resource::extended}},
              [this, block](int b) {
                level_set_.extend_through_walls(block(b), boundaries_, fields_.valid());
              });
  phases.each(
      "level set: closest points", {extended_near}, {{resource::closest(0)}},
      [this, block](int b) { level_set_.find_closest_points(block(b), reinitialise_, kernels_); });
  for (int layer = 2; layer <= LevelSet<T, D>::layers; ++layer) {
    phases.each(
        "level set: layers", {extended_near, {resource::closest(layer % 2), Reach::neighbours}},
        {{resource::closest((layer + 1) % 2)}},
        [this, block, layer](int b) { level_set_.add_layer(block(b), layer, kernels_); }, layer);
  }
}

// Only nodes that are to stay get ghosts.
template <class T, int D>
void Remeshing<T, D>::add_ghosts(BodyPhases& phases) {
  phases.each("ghosts: fits",
              {{resource::kinds, Reach::neighbours},
               {resource::closest(1)},
               {resource::extended, Reach::neighbours},
               {resource::remeshed, Reach::neighbours},
               {resource::remeshed_images, Reach::neighbours}},
              {{resource::fits}}, [this](int b) {
                if (is_final_) fit_block(b);
              });
  // Fits of all neighbouring blocks mark this block's surface particles.
  phases.each("ghosts: surface", {{resource::fits, Reach::neighbours}}, {{resource::surface_packs}},
              [this](int b) {
                if (is_final_) list_surface_particles(body_.spare, b, body_.record_of_slot.get());
              });
  phases.reduce("ghosts: surface", {{resource::surface_packs, Reach::all}},
                {{resource::record_numbers, Reach::all}}, [this] {
                  if (is_final_) {
                    number_records(body_.spare, level_set_, body_.lattice.spacing,
                                   body_.record_of_slot.get());
                  }
                });
  phases.each("ghosts: surface", {{resource::record_numbers}}, {{resource::fits}}, [this](int b) {
    if (is_final_) resolve_records(body_.spare, b, body_.record_of_slot.get());
  });
}

template <class T, int D>
void Remeshing<T, D>::find_kinds(int block) {
  if (body_.has_surface) level_set_.finish(body_.spare.layout.blocks()[block]);
  if (body_.material.model == kernels::Model::reduced_polynomial) fields_.match_volumes(block);
  particles_[block] =
      classify<T, D>(body_, body_.spare, body_.stage[1], block, boundaries_, fields_.valid());
}

template <class T, int D>
void Remeshing<T, D>::fit_block(int block) {
  fit_ghosts<T, D>(
      {body_, body_.spare, level_set_, boundaries_, treatment_, stencil_reach_, kernels_}, block,
      body_.record_of_slot.get());
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
  for (Buffer<T>& component : body_.stress) component.grow(slots, T(0));
  if (kernels::symmetric_components < D >> D + 2) body_.last_odd_stress.grow(slots, T(0));
  body_.interior.grow(slots, T(0));
  if (!body_.prony.empty()) body_.volume_change.grow(slots, T(0));
  if (body_.is_plain_sph) {
    for (auto& tensor : body_.pair_stress) {
      for (auto& component : tensor) component.grow(slots, T(0));
    }
  }
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
  for (std::size_t b = 0; b < body_.population.images.size(); ++b) {
    list_images(body_.lattice, body_.population, static_cast<int>(b));
    prepare_slots<T, D>(body_, static_cast<int>(b));
  }
}

template class Remeshing<double, 2>;
template class Remeshing<double, 3>;
template class Remeshing<float, 2>;
template class Remeshing<float, 3>;

}  // namespace pliant::remeshed
