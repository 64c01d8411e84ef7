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

/// Two surfaces that may touch, or one and a contact wall. Corners move with nodes; facets are
/// segments (2D) or triangles (3D) between them.
struct ExaminedContact {
  std::vector<std::string> names;             ///< one, where a body may meet itself
  std::vector<std::int64_t> corners, facets;  ///< [body]
  /// How deep a corner lies in the other body, or in the wall, at t = 0 [m]; 0 where none does.
  double penetration = 0;
  Vector deepest = {};  ///< where that corner is [m]

  std::string text() const;
};

/// What `pliant check` finds out about a case of a method with nodes.
struct Examined {
  std::vector<ExaminedBody> bodies;
  std::vector<ExaminedContact> contacts;
  double time_step = 0;    ///< [s]
  double stable_step = 0;  ///< the longest one that is stable at rest, by (PB.12) or (FE.6) [s]

  /// What there is to say of all bodies together, a line.
  std::string step_text() const;
};

/// Sets up a case of a method of nodes and looks at them; none for other methods. Throws InputError
/// as its set-up does.
std::optional<Examined> examine(const Case& a_case);

}  // namespace pliant
