#include "engine/point_based/nodes/lattice_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/nodes/faces.hpp"
#include "engine/point_based/nodes/node_cells.hpp"

namespace pliant::point_based {

namespace {

constexpr double closest_nodes = 0.5;     // [h] on the surface
constexpr double layer = 1.5;             // [h] depth of the nodes that move
constexpr int sweeps = 3;                 // of moves to centroids
constexpr double smallest_move = 1e-6;    // [h] smaller moves are not made
constexpr double smallest_volume = 0.02;  // of a cell; smaller nodes do not stay

template <int D>
double apart(const Point<D>& x, const Point<D>& y) {
  double square = 0;
  for (int a = 0; a < D; ++a) square += (x[a] - y[a]) * (x[a] - y[a]);
  return std::sqrt(square);
}

template <int D>
class NodePlacer {
 public:
  NodePlacer(const Shape& shape, double spacing)
      : spacing_(spacing), lattice_(shape, spacing), faces_(shape, spacing) {}

  NodeCloud<D> operator()(const PointChoice<D>& choice) {
    const std::vector<bool> is_chosen = choice(lattice_);
    for_each_cell<D>({}, lattice_.last(0), [&](const Cell<D>& point) {
      if (is_chosen[lattice_.index(point)]) place(point);
    });
    while (merge()) {
    }
    if (nodes_.empty()) return {};
    const bool fits = std::all_of(nodes_.begin(), nodes_.end(),
                                  [](const PlacedNode<D>& node) { return node.is_at_point; });
    for (int sweep = 0; sweep < sweeps && !fits; ++sweep) move_to_centroids();
    NodeCells<D> cells = cells_of(lattice_, nodes_);
    while (take_small_out(cells.volumes)) cells = cells_of(lattice_, nodes_);
    NodeCloud<D> cloud;
    for (const PlacedNode<D>& node : nodes_) cloud.positions.push_back(node.x);
    cloud.volumes = std::move(cells.volumes);
    cloud.is_regular = fits && std::ranges::all_of(is_chosen, [](bool chosen) { return chosen; });
    return cloud;
  }

 private:
  void place(const Cell<D>& point) {
    const double phi = lattice_.distance(point);
    const Point<D> x = lattice_.place(point);
    PlacedNode<D> node{x, lattice_.index(point), true, phi > -layer, {}};
    if (std::abs(phi) < layer) node.faces = faces_.near(x, lattice_.pitch());
    if (node.faces.empty() && phi > 0) return;
    node.x = faces_.onto(x, node.faces);
    node.is_at_point = node.x == x;
    nodes_.push_back(std::move(node));
  }

  /// Merges pairs of surface nodes that are too close, closest pair first. The node on more faces
  /// stays; in a tie it moves to the middle. Returns whether there were any.
  bool merge() {
    std::vector<Point<D>> place;
    std::vector<std::size_t> number;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].faces.empty()) continue;
      place.push_back(nodes_[i].x);
      number.push_back(i);
    }
    if (place.size() < 2) return false;
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    const NearestNodes<D> nearest(place);
    for (std::size_t i = 0; i < place.size(); ++i) {
      const auto next = nearest.nearest(place[i], 2)[1];
      const auto j = static_cast<std::size_t>(next.node);
      const double share = std::round(next.distance / (smallest_move * spacing_));
      if (next.distance >= (closest_nodes - smallest_move) * spacing_) continue;
      pairs.emplace_back(share, number[std::min(i, j)], number[std::max(i, j)]);
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<bool> is_gone(nodes_.size()), is_taken(nodes_.size());
    for (const auto& [share, i, j] : pairs) {
      if (is_taken[i] || is_taken[j]) continue;
      is_taken[i] = is_taken[j] = true;
      is_gone[join(i, j)] = true;
    }
    std::size_t to = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!is_gone[i]) std::swap(nodes_[to++], nodes_[i]);
    }
    nodes_.resize(to);
    return !pairs.empty();
  }

  /// Merges two nodes. Returns the one that is removed.
  std::size_t join(std::size_t i, std::size_t j) {
    if (nodes_[i].faces.size() != nodes_[j].faces.size()) {
      return nodes_[i].faces.size() < nodes_[j].faces.size() ? i : j;
    }
    if (nodes_[i].faces == nodes_[j].faces) {
      Point<D> middle;
      for (int a = 0; a < D; ++a) middle[a] = (nodes_[i].x[a] + nodes_[j].x[a]) / 2;
      move(nodes_[i], middle);
    }
    return j;
  }

  /// Moves a node to the point nearest to x on its faces, unless it would leave the surface there.
  void move(PlacedNode<D>& node, const Point<D>& x) {
    const Point<D> to = faces_.onto(x, node.faces);
    if (apart<D>(to, node.x) < smallest_move * spacing_) return;
    if (!node.faces.empty() && !faces_.hold(to)) return;
    node.x = to;
    node.is_at_point = false;
  }

  void move_to_centroids() {
    const NodeCells<D> cells = cells_of(lattice_, nodes_);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].may_move) move(nodes_[i], cells.centroids[i]);
    }
  }

  bool take_small_out(const std::vector<double>& volumes) {
    const double least = smallest_volume * lattice_.cell_volume();
    std::size_t to = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (volumes[i] >= least) std::swap(nodes_[to++], nodes_[i]);
    }
    const bool some = to < nodes_.size() && to > 0;
    if (some) nodes_.resize(to);
    return some;
  }

  double spacing_;
  BodyLattice<D> lattice_;
  Faces<D> faces_;
  std::vector<PlacedNode<D>> nodes_;
};

}  // namespace

template <int D>
NodeCloud<D> lattice_nodes(const Shape& shape, double spacing) {
  return lattice_nodes<D>(shape, spacing, [](const BodyLattice<D>& lattice) {
    return std::vector<bool>(lattice.points(), true);
  });
}

template <int D>
NodeCloud<D> lattice_nodes(const Shape& shape, double spacing, const PointChoice<D>& choice) {
  return NodePlacer<D>(shape, spacing)(choice);
}

template NodeCloud<2> lattice_nodes<2>(const Shape&, double);
template NodeCloud<3> lattice_nodes<3>(const Shape&, double);
template NodeCloud<2> lattice_nodes<2>(const Shape&, double, const PointChoice<2>&);
template NodeCloud<3> lattice_nodes<3>(const Shape&, double, const PointChoice<3>&);

}  // namespace pliant::point_based
