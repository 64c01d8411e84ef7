#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// What set-up makes of one body of nodes.
struct ExaminedBody {
  std::string name;
  std::int64_t nodes = 0;
  double volume = 0;            ///< sum of those of the nodes [m^D]
  double enclosed_volume = 0;   ///< within the triangles (in 2D segments) of the surface [m^D]
  double condition = 0;         ///< largest condition number of A of (PB.3); 0: there is none
  Vector worst = {};            ///< where that is [m]
  std::int64_t degenerate = 0;  ///< nodes whose neighbours span a plane or a line only

  double volume_error() const { return volume / enclosed_volume - 1; }
  std::string text() const;
};

struct Examined {
  std::vector<ExaminedBody> bodies;
  double time_step = 0;  ///< [s]
};

/// Sets up a case of a method of nodes and looks at them; none for other methods. Throws InputError
/// as its set-up does.
std::optional<Examined> examine(const Case& a_case);

}  // namespace pliant
