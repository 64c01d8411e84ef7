#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {

/// Loads the meshes of bodies and boundaries that are not loaded yet. Throws MeshError.
void load_meshes(Case& a_case);

/// A box around all bodies at t = 0 [m].
Box<3> box_of_bodies(const Case& a_case);

/// Whether a boundary is of this kind.
bool has_boundary(const Case& a_case, BoundaryCase::Kind kind);
/// Whether it has walls that hold bodies, at rest or moving.
bool has_no_slip_walls(const Case& a_case);

/// Whether bodies are tied that walls or loads act on, so that they hardly turn.
bool has_supported_ties(const Case& a_case);

/// Whether a [[contact]] names both bodies, in either order.
bool have_contact(const Case& a_case, std::array<int, 2> bodies);

/// Parts of a case without effect at their place at t = 0: walls that touch no body, loads whose
/// regions contain no surface, blades that miss their body, bodies that touch without a contact.
/// One sentence for each, with what to do. Walls and loads less than about a spacing from a body
/// count as touching it.
std::vector<std::string> placement_warnings(const Case& a_case);

}  // namespace pliant
