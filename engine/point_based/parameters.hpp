#pragma once

#include <optional>

#include "engine/case/case.hpp"
#include "engine/case/vocabulary/method_keys.hpp"
#include "engine/case/vocabulary/word.hpp"
#include "engine/point_based/cutting/cut_bonds.hpp"

namespace pliant::point_based {

/// Placement of nodes, unless they come from a mesh of tetrahedra.
enum class NodePlacement { lattice, octree };
/// How the gradient of a node is computed.
enum class NodeGradient { moving_least_squares, patch_exact };
/// When the forces of a step act: in its middle or at its start, (PB.10).
enum class Integrator { leapfrog, kick_drift };

/// The table [point_based] of a case.
struct Parameters {
  NodePlacement nodes = NodePlacement::lattice;
  double coarsest_spacing = 0;  ///< of an octree [m]; 0: four times the spacing
  CutRule cut_rule = CutRule::transparency;
  std::optional<double> cut_contact;  ///< coefficient of friction of cut faces; none: no contact
  NodeGradient gradient = NodeGradient::moving_least_squares;
  int neighbours = 0;                   ///< of each node; 0: `neighbour_count`
  std::optional<double> stabilisation;  ///< alpha of (PB.5); none: by the placement of the nodes
  Integrator integrator = Integrator::leapfrog;
  std::optional<double> damping = 0.;  ///< (PB.10) [1/s]; none: adaptive, (PB.65)
  double stiffness_damping = 0;        ///< beta of (PB.9) [s]
};

inline const Parameters& parameters_of(const Case& settings) {
  return settings.parameters.as<Parameters>();
}

/// Whether forces act in the middle of a step, so that velocities belong to its end.
inline bool is_leapfrog(const Case& settings) {
  return parameters_of(settings).integrator == Integrator::leapfrog;
}

/// Whether the work of all forces and all losses are known: with the leapfrog, whose velocities and
/// displacements belong to the same time, and without stiffness-proportional damping.
inline bool knows_losses(const Case& settings) {
  return is_leapfrog(settings) && parameters_of(settings).stiffness_damping == 0;
}

/// Neighbours of each node; if the case gives no number, 26 in 3D, 8 in 2D, and 12
/// in 2D octrees.
int neighbour_count(const Case& settings);

/// The nodes around a node of a lattice: those with which a uniform stress is in equilibrium next
/// to faces.
constexpr int nodes_around(int dimension) { return dimension == 2 ? 8 : 26; }

/// Whether blades of the case cut one of its bodies.
bool has_cuts(const Case& settings, const BodyCase& body);

/// The keys of the motion of nodes.
void visit_motion_keys(MethodKeys& visit, Integrator& integrator, std::optional<double>& damping);
void visit_keys(MethodKeys& visit, MethodParameters& parameters);

}  // namespace pliant::point_based

namespace pliant {

template <>
inline constexpr std::array words<point_based::NodePlacement>{
    word(point_based::NodePlacement::lattice, "lattice", "on a lattice of the given spacing"),
    word(point_based::NodePlacement::octree, "octree",
         "in the leaves of an octree: at the spacing on the surface, coarser inside")};

template <>
inline constexpr std::array words<point_based::CutRule>{
    word(point_based::CutRule::transparency, "transparency",
         "a crossed bond loses its weight as the front of the cut moves away from it (CU.1)"),
    word(point_based::CutRule::visibility, "visibility", "a crossed bond has no weight"),
    word(point_based::CutRule::product, "product",
         "distance enrichment of each piece, multiplied (CU.3), (CU.4); for comparison"),
    word(point_based::CutRule::enrichment_grid, "enrichment_grid",
         "distance enrichment of the whole cut (CU.3), (CU.5)")};

template <>
inline constexpr std::array words<point_based::NodeGradient>{
    word(point_based::NodeGradient::moving_least_squares, "moving_least_squares",
         "moving least squares (PB.3); irregular nodes with weights that balance a uniform stress "
         "inside (PB.61)"),
    word(point_based::NodeGradient::patch_exact, "patch_exact",
         "the nearest gradient with which the forces of a uniform stress are exact, away from cuts "
         "(PB.17)")};

template <>
inline constexpr std::array words<point_based::Integrator>{
    word(point_based::Integrator::leapfrog, "leapfrog",
         "forces act in the middle of a step; second order"),
    word(point_based::Integrator::kick_drift, "kick_drift",
         "forces act at its start (symplectic Euler); positions of second order, velocities half a "
         "step late")};

}  // namespace pliant
