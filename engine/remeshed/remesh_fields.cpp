#include <algorithm>
#include <cmath>

#include "engine/body/initial_velocity.hpp"
#include "engine/geometry/distance_walk.hpp"
#include "engine/geometry/free_surface.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/remeshed/images.hpp"
#include "engine/remeshed/remesh.hpp"
#include "engine/remeshed/setup.hpp"
#include "kernels/set_determinant.hpp"

// How fields cross to the new lattice. Each new block gathers from all present blocks that come
// near into a tile of its own nodes, so that blocks share nothing and sums keep one order.
namespace pliant::remeshed {

template <class T, int D>
void Remeshing<T, D>::scatter(int block) {
  Tile& tile = tiles_[workers_.index()];
  lay_tile_out(block, tile);
  FieldStore<T, D>& state = body_.stage[0];
  MaterialFields material = {state.carried(), {}};
  for (int c = 0; c < material.count; ++c) material.field[c] = state.get(Field::material, c);
  fill_tile(tile, material);
  take_nodes(block, tile);
  const int terms = static_cast<int>(body_.prony.size());
  for (int first = 0; first < terms; first += kernels::material_components<D>) {
    material.count = std::min(terms - first, kernels::material_components<D>);
    for (int i = 0; i < material.count; ++i) {
      material.field[i] = state.get(Field::memory, first + i);
    }
    fill_tile(tile, material);
    take_memory(block, tile, first, material.count);
  }
}

// The box around a block has several times as many nodes: blocks begin and end amid the tiles of
// rows of the layout.
template <class T, int D>
void Remeshing<T, D>::lay_tile_out(int block, Tile& tile) const {
  const Layout<D>& layout = body_.spare.layout;
  const Block<D>& target = layout.blocks()[block];
  std::size_t rows = 1;
  for (int a = 0; a < D; ++a) {
    tile.lower[a] = target.lower[a];
    tile.extent[a] = target.upper[a] + 1 - tile.lower[a];
    if (a > 0) rows *= tile.extent[a];
  }
  tile.rows.assign(rows, {0, 0, 0});
  for (int s = 0; s < target.segment_count; ++s) {
    const kernels::Segment<D>& segment = layout.segments_of(target)[s];
    kernels::NodeRow& row = tile.row(segment.cell);
    const std::int32_t begin = segment.cell[0] - tile.lower[0];
    row.begin = row.begin == row.end ? begin : std::min(row.begin, begin);
    row.end = std::max(row.end, begin + segment.count);
  }
  tile.count = 0;
  for (kernels::NodeRow& row : tile.rows) {
    row.first = tile.count;
    tile.count += row.end - row.begin;
  }
}

template <class T, int D>
void Remeshing<T, D>::fill_tile(Tile& tile, const MaterialFields& material) {
  tile.width = kernels::node_width_for<D>(material.count);
  const std::size_t values = tile.count * tile.width;
  tile.nodes.grow(values, T(0));
  std::fill_n(tile.nodes.get(), values, T(0));
  for (std::size_t b = 0; b < bounds_.size(); ++b) {
    add_source(static_cast<int>(b), tile, material);
  }
}

// A periodic body reaches the tile through every whole period that brings it near.
template <class T, int D>
void Remeshing<T, D>::add_source(int block, Tile& tile, const MaterialFields& material) {
  const Cell<D>& lower = tile.lower;
  const Cell<D>& extent = tile.extent;
  const Bounds& source = bounds_[block];
  if (source.lower[0] > source.upper[0]) return;
  Cell<D> first, last;
  for (int a = 0; a < D; ++a) {
    const std::int32_t n = body_.lattice.period[a];
    // Bounds are cells to which particles are nearest: their nodes lie up to two cells away.
    const std::int32_t least = lower[a] - source.upper[a] - 2;
    const std::int32_t most = lower[a] + extent[a] + 1 - source.lower[a];
    if (n == 0) {
      if (least > 0 || most < 0) return;
      first[a] = last[a] = 0;
    } else {
      first[a] = static_cast<std::int32_t>(std::ceil(static_cast<double>(least) / n));
      last[a] = static_cast<std::int32_t>(std::floor(static_cast<double>(most) / n));
    }
  }
  const Layout<D>& layout = body_.population.layout;
  const Block<D>& from = layout.blocks()[block];
  FieldStore<T, D>& state = body_.stage[0];
  kernels::Scatter<T, D> work = {};
  work.segments = layout.segments_of(from);
  work.segment_count = from.segment_count;
  work.kind = body_.population.kind.get();
  work.inverse_spacing = static_cast<T>(1 / body_.lattice.spacing);
  work.carried_components = material.count;
  work.mass = state.get(Field::mass);
  work.level_set = state.get(Field::level_set);
  for (int a = 0; a < D; ++a) work.carried[a] = state.get(Field::carried, a);
  work.state = state.template evolving<const T>();
  work.state.material = material.field;
  work.nodes = tile.nodes.get();
  work.rows = tile.rows.data();
  work.lower = lower;
  work.extent = extent;
  Cell<D> period = first;
  while (true) {
    for (int a = 0; a < D; ++a) work.shift[a] = period[a] * body_.lattice.period[a];
    kernels_.scatter(work);
    int a = 0;
    while (a < D && ++period[a] > last[a]) {
      period[a] = first[a];
      ++a;
    }
    if (a == D) return;
  }
}

// (RP.23)-(RP.26)
template <class T, int D>
void Remeshing<T, D>::take_nodes(int block, Tile& tile) {
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
    // The filter needs images already, whatever the slots turn out to be.
    body_.spare.kind[p] = valid ? Kind::interior : Kind::vacant;
    const T per_mass = valid ? 1 / mass : T(0), per_volume = valid ? 1 / volume : T(0);
    for (int a = 0; a < D; ++a) {
      state.get(Field::displacement, a)[p] = 0;
      state.get(Field::velocity, a)[p] = node[Node::momentum + a] * per_mass;
      state.get(Field::carried, a)[p] = node[Node::carried + a] * per_volume;
    }
    for (int c = 0; c < state.carried(); ++c) {
      state.get(Field::material, c)[p] = node[Node::material + c] * per_volume;
    }
    state.get(Field::level_set)[p] =
        valid ? node[Node::level_set] / weight : T(LevelSet<T, D>::far * body_.lattice.spacing);
    state.get(Field::volume)[p] = valid && extensive_ ? volume : cell_volume;
    state.get(Field::mass)[p] = !valid       ? body_.material.density * cell_volume
                                : extensive_ ? mass
                                             : mass * per_volume * cell_volume;
  });
}

// (RP.23) for p_i, which a second filling has put in the place of F.
template <class T, int D>
void Remeshing<T, D>::take_memory(int block, Tile& tile, int first_term, int count) {
  using Node = kernels::NodeField<D>;
  const Layout<D>& layout = body_.spare.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    const T* node = tile.node(cell);
    for (int i = 0; i < count; ++i) {
      body_.stage[1].get(Field::memory, first_term + i)[p] =
          valid_[p] != 0 ? node[Node::material + i] / node[Node::volume] : T(0);
    }
  });
}

// (RP.46)
template <class T, int D>
void Remeshing<T, D>::match_volumes(int block) {
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
void Remeshing<T, D>::filter(int block) {
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
    apply(body_.stage[1][Field::memory][i], filtered_memory_[i]);
  }
}

template <class T, int D>
void Remeshing<T, D>::adopt_filtered() {
  for (const Field f : {Field::velocity, Field::material}) {
    body_.stage[1][f].swap(body_.stage[2][f]);
  }
  body_.stage[1][Field::mass].swap(body_.stage[2][Field::volume]);
  body_.stage[1][Field::memory].swap(filtered_memory_);
  borrow_arrays();
}

// Slots beyond a period repeat the fields and the validity one period away.
template <class T, int D>
void Remeshing<T, D>::copy_images(int block) {
  Population<T, D>& to = body_.spare;
  list_images(body_.lattice, to, block);
  for (const auto& [image, source] : to.images[block]) {
    to.kind[image] = Kind::image;
    valid_[image] = valid_[source];
    inside_[image] = inside_[source];
    for (const FieldDeclaration& f : fields) {
      for (Buffer<T>& component : body_.stage[1][f.field]) component[image] = component[source];
    }
  }
}

template <class T, int D>
void Remeshing<T, D>::place_initial(const Case& settings, const BodyCase& source) {
  const double h = body_.lattice.spacing;
  const double limit = LevelSet<T, D>::far * h;
  const std::vector<Shape> walls = attached_walls(settings);
  const Shape surface = free_surface(source.geometry, walls, D);
  const auto padded = [](const Point<D>& x) {
    Vector v = {};
    std::copy(x.begin(), x.end(), v.begin());
    return v;
  };
  const Box box = bounding_box(source.geometry);
  Cell<D> lower, upper;
  for (int a = 0; a < D; ++a) {
    // Along a period the body may have no ends.
    const bool repeats = body_.lattice.period[a] != 0;
    lower[a] = repeats ? 0 : body_.lattice.cell(a, box.lower[a]) - 1;
    upper[a] = repeats ? body_.lattice.period[a] - 1 : body_.lattice.cell(a, box.upper[a]) + 1;
  }
  occupancy_.reset(lower, upper, layout_reach);
  Cell<D> cell = lower;
  DistanceWalk inside(source.geometry, D, 0);
  while (true) {
    if (inside(padded(body_.lattice.node(cell))) < 0) occupancy_.mark(cell);
    int a = 0;
    while (a < D && ++cell[a] > upper[a]) {
      cell[a] = lower[a];
      ++a;
    }
    if (a == D) break;
  }
  occupancy_.dilate(layout_reach);
  prepare_spare();

  FieldStore<T, D>& state = body_.stage[1];
  const T volume = static_cast<T>(std::pow(h, D));
  const bool deforms = body_.material.model == kernels::Model::reduced_polynomial;
  T volume_ratio = 1;
  for (int a = 0; a < D; ++a) volume_ratio *= static_cast<T>(source.stretch[a]);
  has_surface_ = false;
  DistanceWalk distance(surface, D, limit);
  for (const Block<D>& block : body_.spare.layout.blocks()) {
    body_.spare.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& at) {
      const Vector x = padded(body_.lattice.node(body_.lattice.wrapped(at)));
      const double phi = distance(x);
      state.get(Field::level_set)[p] = static_cast<T>(std::clamp(phi, -limit, limit));
      has_surface_ = has_surface_ || phi > -limit;
      valid_[p] = phi < ghost_band * h ? T(1) : T(0);
      const Vector u = initial_velocity(source, x);
      for (int a = 0; a < D; ++a) state.get(Field::velocity, a)[p] = static_cast<T>(u[a]);
      state.get(Field::volume)[p] = volume;
      state.get(Field::mass)[p] = body_.material.density * volume / volume_ratio;
      for (int c = 0; c < state.carried(); ++c) {
        state.get(Field::material, c)[p] =
            deforms && c % (D + 1) == 0 ? static_cast<T>(source.stretch[c / (D + 1)]) : T(0);
      }
      for (Buffer<T>& pressure : state[Field::memory]) pressure[p] = 0;
    });
  }
}

template void Remeshing<double, 2>::scatter(int);
template void Remeshing<double, 2>::lay_tile_out(int, Tile&) const;
template void Remeshing<double, 2>::fill_tile(Tile&, const MaterialFields&);
template void Remeshing<double, 2>::add_source(int, Tile&, const MaterialFields&);
template void Remeshing<double, 2>::take_nodes(int, Tile&);
template void Remeshing<double, 2>::take_memory(int, Tile&, int, int);
template void Remeshing<double, 2>::match_volumes(int);
template void Remeshing<double, 2>::filter(int);
template void Remeshing<double, 2>::adopt_filtered();
template void Remeshing<double, 2>::copy_images(int);
template void Remeshing<double, 2>::place_initial(const Case&, const BodyCase&);
template void Remeshing<double, 3>::scatter(int);
template void Remeshing<double, 3>::lay_tile_out(int, Tile&) const;
template void Remeshing<double, 3>::fill_tile(Tile&, const MaterialFields&);
template void Remeshing<double, 3>::add_source(int, Tile&, const MaterialFields&);
template void Remeshing<double, 3>::take_nodes(int, Tile&);
template void Remeshing<double, 3>::take_memory(int, Tile&, int, int);
template void Remeshing<double, 3>::match_volumes(int);
template void Remeshing<double, 3>::filter(int);
template void Remeshing<double, 3>::adopt_filtered();
template void Remeshing<double, 3>::copy_images(int);
template void Remeshing<double, 3>::place_initial(const Case&, const BodyCase&);

}  // namespace pliant::remeshed
