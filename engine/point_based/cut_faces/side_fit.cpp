#include "engine/point_based/cut_faces/side_fit.hpp"

#include <algorithm>
#include <cmath>

#include "engine/lattice/column.hpp"
#include "engine/method/decompositions.hpp"

namespace pliant::point_based {

namespace {

template <int D>
constexpr std::size_t fitted_nodes = D == 2 ? 8 : 20;  // nodes in a fit, as in (PB.20)
constexpr double flat_fit =
    1e-3;  // ratio of singular values where nodes lie almost in a plane or on a line
constexpr int no_cut = -1;

template <class T, int D>
std::vector<std::int32_t> slots_with_nodes(const Body<T, D>& body) {
  std::vector<std::int32_t> slots;
  body.for_each_node([&](std::int64_t slot) { slots.push_back(static_cast<std::int32_t>(slot)); });
  return slots;
}

template <class T, int D>
std::vector<double> node_sizes(const Body<T, D>& body) {
  std::vector<double> sizes;
  body.for_each_node([&](std::int64_t slot) {
    sizes.push_back(std::pow(body.mass[slot] / body.material.density, 1. / D));
  });
  return sizes;
}

template <class T, int D>
std::vector<Point<D>> node_starts(const Body<T, D>& body) {
  std::vector<Point<D>> starts;
  body.for_each_node([&](std::int64_t slot) { starts.push_back(body.start[slot]); });
  return starts;
}

}  // namespace

template <int D>
template <class T>
NodePlaces<D>::NodePlaces(const Body<T, D>& body)
    : slot(slots_with_nodes(body)), size(node_sizes(body)), start(node_starts(body)), tree(start) {}

// A sliver between cuts may hold no node; it then moves with nodes near it.
template <int D>
std::vector<std::int32_t> SideFit<D>::nodes_near(const Point<D>& x, std::int32_t side,
                                                 std::int32_t but) const {
  const auto near = nodes_.tree.nearest(x, 5 * fitted_nodes<D> / 2);
  std::vector<std::int32_t> found;
  for (const auto& [distance, node] : near) {
    if (!pieces_.separate(nodes_.start[node], body_.places[side], but)) found.push_back(node);
  }
  for (std::size_t k = 0; k < near.size() && found.size() <= D; ++k) found.push_back(near[k].node);
  return found;
}

// The weights vanish beyond the farthest node. If the nodes lie in a plane or on a line, the fit
// has no slope normal to it.
template <int D>
void SideFit<D>::add_fit(const Point<D>& x, std::vector<std::int32_t> nodes, double part,
                         std::vector<undeformed::Share>& shares) const {
  using Vector = Eigen::Matrix<double, D + 1, 1>;
  const auto square = [&](std::int32_t node) {
    return (column<D>(nodes_.start[node]) - column<D>(x)).squaredNorm();
  };
  const std::size_t count = std::min(nodes.size(), fitted_nodes<D>);
  std::partial_sort(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(count), nodes.end(),
                    [&](std::int32_t a, std::int32_t b) {
                      return std::pair(square(a), a) < std::pair(square(b), b);
                    });
  const double farthest = square(nodes[count - 1]);
  std::array<Vector, fitted_nodes<D>> basis;
  Eigen::Matrix<double, D + 1, D + 1> moment = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  std::array<double, fitted_nodes<D>> weight;
  for (std::size_t k = 0; k < count; ++k) {
    basis[k] << 1, (column<D>(nodes_.start[nodes[k]]) - column<D>(x)) / std::sqrt(farthest);
    weight[k] = 1e-2 + 1 - square(nodes[k]) / farthest;
    moment += weight[k] * basis[k] * basis[k].transpose();
  }
  const Vector value = pseudo_inverse<D + 1>(moment, flat_fit).col(0);
  for (std::size_t k = 0; k < count; ++k) {
    shares.push_back({nodes_.slot[nodes[k]], part * weight[k] * basis[k].dot(value)});
  }
}

template <int D>
void SideFit<D>::add(const SurfaceVertex<D>& vertex, std::vector<undeformed::Share>& shares) {
  auto beside = beside_.find(vertex.side);
  if (beside == beside_.end()) {
    const Point<D>& x = body_.places[vertex.side];
    beside = beside_.insert({vertex.side, nodes_near(x, vertex.side, no_cut)}).first;
  }
  const double size = nodes_.size[beside->second.front()];
  double joined = 0;
  std::int32_t ending = no_cut;
  for (const std::int32_t cut : vertex.cuts) {
    const double share =
        share_before_front(fronts_[cut].distance(vertex.place, reach_of_front * size), size);
    if (share <= joined) continue;
    joined = share;
    ending = cut;
  }
  if (joined < 1) add_fit(vertex.place, beside->second, 1 - joined, shares);
  if (joined > 0) {
    add_fit(vertex.place, nodes_near(vertex.place, vertex.side, ending), joined, shares);
  }
}

template class SideFit<2>;
template class SideFit<3>;
template NodePlaces<2>::NodePlaces(const Body<double, 2>&);
template NodePlaces<3>::NodePlaces(const Body<double, 3>&);
template NodePlaces<2>::NodePlaces(const Body<float, 2>&);
template NodePlaces<3>::NodePlaces(const Body<float, 3>&);

}  // namespace pliant::point_based
