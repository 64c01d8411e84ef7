#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// The result of set-up for one body of nodes.
struct ExaminedBody {
  std::string name;
  std::int64_t nodes = 0;
  double volume = 0;            ///< sum of the nodes' volumes [m^D]
  double enclosed_volume = 0;   ///< inside the triangles (in 2D segments) of the surface [m^D]
  double condition = 0;         ///< largest condition number of A of (PB.3); 0: no matrix
  Vector worst = {};            ///< its place [m]
  std::int64_t degenerate = 0;  ///< nodes whose neighbours span only a plane or a line

  double volume_error() const { return volume / enclosed_volume - 1; }
  std::string text() const;
};

/// Two surfaces that may touch, or a surface and a contact wall. Corners move with nodes; facets
/// are segments (2D) or triangles (3D) between corners.
struct ExaminedContact {
  std::vector<std::string> names;             ///< only one if a body may touch itself
  std::vector<std::int64_t> corners, facets;  ///< [body]
  /// Depth of the deepest corner inside the other body or the wall at t = 0 [m]; 0 without one.
  double penetration = 0;
  Vector deepest = {};  ///< place of that corner [m]

  std::string text() const;
};

/// Results of `pliant check` for a case of a method with nodes.
struct Examined {
  std::vector<ExaminedBody> bodies;
  std::vector<ExaminedContact> contacts;
  double time_step = 0;    ///< [s]
  double stable_step = 0;  ///< longest stable step at rest, by (PB.12) or (FE.6) [s]

  /// One line about all bodies together.
  std::string step_text() const;
  /// What is wrong with the time step of the case; empty if it is stable.
  std::string stability_warning() const;
};

/// Sets up a case of a method with nodes and examines the result; none for other methods. Throws
/// InputError if set-up does.
std::optional<Examined> examine(const Case& a_case);

}  // namespace pliant
