#include "engine/undeformed/contact/tied_surfaces.hpp"

#include <cmath>
#include <utility>

#include "engine/blocks/box_tree.hpp"
#include "engine/undeformed/contact/facet_point.hpp"

namespace pliant::undeformed {

namespace {

constexpr double tied_reach = 0.5;  // of a corner from the other surface at t = 0 [spacing]

}  // namespace

template <class T, int D>
TiedSurfaces<T, D>::TiedSurfaces(MovingSurface<T, D>& first, MovingSurface<T, D>& second,
                                 int contact)
    : corners_(second.spacing() < first.spacing() ? second : first),
      facets_(second.spacing() < first.spacing() ? first : second),
      contact_(contact),
      sign_(&corners_ == &first ? 1 : -1) {
  for (MovingSurface<T, D>* surface : {&corners_, &facets_}) {
    const std::size_t patches = surface->patches().count();
    for (std::size_t p = 0; p < patches; ++p) surface->find_marked_places(p);
    for (std::size_t f = 0; f < surface->facets(); ++f) {
      surface->find_normal(static_cast<std::int32_t>(f));
    }
  }
  std::vector<Box<D>> boxes(facets_.facets());
  for (std::size_t f = 0; f < boxes.size(); ++f) {
    for (const Point<D>& x : facets_.places(static_cast<std::int32_t>(f))) boxes[f].grow(x);
  }
  const BoxTree<D> tree(std::move(boxes));
  const double reach = tied_reach * facets_.spacing();
  std::vector<std::int32_t> near;
  for (std::int32_t c = 0; c < corners_.corners(); ++c) {
    near.clear();
    const Box<D> point{corners_.place(c), corners_.place(c)};
    tree.for_each_near(point, reach * reach, 0,
                       [&](std::size_t f) { near.push_back(static_cast<std::int32_t>(f)); });
    tie(c, near);
  }
}

// Ties a corner to the nearest point of the facets that face one of those around it.
template <class T, int D>
void TiedSurfaces<T, D>::tie(std::int32_t corner, std::span<const std::int32_t> facets) {
  const Point<D>& x = corners_.place(corner);
  double nearest = tied_reach * facets_.spacing();
  Tie tie;
  tie.corner = corner;
  for (const std::int32_t f : facets) {
    const std::array<Point<D>, D> c = facets_.places(f);
    const std::array<double, D> weight = nearest_weights(c, x);
    const Point<D> way = way_from<D>(c, weight, x);
    const double distance = std::sqrt(dot<D>(way, way));
    if (distance >= nearest || !corners_.opposes(corner, facets_.facet_normal(f))) continue;
    nearest = distance;
    tie.facet = f;
    tie.weight = weight;
    tie.height = facets_.height(f, x);
  }
  if (tie.facet < 0) return;
  tie.first_share = shares_.size();
  facets_.append_shares(tie.facet, tie.weight, shares_);
  tie.end_share = shares_.size();
  tie.compliance =
      free_compliance(corners_, corners_.shares(corner)) + free_compliance(facets_, shares(tie));
  ties_.push_back(tie);
}

template <class T, int D>
void TiedSurfaces<T, D>::watch() {
  for (const Tie& tie : ties_) {
    corners_.watch(tie.corner);
    for (const std::int32_t corner : facets_.facet(tie.facet)) facets_.watch(corner);
  }
}

template <class T, int D>
void TiedSurfaces<T, D>::measure() {
  for (Tie& tie : ties_) {
    const Point<D>& n = facets_.facet_normal(tie.facet);
    tie.apart = way_from<D>(facets_.places(tie.facet), tie.weight, corners_.place(tie.corner));
    for (int a = 0; a < D; ++a) tie.apart[a] -= tie.height * n[a];
    tie.pulled = {};
  }
}

template <class T, int D>
void TiedSurfaces<T, D>::sweep() {
  for (Tie& tie : ties_) {
    const ContactMotion<D> corner = corners_.motion(corners_.shares(tie.corner));
    const ContactMotion<D> point = facets_.motion(shares(tie));
    Point<D> impulse, moved;
    for (int a = 0; a < D; ++a) {
      impulse[a] = -(corner.velocity[a] - point.velocity[a]) / tie.compliance;
      moved[a] = -(tie.apart[a] + corner.shift[a] - point.shift[a]) / tie.compliance;
      tie.pulled[a] += impulse[a];
    }
    push_point<D>(corners_, corners_.shares(tie.corner), impulse, moved);
    for (int a = 0; a < D; ++a) impulse[a] = -impulse[a], moved[a] = -moved[a];
    push_point<D>(facets_, shares(tie), impulse, moved);
  }
}

template <class T, int D>
Point<D> TiedSurfaces<T, D>::impulse() const {
  Point<D> sum = {};
  for (const Tie& tie : ties_) {
    for (int a = 0; a < D; ++a) sum[a] += sign_ * tie.pulled[a];
  }
  return sum;
}

template class TiedSurfaces<double, 2>;
template class TiedSurfaces<double, 3>;
template class TiedSurfaces<float, 2>;
template class TiedSurfaces<float, 3>;

}  // namespace pliant::undeformed
