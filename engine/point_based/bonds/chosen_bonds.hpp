#pragma once

#include <map>
#include <vector>

#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/bonds/node_operator.hpp"
#include "engine/point_based/surface/rectangles.hpp"

namespace pliant::point_based {

/// The bonds that nodes of a cloud have chosen, without corrections of their weights.
template <int D>
class ChosenBonds {
 public:
  /// Keeps references.
  ChosenBonds(const NodeCloud<D>& cloud, const BondChoice<D>& choice)
      : cloud_(cloud), choice_(choice) {}

  std::vector<double> weights(std::int64_t node) const { return weights_of(choice_, node); }
  std::int32_t neighbour(std::int64_t node, std::size_t bond) const {
    return choice_.candidates[node][bond].node;
  }
  const Point<D>& place(std::int64_t node) const { return cloud_.positions[node]; }

  NodeOperator<D> gradient(std::int64_t node) const {
    const std::vector<double> weights = this->weights(node);
    std::vector<Point<D>> bonds;
    bonds.reserve(weights.size());
    for (std::size_t k = 0; k < weights.size(); ++k) {
      bonds.push_back(difference<D>(place(neighbour(node, k)), place(node)));
    }
    return node_operator<D>(bonds, weights);
  }

 private:
  const NodeCloud<D>& cloud_;
  const BondChoice<D>& choice_;
};

/// A part of the area vector of a facet, and the node that bears it; -1: none.
template <int D>
struct BorneArea {
  std::int64_t node = -1;
  Point<D> area = {};
};

/// [node of the cloud] its share of the surface, outward [m^(D-1)]. A corner of a facet that is no
/// node moves by (TL.15); `bearing(corners, area)` is a part of a facet that does not move so.
template <class T, int D, class Bearing>
std::vector<Point<D>> surface_shares(const Body<T, D>& body, const ChosenBonds<D>& bonds,
                                     const Bearing& bearing) {
  std::vector<Point<D>> shares(body.particles);
  const auto add = [&shares](std::int64_t node, double weight, const Point<D>& area) {
    for (int a = 0; a < D; ++a) shares[node][a] += weight * area[a];
  };
  std::map<std::int64_t, NodeOperator<D>> known;
  for (std::size_t f = 0; f < body.surface.facet.size(); ++f) {
    const auto& facet = body.surface.facet[f];
    std::array<Point<D>, D> corner;
    for (int v = 0; v < D; ++v) corner[v] = body.surface.start[facet[v]];
    Point<D> area = undeformed::area_vector<D>(corner);
    if (const BorneArea<D> borne = bearing(corner, area); borne.node >= 0) {
      add(borne.node, 1, borne.area);
      area = difference<D>(area, borne.area);
    }
    const auto part = shares_of_corners<D>(apex_of_half(body.surface, f));
    for (int v = 0; v < D; ++v) {
      const std::int64_t i = body.number[body.surface.node[facet[v]]];
      const Point<D> from = difference<D>(corner[v], bonds.place(i));
      add(i, part[v], area);
      if (!known.contains(i)) known.emplace(i, bonds.gradient(i));
      const std::vector<Point<D>>& gradient = known.at(i).gradient;
      for (std::size_t k = 0; k < gradient.size(); ++k) {
        const double share = part[v] * dot<D>(gradient[k], from);
        add(bonds.neighbour(i, k), share, area);
        add(i, -share, area);
      }
    }
  }
  return shares;
}

}  // namespace pliant::point_based
