#include "engine/remeshed/level_set/projections.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace pliant::remeshed {

namespace {

// [cells]; the error of the distance is of second order in that of the closest point.
constexpr double shortest_step = 1e-4;
constexpr double flattest = 0.05;        // square of a gradient
constexpr double smallest_value = 1e-3;  // [h]

}  // namespace

template <class T, int D>
void Projections<T, D>::clear(const Cell<D>& nearby) {
  if constexpr (std::is_same_v<T, float>) origin_ = nearby;
  slot_.clear();
  for (int a = 0; a < D; ++a) {
    node_[a].clear();
    point_[a].clear();
  }
}

template <class T, int D>
void Projections<T, D>::add(std::int64_t slot, const Cell<D>& node, const Point<D>& start) {
  slot_.push_back(slot);
  for (int a = 0; a < D; ++a) {
    node_[a].push_back(static_cast<T>(node[a] - origin_[a]));
    point_[a].push_back(static_cast<T>(start[a] - origin_[a]));
  }
}

template <class T, int D>
Cell<D> Projections<T, D>::cell(std::size_t i) const {
  Cell<D> cell;
  for (int a = 0; a < D; ++a) cell[a] = origin_[a] + static_cast<std::int32_t>(node_[a][i]);
  return cell;
}

template <class T, int D>
void Projections<T, D>::run(const Lattice<D>& lattice, const Layout<D>& layout, const T* values,
                            int farthest_move, int iterations,
                            const kernels::RemeshedTable<T, D>& kernels) {
  if (slot_.empty()) return;
  const std::size_t pack = Layout<D>::pack, whole = (size() + pack - 1) / pack * pack;
  kernels::ClosestPoints<T, D> work = {};
  fill_box(lattice, layout, values, farthest_move);
  for (int a = 0; a < D; ++a) {
    node_[a].resize(whole, node_[a].back());
    point_[a].resize(whole, point_[a].back());
    work.node[a] = node_[a].data();
    work.point[a] = point_[a].data();
  }
  converged_.resize(whole);
  const double h = lattice.spacing;
  work.values = box_.data();
  work.lower = lower_;
  work.extent = extent_;
  work.count = static_cast<int>(size());
  work.iterations = iterations;
  work.flattest = static_cast<T>(flattest * h * h);
  work.shortest_step = static_cast<T>(shortest_step);
  work.smallest_value = static_cast<T>(smallest_value * h);
  work.converged = converged_.data();
  kernels.find_closest_points(work);
}

template <class T, int D>
void Projections<T, D>::fill_box(const Lattice<D>& lattice, const Layout<D>& layout,
                                 const T* values, int farthest_move) {
  std::size_t nodes = 1;
  for (int a = 0; a < D; ++a) {
    const auto [least, most] = std::minmax_element(point_[a].begin(), point_[a].end());
    lower_[a] = cell_below(*least) - farthest_move - 1;
    extent_[a] = cell_below(*most) + farthest_move + 3 - lower_[a];
    nodes *= extent_[a];
  }
  box_.assign(nodes, std::numeric_limits<T>::quiet_NaN());
  Cell<D> cell = lower_;
  for (T* row = box_.data(); row != box_.data() + nodes; row += extent_[0]) {
    fill_row(lattice, layout, values, cell, row);
    for (int a = 1; a < D && ++cell[a] == lower_[a] + extent_[a]; ++a) cell[a] = lower_[a];
  }
}

template <class T, int D>
void Projections<T, D>::fill_row(const Lattice<D>& lattice, const Layout<D>& layout,
                                 const T* values, const Cell<D>& first, T* row) const {
  Cell<D> cell;
  for (int a = 0; a < D; ++a) cell[a] = origin_[a] + first[a];
  const std::int32_t first_x = cell[0];
  for (int a = 1; a < D; ++a) cell[a] = lattice.wrapped(a, cell[a]);
  const auto copy = [&](T* to) {
    return [&cell, values, to](std::int32_t x, std::int64_t slot, std::int32_t n) {
      std::copy_n(values + slot, n, to + (x - cell[0]));
    };
  };
  if (lattice.period[0] == 0) return layout.for_each_stretch(cell, extent_[0], copy(row));
  for (int i = 0; i < extent_[0]; ++i) {
    cell[0] = lattice.wrapped(0, first_x + i);
    layout.for_each_stretch(cell, 1, copy(row + i));
  }
}

template class Projections<double, 2>;
template class Projections<double, 3>;
template class Projections<float, 2>;
template class Projections<float, 3>;

}  // namespace pliant::remeshed
