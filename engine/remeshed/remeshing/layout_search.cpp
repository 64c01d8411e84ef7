#include "engine/remeshed/remeshing/layout_search.hpp"

#include <algorithm>
#include <limits>

#include "engine/geometry/distance_walk.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant::remeshed {

namespace {

// Small bodies are divided among threads as long as a block is worth a task; large ones into blocks
// that fit into a second-level cache. The number is rounded to four leading bits, so that it, and
// with it the step graph, stays the same until a body has grown or shrunk by some percent.
int block_count(std::int64_t slots) {
  constexpr std::int64_t smallest_block = 512, largest_block = 3072, blocks_of_small_bodies = 12;
  const std::int64_t count = std::max({std::min(slots / smallest_block, blocks_of_small_bodies),
                                       slots / largest_block, std::int64_t{1}});
  std::int64_t unit = 1;
  while (count / unit >= 16) unit *= 2;
  return static_cast<int>(count / unit * unit);
}

// Packs in the map of a body's box: half a gigabyte for the map and its copy. An intact body needs
// a hundredth of it; otherwise its slots would not fit into memory either.
constexpr double largest_map = 1 << 28;
constexpr double farthest_drift = 1e8;  // [cells]; an integer is limited to 2e9

/// The cell whose node is nearest to a particle.
template <class T, int D>
class NearestCell {
 public:
  explicit NearestCell(const Body<T, D>& body)
      : inverse_spacing_(static_cast<T>(1 / body.lattice.spacing)) {
    for (int a = 0; a < D; ++a) drift_[a] = body.stage[0].get(Field::drift, a);
  }
  Cell<D> operator()(std::int64_t slot, Cell<D> cell) const {
    for (int a = 0; a < D; ++a) {
      const double cells = drift_[a][slot] * inverse_spacing_;
      cell[a] += nearest_cell(std::clamp(cells, -farthest_drift, farthest_drift));
    }
    return cell;
  }

 private:
  T inverse_spacing_;
  std::array<const T*, D> drift_;
};

}  // namespace

template <class T, int D>
void LayoutSearch<T, D>::find_bounds(int block) {
  constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
  CellBounds<D> found;
  found.lower.fill(none);
  found.upper.fill(-none);
  const Population<T, D>& from = body_.population;
  const NearestCell<T, D> nearest(body_);
  from.layout.for_each_slot(from.layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    if (from.kind[p] == Kind::vacant || from.kind[p] == Kind::image) return;
    const Cell<D> at = nearest(p, cell);
    for (int a = 0; a < D; ++a) {
      found.lower[a] = std::min(found.lower[a], at[a]);
      found.upper[a] = std::max(found.upper[a], at[a]);
    }
  });
  bounds_[block] = found;
}

template <class T, int D>
bool LayoutSearch<T, D>::mark_particles() {
  CellBounds<D> all = bounds_[0];
  for (const CellBounds<D>& of_block : bounds_) {
    for (int a = 0; a < D; ++a) {
      all.lower[a] = std::min(all.lower[a], of_block.lower[a]);
      all.upper[a] = std::max(all.upper[a], of_block.upper[a]);
    }
  }
  for (int a = 0; a < D; ++a) {
    if (body_.lattice.period[a] == 0) continue;
    all.lower[a] = 0;
    all.upper[a] = body_.lattice.period[a] - 1;
  }
  double packs = 1.0 / Layout<D>::pack;
  for (int a = 0; a < D; ++a) packs *= 1.0 + all.upper[a] - all.lower[a] + 2 * reach_;
  if (packs > largest_map) return false;
  occupancy_.reset(all.lower, all.upper, reach_);
  const Population<T, D>& from = body_.population;
  const NearestCell<T, D> nearest(body_);
  for (const Block<D>& block : from.layout.blocks()) {
    from.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (from.kind[p] != Kind::interior) return;
      mark_images(body_.lattice.wrapped(nearest(p, cell)));
    });
  }
  occupancy_.dilate(reach_);
  return true;
}

template <class T, int D>
void LayoutSearch<T, D>::mark_geometry() {
  const Lattice<D>& lattice = body_.lattice;
  const Shape& geometry = body_.source->geometry;
  const Box<3> box = bounding_box(geometry);
  Cell<D> lower, upper;
  for (int a = 0; a < D; ++a) {
    // In a periodic direction the body may have no ends.
    const bool repeats = lattice.period[a] != 0;
    lower[a] = repeats ? 0 : lattice.cell(a, box.lower[a]) - 1;
    upper[a] = repeats ? lattice.period[a] - 1 : lattice.cell(a, box.upper[a]) + 1;
  }
  occupancy_.reset(lower, upper, reach_);
  DistanceWalk inside(geometry, D, 0);
  for_each_cell<D>(lower, upper, [&](const Cell<D>& cell) {
    if (inside(padded<D>(lattice.node(cell))) < 0) mark_images(cell);
  });
  occupancy_.dilate(reach_);
}

template <class T, int D>
void LayoutSearch<T, D>::mark_images(const Cell<D>& cell) {
  const Cell<D>& period = body_.lattice.period;
  Cell<D> first = {}, last = {};
  for (int a = 0; a < D; ++a) {
    const double n = period[a];
    if (n == 0) continue;
    first[a] = cell_above((-reach_ - cell[a]) / n);
    last[a] = cell_below((period[a] - 1 + reach_ - cell[a]) / n);
  }
  for_each_cell<D>(first, last, [&](const Cell<D>& turns) {
    Cell<D> image = cell;
    for (int a = 0; a < D; ++a) image[a] += turns[a] * period[a];
    occupancy_.mark(image);
  });
}

template <class T, int D>
void LayoutSearch<T, D>::build(Layout<D>& layout) const {
  layout.build(occupancy_, body_.lattice.period, block_count(occupancy_.slots()), block_reach);
}

template class LayoutSearch<double, 2>;
template class LayoutSearch<double, 3>;
template class LayoutSearch<float, 2>;
template class LayoutSearch<float, 3>;

}  // namespace pliant::remeshed
