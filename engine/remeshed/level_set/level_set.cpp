#include "engine/remeshed/level_set/level_set.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "engine/lattice/corner_weights.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/level_set/adjacent.hpp"

namespace pliant::remeshed {

namespace {

/// The point nearest to a node in the plane through `foot`; `foot` itself if the normal is unclear.
template <int D>
Point<D> tangent_point(const Point<D>& node, const Point<D>& foot, const Point<D>& normal) {
  const double square = dot<D>(normal, normal);
  if (square < 0.25) return foot;
  const double along = dot<D>(difference<D>(node, foot), normal) / square;
  Point<D> x;
  for (int a = 0; a < D; ++a) x[a] = node[a] - along * normal[a];
  return x;
}

/// Takes the polished closest point if it is still near.
template <int D>
void take_if_near(const Point<D>& polished, Point<D>& foot) {
  const Point<D> moved = difference<D>(polished, foot);
  if (dot<D>(moved, moved) < 2) foot = polished;
}

}  // namespace

template <class T, int D>
void LevelSet<T, D>::prepare(const Lattice<D>& lattice, const Layout<D>& layout, T* phi) {
  lattice_ = &lattice;
  layout_ = &layout;
  phi_ = phi;
  for (auto& layer : layer_) {
    layer.grow(layout.slots(), 0);
    std::memset(layer.get(), 0, layout.slots());
  }
}

template <class T, int D>
bool LevelSet<T, D>::gradient(const Cell<D>& cell, Point<D>& g) const {
  for (int a = 0; a < D; ++a) {
    Cell<D> up = cell, down = cell;
    ++up[a];
    --down[a];
    const std::int64_t q = layout_->slot(lattice_->wrapped(up));
    const std::int64_t r = layout_->slot(lattice_->wrapped(down));
    if (q < 0 || r < 0) return false;
    g[a] = (extended_[q] - extended_[r]) / (2 * lattice_->spacing);
  }
  return dot<D>(g, g) > 0.05;
}

// Until closest points are computed, their memory holds phi before the first pass.
template <class T, int D>
void LevelSet<T, D>::advance(const Block<D>& block, int pass) {
  T* start = foot_[0];
  if (pass == 0) {
    layout_->for_each_slot(block, [&](std::int64_t p, const Cell<D>&) { start[p] = extended_[p]; });
  }
  T* const phi[] = {extended_, phi_};
  advance_to_distance<T, D>(*lattice_, *layout_, block, start, phi[pass % 2], phi[1 - pass % 2]);
}

// Marks the slots of the pack at `slot` that may border a marked one. If a neighbouring row has no
// slot, a mark of another row may be found, but none is missed.
template <class T, int D>
auto LevelSet<T, D>::borders_of_layer(const kernels::Segment<D>& segment, std::int64_t slot,
                                      int layer) const -> PackOfMarks {
  if (lattice_->is_periodic()) return std::bit_cast<PackOfMarks>(~std::uint64_t{0});
  const std::uint8_t* mark = layer_[layer % 2].get() + slot;
  std::uint64_t any = 0;
  for (int k = D == 3 ? -1 : 0; k <= (D == 3 ? 1 : 0); ++k) {
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        std::uint64_t marks;
        std::memcpy(&marks, mark + segment.neighbour_row[kernels::row_index<D>(j, k)] + i,
                    sizeof marks);
        any |= marks;
      }
    }
  }
  return std::bit_cast<PackOfMarks>(any);
}

template <class T, int D>
void LevelSet<T, D>::add_layer(const Block<D>& block, int layer,
                               const kernels::RemeshedTable<T, D>& kernels) {
  const std::uint8_t* before = layer_[layer % 2].get();
  std::uint8_t* after = layer_[(layer + 1) % 2].get();
  thread_local Border border;
  border.clear(block.lower);
  for (int s = block.first_segment; s < block.first_segment + block.segment_count; ++s) {
    const kernels::Segment<D>& segment = layout_->segments()[s];
    std::copy_n(before + segment.first, segment.count, after + segment.first);
    if (layer > last_layer_) continue;
    for (int offset = 0; offset < segment.count; offset += Layout<D>::pack) {
      const std::int64_t first = segment.first + offset;
      const PackOfMarks borders = borders_of_layer(segment, first, layer);
      if (borders == PackOfMarks{}) continue;
      Cell<D> cell = segment.cell;
      cell[0] += offset;
      for (int i = 0; i < Layout<D>::pack; ++i, ++cell[0]) {
        if (borders[i] == 0 || before[first + i] != 0) continue;
        find_nearest(segment, first + i, cell, layer, border);
      }
    }
  }
  polish(border, kernels);
  for (std::size_t i = 0; i < border.polished.size(); ++i) {
    const std::int64_t slot = border.polished.slot(i);
    const Point<D> offset = difference<D>(border.foot[i], border.polished.node(i));
    for (int a = 0; a < D; ++a) foot_[a][slot] = offset[a];
    after[slot] = static_cast<std::uint8_t>(layer);
    if (is_first_order_) continue;
    // Far from the surface, the sign from the remeshing is reliable.
    phi_[slot] = std::copysign(
        static_cast<T>(std::sqrt(dot<D>(offset, offset)) * lattice_->spacing), extended_[slot]);
  }
}

// The nearest of the closest points of marked neighbours.
template <class T, int D>
void LevelSet<T, D>::find_nearest(const kernels::Segment<D>& segment, std::int64_t slot,
                                  const Cell<D>& cell, int layer, Border& border) const {
  if (!lattice_->is_wrapped(cell)) return;
  const Point<D> node = as_point<D>(cell);
  double nearest = 1e300;
  Point<D> foot = {}, normal = {};
  const bool periodic = lattice_->is_periodic();
  const std::uint8_t* marks = layer_[layer % 2].get();
  for_each_adjacent<D>(segment, cell, [&](const Cell<D>& other, std::int64_t slots_to) {
    std::int64_t q = slot + slots_to;
    if (periodic) q = layout_->slot(lattice_->wrapped(other));
    if (q < 0 || marks[q] == 0) return;
    Point<D> candidate = as_point<D>(other), to_foot;
    for (int a = 0; a < D; ++a) {
      to_foot[a] = foot_[a][q];
      candidate[a] += to_foot[a];
    }
    const Point<D> offset = difference<D>(candidate, node);
    const double square = dot<D>(offset, offset);
    // The offset to a row that does not exist may lead anywhere; the mark then belongs to another
    // node.
    if (square >= nearest || (!periodic && layout_->slot(other) != q)) return;
    nearest = square;
    foot = candidate;
    normal = to_foot;
  });
  if (nearest == 1e300) return;
  border.polished.add(slot, cell, tangent_point<D>(node, foot, normal));
  border.foot.push_back(foot);
}

// If the surface is smooth, the tangent plane at a neighbour's closest point gives almost the
// closest point of the node. Otherwise that point itself may be a start.
template <class T, int D>
void LevelSet<T, D>::polish(Border& border, const kernels::RemeshedTable<T, D>& kernels) const {
  // Blocks read no farther than one cell beyond the closest points of the last layer.
  constexpr int farthest_move = 1, iterations = 6;
  border.polished.run(*lattice_, *layout_, extended_, farthest_move, iterations, kernels);
  for (std::size_t i = 0; i < border.polished.size(); ++i) {
    if (border.polished.has_converged(i)) {
      take_if_near<D>(border.polished.point(i), border.foot[i]);
    } else {
      border.failed.push_back(i);
      border.again.add(border.polished.slot(i), border.polished.cell(i), border.foot[i]);
    }
  }
  border.again.run(*lattice_, *layout_, extended_, farthest_move, iterations, kernels);
  for (std::size_t k = 0; k < border.failed.size(); ++k) {
    if (border.again.has_converged(k))
      take_if_near<D>(border.again.point(k), border.foot[border.failed[k]]);
  }
}

template <class T, int D>
void LevelSet<T, D>::finish(const Block<D>& block) {
  const T limit = static_cast<T>(far * lattice_->spacing);
  layout_->for_each_slot(block, [&](std::int64_t p, const Cell<D>&) {
    Point<D> offset;
    if (closest_point(p, offset)) {
      extended_[p] = std::copysign(static_cast<T>(std::sqrt(dot<D>(offset, offset))), phi_[p]);
    } else {
      extended_[p] = phi_[p] = phi_[p] < 0 ? -limit : limit;
    }
  });
}

template <class T, int D>
double LevelSet<T, D>::phi_at(const Point<D>& x) const {
  double phi = 0;
  return interpolate(phi_, x, phi) ? phi : far * lattice_->spacing;
}

template <class T, int D>
bool LevelSet<T, D>::interpolate(const T* values, const Point<D>& x, double& value) const {
  value = 0;
  return for_each_corner<D>(*lattice_, x, [&](const Cell<D>& cell, double weight) {
    const std::int64_t p = layout_->slot(lattice_->wrapped(cell));
    if (p >= 0) value += weight * values[p];
    return p >= 0;
  });
}

template <class T, int D>
bool LevelSet<T, D>::closest_point(std::int64_t slot, Point<D>& offset) const {
  if (layer_[(layers + 1) % 2][slot] == 0) return false;
  for (int a = 0; a < D; ++a) offset[a] = foot_[a][slot] * lattice_->spacing;
  return true;
}

template <class T, int D>
Point<D> LevelSet<T, D>::outward(const Cell<D>& cell, const Point<D>& offset) const {
  constexpr double on_surface = 1e-6;  // [h]
  Point<D> direction = {};
  for (int a = 0; a < D; ++a) direction[a] = -offset[a];
  if (norm<D>(offset) < on_surface * lattice_->spacing) gradient(cell, direction);
  const double length = norm<D>(direction);
  if (length > 0) {
    for (double& component : direction) component /= length;
  }
  return direction;
}

template class LevelSet<double, 2>;
template class LevelSet<double, 3>;
template class LevelSet<float, 2>;
template class LevelSet<float, 3>;

}  // namespace pliant::remeshed
