#include "engine/point_based/cut_faces/body_simplices.hpp"

#include "engine/blocks/box_tree.hpp"

namespace pliant::point_based {

template <int D>
template <class T>
BodySimplices<D>::BodySimplices(const Body<T, D>& body, double spacing)
    : corners_(body.surface.start) {
  if (body.elements.empty()) {
    lattice_.emplace(body.source->geometry, spacing);
    // The facets of the body's surface are those of the lattice, in the same order.
    const auto facets = lattice_->facets();
    for (std::size_t f = 0; f < facets.size(); ++f) {
      for (int v = 0; v < D; ++v) corner_of_[facets[f][v].name] = body.surface.facet[f][v];
    }
    return;
  }
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const std::int32_t slot = body.surface.node[c];
    corner_of_[{slot, slot}] = static_cast<std::int32_t>(c);
  }
  for (const auto& element : body.elements) {
    Simplex& simplex = elements_.emplace_back();
    for (int v = 0; v <= D; ++v) {
      simplex[v] = {{element[v], element[v]}, body.start[element[v]]};
    }
  }
}

template <int D>
auto BodySimplices<D>::elements_near(const std::vector<Box<D>>& boxes) const
    -> std::vector<Simplex> {
  const BoxTree<D> tree(boxes);
  std::vector<Simplex> found;
  for (const Simplex& element : elements_) {
    Box<D> box;
    for (const Corner& corner : element) box.grow(corner.place);
    bool is_near = false;
    tree.for_each_near(box, 0, 0, [&is_near](std::size_t) { is_near = true; });
    if (is_near) found.push_back(element);
  }
  return found;
}

template <int D>
Simplices<D> BodySimplices<D>::near(const std::vector<Box<D>>& boxes) const {
  Simplices<D> found{corners_, {}};
  auto number_of = corner_of_;
  for (const Simplex& simplex : lattice_ ? lattice_->simplices_near(boxes) : elements_near(boxes)) {
    auto& numbers = found.simplices.emplace_back();
    for (int v = 0; v <= D; ++v) {
      const auto [at, is_new] =
          number_of.insert({simplex[v].name, static_cast<std::int32_t>(found.places.size())});
      if (is_new) found.places.push_back(simplex[v].place);
      numbers[v] = at->second;
    }
  }
  return found;
}

template class BodySimplices<2>;
template class BodySimplices<3>;
template BodySimplices<2>::BodySimplices(const Body<double, 2>&, double);
template BodySimplices<3>::BodySimplices(const Body<double, 3>&, double);
template BodySimplices<2>::BodySimplices(const Body<float, 2>&, double);
template BodySimplices<3>::BodySimplices(const Body<float, 3>&, double);

}  // namespace pliant::point_based
