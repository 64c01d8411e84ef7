#include "engine/point_based/nodes/node_cells.hpp"

#include <algorithm>
#include <limits>

#include "engine/point_based/bonds/nearest_nodes.hpp"

namespace pliant::point_based {

namespace {

// How many nodes around the centre of a lattice cell may be nearest to one of its points.
constexpr std::size_t nodes_of_lattice_cell(int dimension) { return dimension == 2 ? 12 : 32; }
constexpr double equally_near = 1e-9;  // relative to the squared pitch
constexpr double moved_layer = 1.5;    // [h] depth of the nodes that may have moved

template <int D>
class CellFinder {
 public:
  CellFinder(const BodyLattice<D>& lattice, const std::vector<PlacedNode<D>>& nodes)
      : lattice_(lattice), node_at_(lattice.points(), -1) {
    for (const PlacedNode<D>& node : nodes) {
      if (node.is_at_point) node_at_[node.point] = static_cast<std::int32_t>(position_.size());
      position_.push_back(node.x);
    }
    cells_.volumes.assign(nodes.size(), 0);
    cells_.centroids.assign(nodes.size(), {});
    tolerance_ = equally_near * lattice.pitch()[0] * lattice.pitch()[0];
  }

  NodeCells<D> operator()() {
    const NearestNodes<D> nearest(position_);
    for_each_cell<D>({}, lattice_.last(1), [&](const Cell<D>& cell) {
      const auto filling = lattice_.filling(cell);
      if (filling == BodyLattice<D>::Filling::none) return;
      if (filling == BodyLattice<D>::Filling::all && give_to_corners(cell)) return;
      if (is_deep(cell)) {
        share_out_parts(cell, nearest);
      } else {
        distribute_loads(cell, nearest);
      }
    });
    for (std::size_t i = 0; i < position_.size(); ++i) {
      const double volume = cells_.volumes[i];
      for (int a = 0; a < D; ++a) {
        cells_.centroids[i][a] =
            position_[i][a] + (volume > 0 ? cells_.centroids[i][a] / volume : 0);
      }
    }
    return std::move(cells_);
  }

 private:
  /// Adds a volume with its centre at x; first moments are about the node.
  void add(std::int32_t node, double volume, const Point<D>& x) {
    cells_.volumes[node] += volume;
    for (int a = 0; a < D; ++a) {
      cells_.centroids[node][a] += volume * (x[a] - position_[node][a]);
    }
  }

  /// If no corner of the cell has moved, gives each corner the part nearest to it.
  bool give_to_corners(const Cell<D>& cell) {
    constexpr int corners = BodyLattice<D>::corners;
    for (int c = 0; c < corners; ++c) {
      if (node_at_[lattice_.corner(cell, c)] < 0) return false;
    }
    const double part = lattice_.cell_volume() / corners;
    for (int c = 0; c < corners; ++c) {
      const std::int32_t node = node_at_[lattice_.corner(cell, c)];
      Point<D> x = position_[node];
      for (int a = 0; a < D; ++a) x[a] += (c >> a & 1 ? -0.25 : 0.25) * lattice_.pitch()[a];
      add(node, part, x);
    }
    return true;
  }

  bool is_deep(const Cell<D>& cell) const {
    for (int c = 0; c < BodyLattice<D>::corners; ++c) {
      if (lattice_.distance_at(lattice_.corner(cell, c)) > -moved_layer) return false;
    }
    return true;
  }

  std::vector<typename NearestNodes<D>::Found> nodes_around(const Cell<D>& cell,
                                                            const NearestNodes<D>& nearest) const {
    Point<D> middle = lattice_.place(cell);
    for (int a = 0; a < D; ++a) middle[a] += lattice_.pitch()[a] / 2;
    return nearest.nearest(middle, nodes_of_lattice_cell(D));
  }

  void distribute_loads(const Cell<D>& cell, const NearestNodes<D>& nearest) {
    const auto around = nodes_around(cell, nearest);
    const std::vector<double> filled = lattice_.filled(cell);
    const double whole = lattice_.cell_volume() / static_cast<double>(filled.size());
    for (std::size_t k = 0; k < filled.size(); ++k) {
      if (filled[k] == 0) continue;
      give_to_nearest(around, filled[k] * whole, lattice_.middle(cell, static_cast<int>(k)));
    }
  }

  /// Where some of its corners are no nodes, and none has moved: planes halfway between nodes
  /// hardly divide the parts next to its corners.
  void share_out_parts(const Cell<D>& cell, const NearestNodes<D>& nearest) {
    constexpr int corners = BodyLattice<D>::corners;
    const auto around = nodes_around(cell, nearest);
    for (int c = 0; c < corners; ++c) {
      Point<D> x = lattice_.place(cell);
      for (int a = 0; a < D; ++a) x[a] += (c >> a & 1 ? 0.75 : 0.25) * lattice_.pitch()[a];
      give_to_nearest(around, lattice_.cell_volume() / corners, x);
    }
  }

  void give_to_nearest(const std::vector<typename NearestNodes<D>::Found>& around, double volume,
                       const Point<D>& x) {
    double least = std::numeric_limits<double>::infinity();
    takers_.clear();
    for (const auto& found : around) {
      double square = 0;
      for (int a = 0; a < D; ++a) {
        const double apart = x[a] - position_[found.node][a];
        square += apart * apart;
      }
      if (square > least + tolerance_) continue;
      if (square < least - tolerance_) takers_.clear();
      least = std::min(least, square);
      takers_.push_back(found.node);
    }
    const double share = volume / static_cast<double>(takers_.size());
    for (const std::int32_t node : takers_) add(node, share, x);
  }

  const BodyLattice<D>& lattice_;
  std::vector<std::int32_t> node_at_;  ///< [lattice point] node that has not moved, or -1
  std::vector<Point<D>> position_;
  double tolerance_;
  std::vector<std::int32_t> takers_;
  NodeCells<D> cells_;
};

}  // namespace

template <int D>
NodeCells<D> cells_of(const BodyLattice<D>& lattice, const std::vector<PlacedNode<D>>& nodes) {
  return CellFinder<D>(lattice, nodes)();
}

template NodeCells<2> cells_of(const BodyLattice<2>&, const std::vector<PlacedNode<2>>&);
template NodeCells<3> cells_of(const BodyLattice<3>&, const std::vector<PlacedNode<3>>&);

}  // namespace pliant::point_based
