#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {

using Offset = Cell<2>;

/// A particle or ghost.
struct Site {
  std::int64_t slot;
  Cell<2> cell;
};

inline std::vector<Site> sites_of(const Body& body) {
  std::vector<Site> sites;
  for (const Kind kind : {Kind::interior, Kind::free_ghost, Kind::wall_ghost}) {
    for_each(body.population, kind, [&](std::int64_t slot, const Cell<2>& cell) {
      sites.push_back({slot, cell});
    });
  }
  return sites;
}

/// Distance over h between two slots, one of them shifted by `offset` cells.
inline double distance(const Body& body, std::int64_t p, std::int64_t q, const Offset& offset) {
  double sum = 0;
  for (int a = 0; a < 2; ++a) {
    const auto* drift = body.stage[0].get(Field::drift, a);
    sum += std::pow(offset[a] + (drift[q] - drift[p]) / body.lattice.spacing, 2);
  }
  return std::sqrt(sum);
}

using Neighbours = std::set<std::pair<Offset, std::int64_t>>;

/// Everything within the radius of a particle, with images up to `periods` periods away.
inline Neighbours found_by_trying_all(const Body& body, const std::vector<Site>& sites,
                                      const Site& p, double radius, int periods) {
  Neighbours found;
  for (const Site& q : sites) {
    for (int kx = -periods; kx <= periods; ++kx) {
      for (int ky = -periods; ky <= periods; ++ky) {
        const Offset offset = {q.cell[0] - p.cell[0] + kx * body.lattice.period[0],
                               q.cell[1] - p.cell[1] + ky * body.lattice.period[1]};
        if (offset == Offset{}) continue;
        if (distance(body, p.slot, q.slot, offset) < radius) found.emplace(offset, q.slot);
      }
    }
  }
  return found;
}

/// The list of a particle, after a check of its order.
inline Neighbours listed(const Body& body, int block, std::int64_t p) {
  const kernels::NeighbourLists<2> lists = body.neighbours.lists(block);
  Neighbours found;
  constexpr int pack = Layout<2>::pack;
  std::pair<int, int> last = {-1000000, 0};
  for (int k = 0; k < lists.length[p / pack]; ++k) {
    const std::int64_t entry = lists.start[p / pack] + k * pack + p % pack;
    const Offset offset = {lists.offset[0][entry], lists.offset[1][entry]};
    if (lists.neighbour[entry] == p && offset == Offset{}) continue;
    EXPECT_LT(last, std::pair(offset[1], offset[0])) << "the order of the stencil";
    last = {offset[1], offset[0]};
    found.emplace(offset, lists.neighbour[entry]);
  }
  return found;
}

}  // namespace pliant::test
