#pragma once

#include <cmath>

#include "engine/point_based/cutting/cut_bonds.hpp"

namespace pliant::point_based::tests {

/// Nodes at the centres of the cells of a lattice, with `count` cells of size h along each side,
/// and the bonds between nodes less than 2.1 h apart.
template <int D>
struct LatticeBonds {
  std::vector<MaterialPoint<D>> positions;
  std::vector<double> sizes, volumes;
  BondRows bonds;

  LatticeBonds(const std::array<int, D>& count, double h) {
    std::array<int, D> index = {};
    while (true) {
      MaterialPoint<D> x;
      for (int a = 0; a < D; ++a) x[a] = h * (index[a] + 0.5);
      positions.push_back(x);
      int a = 0;
      while (a < D && ++index[a] == count[a]) index[a++] = 0;
      if (a == D) break;
    }
    sizes.assign(positions.size(), h);
    volumes.assign(positions.size(), std::pow(h, D));
    bonds.first.push_back(0);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      for (std::size_t j = 0; j < positions.size(); ++j) {
        double square = 0;
        for (int a = 0; a < D; ++a) square += std::pow(positions[i][a] - positions[j][a], 2);
        if (i != j && square < std::pow(2.1 * h, 2)) {
          bonds.neighbour.push_back(static_cast<std::int32_t>(j));
        }
      }
      bonds.first.push_back(static_cast<std::int64_t>(bonds.neighbour.size()));
    }
  }

  CutBonds<D> cut_by(CutRule rule, const MaterialPoint<D>& upper,
                     const std::vector<std::int32_t>& first_nodes = {0}) const {
    const auto is_inside = [upper](const MaterialPoint<D>& x) {
      for (int a = 0; a < D; ++a) {
        if (!(x[a] > 0 && x[a] < upper[a])) return false;
      }
      return true;
    };
    return CutBonds<D>(positions, sizes, bonds, rule, is_inside, first_nodes);
  }
};

/// Calls f(i, j, factor) for every bond.
template <int D, class F>
void for_each_bond(const CutBonds<D>& cut, F&& f) {
  const BondRows& bonds = cut.bonds();
  for (std::size_t i = 0; i + 1 < bonds.first.size(); ++i) {
    for (std::int64_t b = bonds.first[i]; b < bonds.first[i + 1]; ++b) {
      f(i, static_cast<std::size_t>(bonds.neighbour[b]), cut.factors()[b]);
    }
  }
}

}  // namespace pliant::point_based::tests
