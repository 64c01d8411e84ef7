#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "engine/output/results/frame.hpp"
#include "tests/engine/undeformed/loads.hpp"

namespace pliant::test {

/// Walls that hold two sides of a block [0, 1] x [0, 1] (x [0, 1]).
inline std::string walls_of_corner(int dimension) {
  const std::string point = dimension == 2 ? "[0, 0]" : "[0, 0, 0]";
  return half_space("side", "kind = \"slip_wall\"", point,
                    dimension == 2 ? "[1, 0]" : "[1, 0, 0]") +
         half_space("floor", "kind = \"fixed\"", point, dimension == 2 ? "[0, 1]" : "[0, 0, 1]");
}

/// Expects that pieces of the surface of a frame join their neighbours: in 2D at places, in 3D
/// along edges, which both pass in opposite directions.
inline void expect_closed(const FrameSurface& surface) {
  using Place = std::array<double, 3>;
  const auto place = [&](std::size_t i) {
    const auto at = static_cast<std::size_t>(surface.vertex[i]) * 3;
    return Place{surface.position[at], surface.position[at + 1], surface.position[at + 2]};
  };
  const auto corners = static_cast<std::size_t>(surface.corners);
  std::map<std::pair<Place, Place>, int> balance;
  for (std::size_t i = 0; i < surface.vertex.size(); i += corners) {
    if (corners == 2) {
      ++balance[{place(i), {}}];
      --balance[{place(i + 1), {}}];
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const Place from = place(i + c), to = place(i + (c + 1) % 3);
      if (from < to) ++balance[{from, to}];
      if (to < from) --balance[{to, from}];
    }
  }
  EXPECT_GT(balance.size(), 8u);
  EXPECT_TRUE(std::ranges::all_of(balance, [](const auto& one) { return one.second == 0; }));
}

}  // namespace pliant::test
