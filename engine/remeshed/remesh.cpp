#include "engine/remeshed/remesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

namespace {

// Small bodies are divided among threads as long as blocks are worth a task; large ones into blocks
// that fit a second-level cache. Four leading bits of the number: it stays as it is, and with it
// the step graph, until a body has grown or shrunk by some percent.
int block_count(std::int64_t slots) {
  constexpr std::int64_t smallest_block = 256, largest_block = 3072, blocks_of_small_bodies = 12;
  const std::int64_t count = std::max({std::min(slots / smallest_block, blocks_of_small_bodies),
                                       slots / largest_block, std::int64_t{1}});
  std::int64_t unit = 1;
  while (count / unit >= 16) unit *= 2;
  return static_cast<int>(count / unit * unit);
}

}  // namespace

template <class T, int D>
Remeshing<T, D>::Remeshing(const Case& settings, Body<T, D>& body, const Boundaries<D>& boundaries,
                           const kernels::Table<T, D>& kernels, scheduler::Workers& workers)
    : body_(body),
      boundaries_(boundaries),
      kernels_(kernels),
      workers_(workers),
      treatment_(settings.ghosts),
      stencil_reach_(kernels::stencil_reach(settings.discretisation.weight)),
      filter_strength_(settings.remeshing.filter),
      extensive_(settings.remeshing.extensive),
      filtered_memory_(body.prony.size()),
      tiles_(workers.threads()) {}

template <class T, int D>
void Remeshing<T, D>::departure_phases(std::vector<scheduler::Phase>& phases, int first_block) {
  using scheduler::Phase;
  using scheduler::Reach;
  std::vector<int> own(body_.population.layout.blocks().size());
  for (std::size_t b = 0; b < own.size(); ++b) own[b] = first_block + static_cast<int>(b);
  phases.push_back({"remesh: ghosts",
                    -1,
                    {{resource::drift(0), Reach::neighbours},
                     {resource::material(0), Reach::neighbours},
                     {resource::contact}},
                    {{resource::constants}},
                    Phase::Extent::per_block,
                    own,
                    [this, first_block](int b) { fill_conserved(body_, b - first_block); }});
  phases.push_back({"remesh: layout",
                    -1,
                    {{resource::drift(0)}, {resource::contact}},
                    {{resource::bounds}},
                    Phase::Extent::per_block,
                    own,
                    [this, first_block](int b) { find_bounds(b - first_block); }});
  phases.push_back({"remesh: layout",
                    -1,
                    {{resource::bounds, Reach::all},
                     {resource::drift(0), Reach::all},
                     {resource::contact, Reach::all}},
                    {{resource::remeshed, Reach::all}},
                    Phase::Extent::once,
                    {},
                    [this](int) { lay_out(); }});
}

template <class T, int D>
void Remeshing<T, D>::find_bounds(int block) {
  bounds_.resize(body_.population.layout.blocks().size());
  constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
  Bounds found;
  found.lower.fill(none);
  found.upper.fill(-none);
  const T scale = static_cast<T>(1 / body_.lattice.spacing);
  std::array<const T*, D> drift;
  for (int a = 0; a < D; ++a) drift[a] = body_.stage[0].get(Field::displacement, a);
  const Population<T, D>& from = body_.population;
  from.layout.for_each_slot(from.layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    if (from.kind[p] == Kind::vacant || from.kind[p] == Kind::image) return;
    for (int a = 0; a < D; ++a) {
      const auto at = cell[a] + static_cast<std::int32_t>(std::floor(drift[a][p] * scale + T(0.5)));
      found.lower[a] = std::min(found.lower[a], at);
      found.upper[a] = std::max(found.upper[a], at);
    }
  });
  bounds_[block] = found;
}

// The new layout holds every pack within reach of an interior particle.
template <class T, int D>
void Remeshing<T, D>::lay_out() {
  const Population<T, D>& from = body_.population;
  Bounds all = bounds_[0];
  for (std::size_t b = 0; b < from.layout.blocks().size(); ++b) {
    for (int a = 0; a < D; ++a) {
      all.lower[a] = std::min(all.lower[a], bounds_[b].lower[a]);
      all.upper[a] = std::max(all.upper[a], bounds_[b].upper[a]);
    }
  }
  for (int a = 0; a < D; ++a) {
    if (body_.lattice.period[a] == 0) continue;
    all.lower[a] = 0;
    all.upper[a] = body_.lattice.period[a] - 1;
  }
  occupancy_.reset(all.lower, all.upper, layout_reach);
  const T scale = static_cast<T>(1 / body_.lattice.spacing);
  std::array<const T*, D> drift;
  for (int a = 0; a < D; ++a) drift[a] = body_.stage[0].get(Field::displacement, a);
  for (const Block<D>& block : from.layout.blocks()) {
    from.layout.for_each_slot(block, [&](std::int64_t p, Cell<D> cell) {
      if (from.kind[p] != Kind::interior) return;
      for (int a = 0; a < D; ++a) {
        cell[a] += static_cast<std::int32_t>(std::floor(drift[a][p] * scale + T(0.5)));
      }
      occupancy_.mark(body_.lattice.wrapped(cell));
    });
  }
  occupancy_.dilate(layout_reach);
  prepare_spare();
}

template <class T, int D>
void Remeshing<T, D>::prepare_spare() {
  Population<T, D>& to = body_.spare;
  std::int64_t marked = 0;
  for (int row = 0; row < occupancy_.rows(); ++row) {
    for (int column = 0; column < occupancy_.columns(); ++column) {
      marked += occupancy_.is_marked(row, column);
    }
  }
  to.layout.build(occupancy_, body_.lattice.period, block_count(marked * Layout<D>::pack),
                  block_reach);
  const std::int64_t slots = to.layout.slots();
  const std::size_t blocks = to.layout.blocks().size();
  to.kind.grow(slots, Kind::vacant);
  to.pack_state.grow(slots / Layout<D>::pack + 1, PackState::vacant);
  to.images.resize(blocks);
  particles_.assign(blocks, 0);
  body_.stage[1].grow(slots);
  body_.stage[2].grow(slots);
  for (Buffer<T>& filtered : filtered_memory_) filtered.grow(slots, T(0));
  body_.record_of_slot.grow(slots, 0);
  std::fill_n(body_.record_of_slot.get(), slots, 0);
  level_set_.prepare(body_.lattice, to.layout, body_.stage[1].get(Field::level_set));
  borrow_arrays();
}

// What is needed only now lies in stage[2] beside the filtered fields, and in their place once they
// are adopted.
template <class T, int D>
void Remeshing<T, D>::borrow_arrays() {
  FieldStore<T, D>& dead = body_.stage[2];
  inside_ = dead.get(Field::displacement, 0);
  valid_ = dead.get(Field::displacement, 1);
  std::array<T*, D> foot;
  for (int a = 0; a < D; ++a) foot[a] = dead.get(Field::velocity, a);
  level_set_.use(dead.get(Field::material, 0), foot);
}

template <class T, int D>
void Remeshing<T, D>::arrival_phases(std::vector<scheduler::Phase>& phases, int first_block,
                                     bool from_particles) {
  using scheduler::Access;
  using scheduler::Phase;
  using scheduler::Reach;
  std::vector<int> own(body_.spare.layout.blocks().size());
  for (std::size_t b = 0; b < own.size(); ++b) own[b] = first_block + static_cast<int>(b);
  const auto each = [&](const char* name, std::vector<Access> reads, std::vector<Access> writes,
                        auto run) {
    phases.push_back({name, -1, std::move(reads), std::move(writes), Phase::Extent::per_block, own,
                      [this, run, first_block](int b) { (this->*run)(b - first_block); }});
  };
  const auto once = [&](const char* name, std::vector<Access> reads, std::vector<Access> writes,
                        auto run) {
    phases.push_back(
        {name, -1, std::move(reads), std::move(writes), Phase::Extent::once, {}, [this, run](int) {
           (this->*run)();
         }});
  };
  const Access remeshed_near{resource::remeshed, Reach::neighbours};
  const Access images_near{resource::remeshed_images, Reach::neighbours};
  if (from_particles) {
    each("remesh: scatter", {}, {{resource::remeshed}}, &Remeshing::scatter);
    each("remesh: images", {remeshed_near}, {{resource::remeshed_images}}, &Remeshing::copy_images);
    if (filter_strength_ > 0) {
      each("remesh: filter", {remeshed_near, images_near}, {{resource::filtered}},
           &Remeshing::filter);
      once("remesh: filter", {{resource::filtered, Reach::all}}, {{resource::remeshed, Reach::all}},
           &Remeshing::adopt_filtered);
    }
  }
  if (has_surface_) {
    each("level set: walls", {remeshed_near}, {{resource::extended}}, &Remeshing::extend_level_set);
    each("level set: closest points", {{resource::extended, Reach::neighbours}},
         {{resource::closest(0)}}, &Remeshing::find_closest_points);
    for (int layer = 2; layer <= LevelSet<T, D>::layers; ++layer) {
      phases.push_back({"level set: layers",
                        layer,
                        {{resource::extended, Reach::neighbours},
                         {resource::closest(layer % 2), Reach::neighbours}},
                        {{resource::closest((layer + 1) % 2)}},
                        Phase::Extent::per_block,
                        own,
                        [this, layer, first_block](int b) {
                          level_set_.add_layer(body_.spare.layout.blocks()[b - first_block], layer,
                                               kernels_);
                        }});
    }
  }
  each("remesh: kinds", {{resource::closest(0)}, {resource::closest(1)}, {resource::remeshed}},
       {{resource::kinds}, {resource::remeshed}, {resource::extended}}, &Remeshing::find_kinds);
  each("remesh: images", {{resource::kinds, Reach::neighbours}, remeshed_near},
       {{resource::remeshed_images}}, &Remeshing::copy_images);
  each("ghosts: fits",
       {{resource::kinds, Reach::neighbours},
        {resource::closest(1)},
        {resource::extended, Reach::neighbours},
        remeshed_near,
        images_near},
       {{resource::fits}}, &Remeshing::fit_block);
  // Fits of all neighbouring blocks mark this block's surface particles.
  each("ghosts: surface", {{resource::fits, Reach::neighbours}}, {{resource::surface_packs}},
       &Remeshing::list_surface);
  once("ghosts: surface", {{resource::surface_packs, Reach::all}},
       {{resource::record_numbers, Reach::all}}, &Remeshing::number_all);
  each("ghosts: surface", {{resource::record_numbers}}, {{resource::fits}},
       &Remeshing::resolve_block);
}

template <class T, int D>
void Remeshing<T, D>::prepare_arrival(bool reinitialise, bool is_final) {
  reinitialise_ = reinitialise;
  is_final_ = is_final;
  if (!is_final) return;
  const std::size_t blocks = body_.spare.layout.blocks().size();
  body_.spare.ghosts.swap(body_.population.ghosts);
  body_.spare.ghosts.resize(blocks);
}

template <class T, int D>
void Remeshing<T, D>::extend_level_set(int block) {
  level_set_.extend_through_walls(body_.spare.layout.blocks()[block], boundaries_, valid_);
}

template <class T, int D>
void Remeshing<T, D>::find_closest_points(int block) {
  level_set_.find_closest_points(body_.spare.layout.blocks()[block], reinitialise_, kernels_);
}

template <class T, int D>
void Remeshing<T, D>::find_kinds(int block) {
  if (has_surface_) level_set_.finish(body_.spare.layout.blocks()[block]);
  if (body_.material.model == kernels::Model::reduced_polynomial) match_volumes(block);
  particles_[block] =
      classify<T, D>(body_, body_.spare, body_.stage[1], block, boundaries_, valid_);
}

template <class T, int D>
void Remeshing<T, D>::fit_block(int block) {
  if (!is_final_) return;
  fit_ghosts<T, D>(
      {body_, body_.spare, level_set_, boundaries_, treatment_, stencil_reach_, kernels_}, block,
      body_.record_of_slot.get());
}

template <class T, int D>
void Remeshing<T, D>::list_surface(int block) {
  if (!is_final_) return;
  list_surface_particles<T, D>(body_.spare, block, body_.record_of_slot.get());
}

template <class T, int D>
void Remeshing<T, D>::number_all() {
  if (!is_final_) return;
  number_records<T, D>(body_.spare, level_set_, body_.lattice.spacing, body_.record_of_slot.get());
}

template <class T, int D>
void Remeshing<T, D>::resolve_block(int block) {
  if (!is_final_) return;
  resolve_records<T, D>(body_.spare, block, body_.record_of_slot.get());
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
  const std::int64_t slots = body_.population.layout.slots();
  for (auto& buffer : body_.stage) buffer.grow(slots);
  body_.memory.clear();
  for (Buffer<T>& pressure : body_.stage[0][Field::memory]) body_.memory.push_back(pressure.get());
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
  occupancy_.restore(occupancy);
  prepare_spare();
  prepare_arrival(false, true);
  std::swap(body_.population, body_.spare);
  grow_stages();
}

template <class T, int D>
void Remeshing<T, D>::adopt_restored() {
  grow_stages();
  for (std::size_t b = 0; b < body_.population.images.size(); ++b) {
    list_images(body_.population, static_cast<int>(b));
    prepare_slots<T, D>(body_, static_cast<int>(b));
  }
}

template class Remeshing<double, 2>;
template class Remeshing<double, 3>;

}  // namespace pliant::remeshed
