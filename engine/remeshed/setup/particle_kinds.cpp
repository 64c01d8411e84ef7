#include "engine/remeshed/setup/particle_kinds.hpp"

#include <algorithm>
#include <cmath>

namespace pliant::remeshed {

namespace {

// Nodes this far outside the body or behind a wall still belong to the body [h]. Where a row of
// nodes lies on an inclined surface, rounding would otherwise decide for each of them.
constexpr double on_surface = 1e-6;

template <class T, int D>
Kind kind_of(const Point<D>& x, T phi, double h, bool valid, Outside outside,
             const Boundaries<D>& boundaries) {
  if (phi >= ghost_band * h) return Kind::vacant;
  const auto [wall, d] = boundaries.nearest_wall(x);
  if (d < -ghost_band * h) return Kind::vacant;
  // (RP.97): a wall does not hold the body where the body does not reach it.
  const bool is_outside = phi >= on_surface * h;
  if (d < -on_surface * h && (!is_outside || boundaries.walls[wall].slips()))
    return Kind::wall_ghost;
  // What is beyond a contact wall is outside the body, whatever phi is.
  const double beyond = boundaries.nearest_contact(x).second;
  if (beyond < -ghost_band * h) return Kind::vacant;
  if (is_outside || beyond < 0) {
    return outside == Outside::ghosts ? Kind::free_ghost : Kind::vacant;
  }
  return valid ? Kind::interior : Kind::vacant;
}

// Sets finite values, which no interior particle reads.
template <class T, int D>
void reset_vacant_slot(FieldStore<T, D>& state, std::int64_t p,
                       const kernels::Material<T>& material, T volume) {
  for (int a = 0; a < D; ++a) {
    state.get(Field::velocity, a)[p] = 0;
    state.get(Field::displacement, a)[p] = 0;
  }
  state.get(Field::volume)[p] = volume;
  state.get(Field::mass)[p] = material.density * volume;
  const bool deforms = kernels::carries_deformation(material.model);
  for (int c = 0; c < state.material_components(); ++c) {
    state.get(Field::material, c)[p] = deforms && c % (D + 1) == 0 ? T(1) : T(0);
  }
  for (Buffer<T>& pressure : state[Field::memory_pressure]) pressure[p] = 0;
}

}  // namespace

template <class T, int D>
void find_pack_states(Population<T, D>& population, const kernels::Segment<D>& segment) {
  constexpr int pack = Layout<D>::pack;
  for (std::int64_t p = segment.first; p < segment.first + segment.count; p += pack) {
    int interior = 0, vacant = 0;
    for (int i = 0; i < pack; ++i) {
      interior += population.kind[p + i] == Kind::interior;
      vacant += population.kind[p + i] == Kind::vacant;
    }
    population.pack_state[p / pack] = vacant == pack     ? PackState::vacant
                                      : interior == 0    ? PackState::ghosts
                                      : interior == pack ? PackState::all
                                                         : PackState::some;
  }
}

template <class T, int D>
void prepare_slots(Body<T, D>& body, int block) {
  constexpr int pack = Layout<D>::pack;
  const Layout<D>& layout = body.population.layout;
  const Block<D>& range = layout.blocks()[block];
  for (int s = 0; s < range.segment_count; ++s) {
    const kernels::Segment<D>& segment = layout.segments_of(range)[s];
    const Kind* kind = body.population.kind.get();
    std::transform(kind + segment.first, kind + segment.first + segment.count,
                   body.interior.get() + segment.first,
                   [](Kind k) { return kernels::Mark(k == Kind::interior); });
    for (std::int64_t p = segment.first; p < segment.first + segment.count; p += pack) {
      if (holds_interior(body.population.pack_state[p / pack])) continue;
      const auto clear = [p](Buffer<T>& values) { std::fill_n(values.get() + p, pack, T(0)); };
      for (std::size_t buffer = 1; buffer < body.stage.size(); ++buffer) {
        for (Buffer<T>& component : body.stage[buffer][Field::drift]) clear(component);
        for (Buffer<T>& component : body.stage[buffer][Field::velocity]) clear(component);
      }
      for (int c = 0; c < kernels::symmetric_components<D>; ++c) clear(body.stress_component(1, c));
    }
  }
}

template <class T, int D>
std::int64_t classify(const Body<T, D>& body, Population<T, D>& population, FieldStore<T, D>& state,
                      int block, const Boundaries<D>& boundaries, const T* valid, Outside outside) {
  const double h = body.lattice.spacing;
  const T volume = static_cast<T>(std::pow(h, D));
  const T* phi = state.get(Field::level_set);
  std::int64_t particles = 0;
  const Block<D>& range = population.layout.blocks()[block];
  population.layout.for_each_slot(range, [&](std::int64_t p, const Cell<D>& cell) {
    const bool own = body.lattice.is_wrapped(cell), is_valid = valid[p] != 0;
    const Kind kind =
        own ? kind_of<T, D>(body.lattice.node(cell), phi[p], h, is_valid, outside, boundaries)
            : Kind::vacant;
    population.kind[p] = kind;
    for (int a = 0; a < D; ++a) state.get(Field::drift, a)[p] = 0;
    if (kind == Kind::vacant || !is_valid) reset_vacant_slot<T, D>(state, p, body.material, volume);
    particles += kind == Kind::interior;
  });
  for (int i = 0; i < range.segment_count; ++i) {
    find_pack_states(population, population.layout.segments()[range.first_segment + i]);
  }
  return particles;
}

template void prepare_slots<double, 2>(Body<double, 2>&, int);
template void prepare_slots<double, 3>(Body<double, 3>&, int);
template std::int64_t classify<double, 2>(const Body<double, 2>&, Population<double, 2>&,
                                          FieldStore<double, 2>&, int, const Boundaries<2>&,
                                          const double*, Outside);
template void find_pack_states<double, 2>(Population<double, 2>&, const kernels::Segment<2>&);
template std::int64_t classify<double, 3>(const Body<double, 3>&, Population<double, 3>&,
                                          FieldStore<double, 3>&, int, const Boundaries<3>&,
                                          const double*, Outside);
template void find_pack_states<double, 3>(Population<double, 3>&, const kernels::Segment<3>&);
template void prepare_slots<float, 2>(Body<float, 2>&, int);
template void prepare_slots<float, 3>(Body<float, 3>&, int);
template std::int64_t classify<float, 2>(const Body<float, 2>&, Population<float, 2>&,
                                         FieldStore<float, 2>&, int, const Boundaries<2>&,
                                         const float*, Outside);
template void find_pack_states<float, 2>(Population<float, 2>&, const kernels::Segment<2>&);
template std::int64_t classify<float, 3>(const Body<float, 3>&, Population<float, 3>&,
                                         FieldStore<float, 3>&, int, const Boundaries<3>&,
                                         const float*, Outside);
template void find_pack_states<float, 3>(Population<float, 3>&, const kernels::Segment<3>&);

}  // namespace pliant::remeshed
