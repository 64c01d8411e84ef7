#include "engine/remeshed/ghosts/reentrant_corners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/blocks/box.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/reentrant_corner.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/level_set/adjacent.hpp"

namespace pliant::remeshed {

namespace {

/// The facets that the free-surface nodes in the cells around a slot see, that of the slot first.
template <class T, int D>
class FacetsAround {
 public:
  FacetsAround(const Population<T, D>& population, const LevelSet<T, D>& level_set, double spacing)
      : population_(population), level_set_(level_set), spacing_(spacing) {}

  std::span<const Facet> find(const kernels::Segment<D>& segment, std::int64_t slot,
                              const Cell<D>& cell) {
    count_ = 0;
    if (!add(slot, cell, cell)) return {};
    for_each_adjacent<D>(segment, cell, [&](const Cell<D>& other, std::int64_t slots_to) {
      add(slot + slots_to, other, cell);
    });
    return {facets_.data(), count_};
  }

 private:
  bool add(std::int64_t slot, const Cell<D>& at, const Cell<D>& seen_from) {
    Point<D> offset;
    if (population_.kind[slot] != Kind::free_ghost || !level_set_.closest_point(slot, offset) ||
        norm<D>(offset) > farthest_node * spacing_) {
      return false;
    }
    Point<D> foot;
    for (int a = 0; a < D; ++a) foot[a] = at[a] - seen_from[a] + offset[a] / spacing_;
    const Facet facet{padded<D>(foot), padded<D>(level_set_.outward(at, offset))};
    // A row that does not exist has the slots of another.
    if (count_ > 0 && !are_alike(facet, facets_[0]) && population_.layout.slot(at) != slot) {
      return false;
    }
    facets_[count_++] = facet;
    return true;
  }

  const Population<T, D>& population_;
  const LevelSet<T, D>& level_set_;
  double spacing_;
  std::array<Facet, D == 2 ? 9 : 27> facets_;
  std::size_t count_ = 0;
};

}  // namespace

template <class T, int D>
void find_reentrant_corners(const Lattice<D>& lattice, const Population<T, D>& population,
                            const LevelSet<T, D>& level_set, int block,
                            std::vector<Point<D>>& corners) {
  corners.clear();
  FacetsAround<T, D> around(population, level_set, lattice.spacing);
  const Layout<D>& layout = population.layout;
  const Block<D>& range = layout.blocks()[block];
  for (const kernels::Segment<D>& segment :
       std::span(layout.segments_of(range), range.segment_count)) {
    Cell<D> cell = segment.cell;
    const std::int64_t end = segment.first + segment.count;
    for (std::int64_t slot = segment.first; slot < end; ++slot, ++cell[0]) {
      if (population.kind[slot] != Kind::free_ghost) continue;
      const auto faces = faces_of_corner(around.find(segment, slot, cell));
      if (!faces) continue;
      const Vector place = meeting_place(*faces);
      Point<D>& corner = corners.emplace_back(lattice.node(cell));
      for (int a = 0; a < D; ++a) corner[a] += lattice.spacing * place[a];
    }
  }
}

template <int D>
void ReentrantCorners<D>::collect(const std::vector<std::vector<Point<D>>>& blocks, double reach) {
  count_ = 0;
  reach_ = reach;
  Box<D> box;
  for (const std::vector<Point<D>>& corners : blocks) {
    for (const Point<D>& corner : corners) box.grow(corner);
    count_ += corners.size();
  }
  if (count_ == 0) return;
  cells_.cover(box.lower, box.upper, {}, reach, count_);
  cells_.sort(count_, [&](auto&& add) {
    for (const std::vector<Point<D>>& corners : blocks) {
      for (const Point<D>& corner : corners) add(Site<double, D>{corner, 0});
    }
  });
}

template <int D>
double ReentrantCorners<D>::distance(const Point<D>& x) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double nearest = infinity;
  if (count_ == 0) return nearest;
  cells_.any_near(x, [&](const Site<double, D>& corner, const Point<D>&) {
    nearest = std::min(nearest, norm<D>(difference<D>(x, corner.position)));
    return false;
  });
  return nearest <= reach_ ? nearest : infinity;
}

template class ReentrantCorners<2>;
template class ReentrantCorners<3>;
template void find_reentrant_corners<double, 2>(const Lattice<2>&, const Population<double, 2>&,
                                                const LevelSet<double, 2>&, int,
                                                std::vector<Point<2>>&);
template void find_reentrant_corners<double, 3>(const Lattice<3>&, const Population<double, 3>&,
                                                const LevelSet<double, 3>&, int,
                                                std::vector<Point<3>>&);
template void find_reentrant_corners<float, 2>(const Lattice<2>&, const Population<float, 2>&,
                                               const LevelSet<float, 2>&, int,
                                               std::vector<Point<2>>&);
template void find_reentrant_corners<float, 3>(const Lattice<3>&, const Population<float, 3>&,
                                               const LevelSet<float, 3>&, int,
                                               std::vector<Point<3>>&);

}  // namespace pliant::remeshed
