#include "engine/remeshed/remeshing/scatter_tile.hpp"

#include <algorithm>

namespace pliant::remeshed {

// The box around a block has several times as many nodes as the block: blocks begin and end within
// tiles of rows of the layout.
template <class T, int D>
void ScatterTile<T, D>::lay_out(const Layout<D>& layout, int block) {
  const Block<D>& target = layout.blocks()[block];
  std::size_t rows = 1;
  for (int a = 0; a < D; ++a) {
    lower_[a] = target.lower[a];
    extent_[a] = target.upper[a] + 1 - lower_[a];
    if (a > 0) rows *= extent_[a];
  }
  rows_.assign(rows, {0, 0, 0});
  for (int s = 0; s < target.segment_count; ++s) {
    const kernels::Segment<D>& segment = layout.segments_of(target)[s];
    kernels::NodeRow& row = row_of(segment.cell);
    const std::int32_t begin = segment.cell[0] - lower_[0];
    row.begin = row.begin == row.end ? begin : std::min(row.begin, begin);
    row.end = std::max(row.end, begin + segment.count);
  }
  count_ = 0;
  for (kernels::NodeRow& row : rows_) {
    row.first = count_;
    count_ += row.end - row.begin;
  }
}

template <class T, int D>
void ScatterTile<T, D>::fill(Body<T, D>& body, const std::vector<CellBounds<D>>& bounds,
                             const TransportedFields<T, D>& carried,
                             const kernels::RemeshedTable<T, D>& kernels) {
  width_ = kernels::node_width_for<D>(carried.count);
  const std::size_t values = count_ * width_;
  nodes_.grow(values, T(0));
  std::fill_n(nodes_.get(), values, T(0));
  kernels::Scatter<T, D> work = scatter_of(body, carried);
  const Layout<D>& layout = body.population.layout;
  const Cell<D>& period = body.lattice.period;
  for (std::size_t b = 0; b < bounds.size(); ++b) {
    const Block<D>& from = layout.blocks()[b];
    work.segments = layout.segments_of(from);
    work.segment_count = from.segment_count;
    const CellBounds<D> periods = periods_to(bounds[b], period);
    for_each_cell<D>(periods.lower, periods.upper, [&](const Cell<D>& n) {
      for (int a = 0; a < D; ++a) work.shift[a] = n[a] * period[a];
      kernels.scatter(work);
    });
  }
}

template <class T, int D>
kernels::Scatter<T, D> ScatterTile<T, D>::scatter_of(Body<T, D>& body,
                                                     const TransportedFields<T, D>& carried) {
  FieldStore<T, D>& state = body.stage[0];
  kernels::Scatter<T, D> work = {};
  work.kind = body.population.kind.get();
  work.inverse_spacing = static_cast<T>(1 / body.lattice.spacing);
  work.material_component_count = carried.count;
  work.mass = state.get(Field::mass);
  work.level_set = state.get(Field::level_set);
  for (int a = 0; a < D; ++a) work.displacement[a] = state.get(Field::displacement, a);
  work.state = state.template evolving<const T>();
  work.state.material = carried.field;
  work.nodes = nodes_.get();
  work.rows = rows_.data();
  work.lower = lower_;
  work.extent = extent_;
  return work;
}

// The numbers of whole periods that bring particles near the tile: none if lower > upper; only 0 in
// directions that are not periodic.
template <class T, int D>
CellBounds<D> ScatterTile<T, D>::periods_to(const CellBounds<D>& source,
                                            const Cell<D>& period) const {
  CellBounds<D> none = {}, periods = {};
  none.lower[0] = 1;
  if (source.lower[0] > source.upper[0]) return none;
  for (int a = 0; a < D; ++a) {
    // Bounds are the nearest cells of particles, whose nodes are up to two cells away.
    const std::int32_t least = lower_[a] - source.upper[a] - 2;
    const std::int32_t most = lower_[a] + extent_[a] + 1 - source.lower[a];
    const double n = period[a];
    if (n == 0) {
      if (least > 0 || most < 0) return none;
      continue;
    }
    periods.lower[a] = cell_above(least / n);
    periods.upper[a] = cell_below(most / n);
  }
  return periods;
}

template class ScatterTile<double, 2>;
template class ScatterTile<double, 3>;
template class ScatterTile<float, 2>;
template class ScatterTile<float, 3>;

}  // namespace pliant::remeshed
