#include "engine/remeshed/setup/images.hpp"

namespace pliant::remeshed {

template <class T, int D>
void list_images(const Lattice<D>& lattice, Population<T, D>& population, int block) {
  auto& images = population.images[block];
  images.clear();
  if (!lattice.is_periodic()) return;
  const Layout<D>& layout = population.layout;
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    if (lattice.is_wrapped(cell)) return;
    const std::int64_t q = layout.slot(lattice.wrapped(cell));
    if (q >= 0 && population.kind[q] != Kind::vacant) {
      images.emplace_back(static_cast<std::int32_t>(p), static_cast<std::int32_t>(q));
    }
  });
}

template <class T, int D>
void copy_image_drift(Body<T, D>& body, int block, int stage) {
  for (auto& component : body.stage[drift_buffer_of(stage)][Field::drift]) {
    for (const auto& [image, source] : body.population.images[block]) {
      component[image] = component[source];
    }
  }
}

template <class T, int D>
void copy_images(Body<T, D>& body, int block, int stage, bool with_volume) {
  const auto& images = body.population.images[block];
  FieldStore<T, D>& state = body.stage[buffer_of(stage)];
  for (auto& component : state[Field::velocity]) {
    for (const auto& [image, source] : images) component[image] = component[source];
  }
  if (with_volume) {
    T* volume = state.get(Field::volume);
    for (const auto& [image, source] : images) volume[image] = volume[source];
  }
  for (T* component : body.stress_view(stage % 2)) {
    for (const auto& [image, source] : images) component[image] = component[source];
  }
}

template void list_images<double, 2>(const Lattice<2>&, Population<double, 2>&, int);
template void copy_image_drift<double, 2>(Body<double, 2>&, int, int);
template void copy_images<double, 2>(Body<double, 2>&, int, int, bool);
template void list_images<double, 3>(const Lattice<3>&, Population<double, 3>&, int);
template void copy_image_drift<double, 3>(Body<double, 3>&, int, int);
template void copy_images<double, 3>(Body<double, 3>&, int, int, bool);
template void list_images<float, 2>(const Lattice<2>&, Population<float, 2>&, int);
template void copy_image_drift<float, 2>(Body<float, 2>&, int, int);
template void copy_images<float, 2>(Body<float, 2>&, int, int, bool);
template void list_images<float, 3>(const Lattice<3>&, Population<float, 3>&, int);
template void copy_image_drift<float, 3>(Body<float, 3>&, int, int);
template void copy_images<float, 3>(Body<float, 3>&, int, int, bool);

}  // namespace pliant::remeshed
