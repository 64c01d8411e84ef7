#include "engine/point_based/cut_faces/cut_cells.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "engine/lattice/column.hpp"
#include "engine/point_based/cutting/subdivide.hpp"

namespace pliant::point_based {

namespace {

/// Halvings of each simplex. They give the volumes of parts of a unit square with 10 to 20
/// spacings, and of a unit cube with 8, within 1 %, on lattices and meshes.
constexpr int halvings_of_simplex = 6;

constexpr double equally_near = 1e-9;  // up to rounding

template <int D>
constexpr std::size_t nodes_searched = D == 2 ? 12 : 32;  // must include one on the same side

template <int D>
using CellSimplex = std::array<Point<D>, D + 1>;

template <int D>
double simplex_volume(const CellSimplex<D>& simplex) {
  Eigen::Matrix<double, D, D> edges;
  for (int v = 0; v < D; ++v) edges.col(v) = column<D>(simplex[v + 1]) - column<D>(simplex[0]);
  return edges.determinant() / (D == 2 ? 2 : 6);
}

template <int D>
Point<D> simplex_middle(const CellSimplex<D>& simplex) {
  Point<D> x = {};
  for (const Point<D>& corner : simplex) {
    for (int a = 0; a < D; ++a) x[a] += corner[a] / (D + 1);
  }
  return x;
}

/// Calls f(x) for the centres of 2^`halvings` parts of equal volume of a simplex.
template <int D, class F>
void for_each_part_middle(const CellSimplex<D>& simplex, int halvings, F&& f) {
  if (halvings == 0) return f(simplex_middle<D>(simplex));
  std::pair<int, int> longest;
  double most = 0;
  for (int i = 0; i <= D; ++i) {
    for (int j = 0; j < i; ++j) {
      const double square = (column<D>(simplex[i]) - column<D>(simplex[j])).squaredNorm();
      if (square <= most) continue;
      most = square;
      longest = {i, j};
    }
  }
  const auto [i, j] = longest;
  CellSimplex<D> first = simplex, second = simplex;
  first[i] = second[j] = between<D>(simplex[i], simplex[j], 0.5);
  for_each_part_middle<D>(first, halvings - 1, f);
  for_each_part_middle<D>(second, halvings - 1, f);
}

/// The node nearest to `x`, and the nearest one on the same side of all cuts if that is farther
/// away. A cut halfway between two nodes does not change their volumes.
template <int D>
std::optional<std::pair<std::int32_t, std::int32_t>> nodes_beyond(const NodePlaces<D>& nodes,
                                                                  const CutPieces<D>& pieces,
                                                                  const Point<D>& x) {
  const std::int32_t nearest = nodes.tree.nearest(x);
  if (!pieces.separate(nodes.start[nearest], x)) return {};
  const auto near = nodes.tree.nearest(x, nodes_searched<D>);
  for (const auto& [distance, node] : near) {
    if (pieces.separate(nodes.start[node], x)) continue;
    if (distance <= near.front().distance * (1 + equally_near)) return {};
    return {{nearest, node}};
  }
  return {};
}

}  // namespace

template <int D>
template <class T>
CutCells<D>::CutCells(const Body<T, D>& body, double spacing)
    : spacing_(spacing), simplices_(body, spacing), nodes_(body) {}

// A large node can be the nearest one to places that are more than a simplex away from the cut.
template <int D>
void CutCells<D>::follow(std::span<const CutSurface<D>> cuts) {
  std::size_t count = 0;
  for (const CutSurface<D>& cut : cuts) count += cut.pieces().size();
  if (count == pieces_) return;
  pieces_ = count;
  const double largest = *std::max_element(nodes_.size.begin(), nodes_.size.end());
  const double reach = std::max(0., largest - spacing_);
  const CutPieces<D> pieces(cuts);
  std::vector<Box<D>> boxes = pieces.boxes(spacing_);
  for (Box<D>& box : boxes) {
    for (int a = 0; a < D; ++a) {
      box.lower[a] -= reach;
      box.upper[a] += reach;
    }
  }
  std::map<std::pair<std::int32_t, std::int32_t>, double> volumes;
  const Simplices<D> near = simplices_.near(boxes);
  for (const auto& vertices : near.simplices) {
    CellSimplex<D> simplex;
    for (int v = 0; v <= D; ++v) simplex[v] = near.places[vertices[v]];
    const double part = simplex_volume<D>(simplex) / (1 << halvings_of_simplex);
    for_each_part_middle<D>(simplex, halvings_of_simplex, [&](const Point<D>& x) {
      if (const auto found = nodes_beyond<D>(nodes_, pieces, x)) volumes[*found] += part;
    });
  }
  beyond_.clear();
  for (const auto& [pair, volume] : volumes) {
    beyond_.push_back({nodes_.slot[pair.first], nodes_.slot[pair.second], volume});
  }
}

template class CutCells<2>;
template class CutCells<3>;
template CutCells<2>::CutCells(const Body<double, 2>&, double);
template CutCells<3>::CutCells(const Body<double, 3>&, double);
template CutCells<2>::CutCells(const Body<float, 2>&, double);
template CutCells<3>::CutCells(const Body<float, 3>&, double);

}  // namespace pliant::point_based
