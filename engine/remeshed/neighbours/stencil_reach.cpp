#include "engine/remeshed/neighbours/stencil_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pliant::remeshed {

namespace {

/// The slots within `reach` + 1 of a slot of a segment that are not in the stencil.
template <int D>
class Ring {
 public:
  struct Place {
    std::int64_t away;  // slots
    Point<D> cells;
  };

  Ring(const kernels::Segment<D>& segment, int reach) {
    const int edge = reach + 1, depth = D == 3 ? edge : 0;
    for (int dz = -depth; dz <= depth; ++dz) {
      for (int dy = -edge; dy <= edge; ++dy) {
        for (int dx = -edge; dx <= edge; ++dx) {
          if (dx * dx + dy * dy + dz * dz < edge * edge) continue;
          Place& place = places_[count_++];
          place.away = segment.neighbour_row[kernels::row_index<D>(dy, dz)] + dx;
          place.cells[0] = dx;
          place.cells[1] = dy;
          if constexpr (D == 3) place.cells[2] = dz;
        }
      }
    }
  }

  const Place* begin() const { return places_.data(); }
  const Place* end() const { return places_.data() + count_; }

 private:
  std::array<Place, kernels::power(2 * kernels::row_reach + 1, D)> places_;
  int count_ = 0;
};

}  // namespace

template <class T, int D>
double closest_outside(const Body<T, D>& body, int block, int reach) {
  const Population<T, D>& population = body.population;
  const double per_spacing = 1 / body.lattice.spacing;
  std::array<const T*, D> drift;
  for (int a = 0; a < D; ++a) drift[a] = body.stage[0].get(Field::drift, a);
  double least = std::numeric_limits<double>::infinity();
  const Block<D>& range = population.layout.blocks()[block];
  for (int s = 0; s < range.segment_count; ++s) {
    const kernels::Segment<D>& segment = population.layout.segments_of(range)[s];
    const Ring<D> ring(segment, reach);
    for (std::int64_t p = segment.first; p < segment.first + segment.count; ++p) {
      if (population.kind[p] != Kind::interior) continue;
      for (const auto& place : ring) {
        const std::int64_t q = p + place.away;
        if (population.kind[q] == Kind::vacant) continue;
        double distance2 = 0;
        for (int a = 0; a < D; ++a) {
          const double d = place.cells[a] + (drift[a][q] - drift[a][p]) * per_spacing;
          distance2 += d * d;
        }
        least = std::min(least, distance2);
      }
    }
  }
  return std::sqrt(least);
}

template double closest_outside<double, 2>(const Body<double, 2>&, int, int);
template double closest_outside<double, 3>(const Body<double, 3>&, int, int);
template double closest_outside<float, 2>(const Body<float, 2>&, int, int);
template double closest_outside<float, 3>(const Body<float, 3>&, int, int);

}  // namespace pliant::remeshed
