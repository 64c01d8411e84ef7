#include "engine/point_based/observe/opened_surface.hpp"

#include "engine/geometry/padded.hpp"

namespace pliant::point_based {

template <int D>
template <class T>
OpenedSurface<D>::OpenedSurface(const Body<T, D>& body, double spacing, InsideTest<D> is_inside)
    : spacing_(spacing),
      size_(body.resolution),
      is_inside_(std::move(is_inside)),
      facets_(body.surface.facet),
      corners_(static_cast<std::int32_t>(body.surface.start.size())),
      simplices_(body, spacing),
      nodes_(body) {}

template <int D>
void OpenedSurface<D>::follow(std::span<const CutSurface<D>> cuts) {
  std::size_t count = 0;
  for (const CutSurface<D>& cut : cuts) count += cut.pieces().size();
  if (count == pieces_ && !first_share_.empty()) return;
  pieces_ = count;
  const CutPieces<D> pieces(cuts);
  const Simplices<D> body = simplices_.near(pieces.boxes(spacing_));
  surface_ = divide_surface<D>(body, corners_, facets_, pieces);
  // The fronts are built from the whole cuts, so that they do not depend on when updates happened.
  std::vector<CutFront<D>> fronts(cuts.size(), CutFront<D>(is_inside_, size_));
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    if (cuts[c].stations() > 0) fronts[c].update(cuts, c);
  }
  SideFit<D> fit(nodes_, body, pieces, fronts);
  first_share_ = {0};
  shares_.clear();
  for (const SurfaceVertex<D>& vertex : surface_.vertices) {
    fit.add(vertex, shares_);
    first_share_.push_back(shares_.size());
  }
}

template <int D>
template <class T>
void OpenedSurface<D>::add(const Body<T, D>& body, int owner, SurfaceVertices& vertices) const {
  const auto first = static_cast<std::int64_t>(vertices.owner.size());
  for (std::size_t v = 0; v < surface_.vertices.size(); ++v) {
    const Point<D> moved = undeformed::carried<T, D>(body.displacement, shares(v));
    const Point<D> velocity = undeformed::carried<T, D>(body.velocity, shares(v));
    Point<D> now = surface_.vertices[v].place;
    for (int a = 0; a < D; ++a) now[a] += moved[a];
    const Vector x = padded<D>(now);
    vertices.position.insert(vertices.position.end(), x.begin(), x.end());
    vertices.displacement.insert(vertices.displacement.end(), moved.begin(), moved.end());
    vertices.velocity.insert(vertices.velocity.end(), velocity.begin(), velocity.end());
    vertices.owner.push_back(owner);
  }
  for (const auto& facet : surface_.facets) {
    for (const std::int32_t vertex : facet) vertices.vertex.push_back(first + vertex);
  }
}

template class OpenedSurface<2>;
template class OpenedSurface<3>;
template OpenedSurface<2>::OpenedSurface(const Body<double, 2>&, double, InsideTest<2>);
template OpenedSurface<3>::OpenedSurface(const Body<double, 3>&, double, InsideTest<3>);
template OpenedSurface<2>::OpenedSurface(const Body<float, 2>&, double, InsideTest<2>);
template OpenedSurface<3>::OpenedSurface(const Body<float, 3>&, double, InsideTest<3>);
template void OpenedSurface<2>::add(const Body<double, 2>&, int, SurfaceVertices&) const;
template void OpenedSurface<3>::add(const Body<double, 3>&, int, SurfaceVertices&) const;
template void OpenedSurface<2>::add(const Body<float, 2>&, int, SurfaceVertices&) const;
template void OpenedSurface<3>::add(const Body<float, 3>&, int, SurfaceVertices&) const;

}  // namespace pliant::point_based
