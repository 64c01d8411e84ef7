#include "engine/remeshed/remeshing/remeshed_fields.hpp"

#include <algorithm>
#include <cmath>

#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/setup/images.hpp"
#include "kernels/remeshed/remeshing/set_determinant.hpp"

namespace pliant::remeshed {

template <class T, int D>
RemeshedFields<T, D>::RemeshedFields(const Case& settings, Body<T, D>& body,
                                     const kernels::RemeshedTable<T, D>& kernels,
                                     scheduler::Workers& workers)
    : body_(body),
      kernels_(kernels),
      workers_(workers),
      filter_strength_(settings.remeshing.filter),
      conserves_volume_(settings.remeshing.volume == VolumeRule::conserved),
      filtered_memory_(body.prony.size()),
      tiles_(workers.threads()) {}

template <class T, int D>
void RemeshedFields<T, D>::prepare() {
  const std::int64_t slots = body_.spare.layout.slots();
  body_.stage[1].grow(slots);
  body_.stage[2].grow(slots);
  for (Buffer<T>& filtered : filtered_memory_) filtered.grow(slots, T(0));
  // On the new lattice the drift is zero, so its memory is free.
  inside_ = body_.stage[1].get(Field::drift, 0);
  valid_ = body_.stage[1].get(Field::drift, 1);
}

template <class T, int D>
void RemeshedFields<T, D>::scatter(int block, const std::vector<CellBounds<D>>& bounds) {
  ScatterTile<T, D>& tile = tiles_[workers_.index()];
  tile.lay_out(body_.spare.layout, block);
  FieldStore<T, D>& state = body_.stage[0];
  TransportedFields<T, D> carried = {state.material_components(), {}};
  for (int c = 0; c < carried.count; ++c) carried.field[c] = state.get(Field::material, c);
  tile.fill(body_, bounds, carried, kernels_);
  take_nodes(block, tile);
  const int terms = static_cast<int>(body_.prony.size());
  for (int first = 0; first < terms; first += kernels::material_components<D>) {
    carried.count = std::min(terms - first, kernels::material_components<D>);
    for (int i = 0; i < carried.count; ++i) {
      carried.field[i] = state.get(Field::memory_pressure, first + i);
    }
    tile.fill(body_, bounds, carried, kernels_);
    take_memory(block, tile, first, carried.count);
  }
}

// The fields of (RP.33)-(RP.36).
template <class T, int D>
void RemeshedFields<T, D>::take_nodes(int block, ScatterTile<T, D>& tile) {
  using Node = kernels::NodeField<D>;
  FieldStore<T, D>& state = body_.stage[1];
  const T cell_volume = static_cast<T>(std::pow(body_.lattice.spacing, D));
  const Layout<D>& layout = body_.spare.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    const T* node = tile.node(cell);
    const T weight = node[Node::weight], mass = node[Node::mass], volume = node[Node::volume];
    const bool valid = weight >= T(0.6) && volume >= T(0.3) * cell_volume && mass > 0 &&
                       body_.lattice.is_wrapped(cell);
    valid_[p] = valid ? T(1) : T(0);
    inside_[p] = valid && node[Node::level_set] < 0 ? T(1) : T(0);
    // The filter already needs images, before the kinds of slots are known.
    body_.spare.kind[p] = valid ? Kind::interior : Kind::vacant;
    const T per_mass = valid ? 1 / mass : T(0), per_volume = valid ? 1 / volume : T(0);
    for (int a = 0; a < D; ++a) {
      state.get(Field::velocity, a)[p] = node[Node::momentum + a] * per_mass;
      state.get(Field::displacement, a)[p] = node[Node::displacement + a] * per_volume;
    }
    for (int c = 0; c < state.material_components(); ++c) {
      state.get(Field::material, c)[p] = node[Node::material + c] * per_volume;
    }
    state.get(Field::level_set)[p] =
        valid ? node[Node::level_set] / weight : T(LevelSet<T, D>::far * body_.lattice.spacing);
    state.get(Field::volume)[p] = valid && conserves_volume_ ? volume : cell_volume;
    state.get(Field::mass)[p] = !valid              ? body_.material.density * cell_volume
                                : conserves_volume_ ? mass
                                                    : mass * per_volume * cell_volume;
  });
}

// (RP.33) for p_i, which the second filling sums in place of F.
template <class T, int D>
void RemeshedFields<T, D>::take_memory(int block, ScatterTile<T, D>& tile, int first_term,
                                       int count) {
  using Node = kernels::NodeField<D>;
  const Layout<D>& layout = body_.spare.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    const T* node = tile.node(cell);
    for (int i = 0; i < count; ++i) {
      body_.stage[1].get(Field::memory_pressure, first_term + i)[p] =
          valid_[p] != 0 ? node[Node::material + i] / node[Node::volume] : T(0);
    }
  });
}

// Sets the determinant (RP.38).
template <class T, int D>
void RemeshedFields<T, D>::match_volumes(int block) {
  FieldStore<T, D>& state = body_.stage[1];
  const T* mass = state.get(Field::mass);
  const T* volume = state.get(Field::volume);
  const Layout<D>& layout = body_.spare.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>&) {
    if (valid_[p] == 0) return;
    std::array<T, D * D> f;
    for (int c = 0; c < D * D; ++c) f[c] = state.get(Field::material, c)[p];
    kernels::set_determinant<T, D>(f, body_.material.density * volume[p] / mass[p]);
    for (int c = 0; c < D * D; ++c) state.get(Field::material, c)[p] = f[c];
  });
}

template <class T, int D>
void RemeshedFields<T, D>::filter(int block) {
  const Layout<D>& layout = body_.spare.layout;
  const Block<D>& range = layout.blocks()[block];
  const auto apply = [&](const Buffer<T>& from, Buffer<T>& to) {
    kernels_.filter({layout.segments_of(range), range.segment_count,
                     static_cast<T>(filter_strength_), inside_, from.get(), to.get()});
  };
  for (const Field f : {Field::velocity, Field::material}) {
    for (std::size_t c = 0; c < body_.stage[1][f].size(); ++c) {
      apply(body_.stage[1][f][c], body_.stage[2][f][c]);
    }
  }
  apply(body_.stage[1][Field::mass][0], body_.stage[2][Field::volume][0]);
  for (std::size_t i = 0; i < filtered_memory_.size(); ++i) {
    apply(body_.stage[1][Field::memory_pressure][i], filtered_memory_[i]);
  }
}

template <class T, int D>
void RemeshedFields<T, D>::swap_in_filtered() {
  for (const Field f : {Field::velocity, Field::material}) {
    body_.stage[1][f].swap(body_.stage[2][f]);
  }
  body_.stage[1][Field::mass].swap(body_.stage[2][Field::volume]);
  body_.stage[1][Field::memory_pressure].swap(filtered_memory_);
}

// Slots beyond a period copy the fields and the validity one period away.
template <class T, int D>
void RemeshedFields<T, D>::copy_images(int block) {
  Population<T, D>& to = body_.spare;
  list_images(body_.lattice, to, block);
  for (const auto& [image, source] : to.images[block]) {
    to.kind[image] = Kind::image;
    for (const Declaration& f : state_fields) {
      for (Buffer<T>& component : body_.stage[1][f.field]) component[image] = component[source];
    }
  }
}

template class RemeshedFields<double, 2>;
template class RemeshedFields<double, 3>;
template class RemeshedFields<float, 2>;
template class RemeshedFields<float, 3>;

}  // namespace pliant::remeshed
