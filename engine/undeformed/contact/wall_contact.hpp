#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "engine/undeformed/contact/wall_meeting.hpp"
#include "engine/undeformed/contact/wall_search.hpp"

// Walls are rigid solids of any shape. Bodies can meet contact walls and leave them. The parts of a
// body that an attached wall does not hold can meet it in the same way: where a block is squeezed
// between plates that hold it, its sides bulge against them.
//
// Corners of the present surface must not lie inside a wall, (TL.12), nor what lies between them
// inside a tool, (TL.35). A corner that does after a step is moved back onto the wall along the
// normal, by the smallest change of the particles that carry it. If a corner moves with the
// gradient of a node, that node alone takes the push: with wide stencils, many corners would push
// each other out of the wall. Friction reduces the slip as far as Coulomb's law allows for the
// normal impulse.
//
// If velocities belong to the middle of a step, as with central differences, they change by what
// moves the corner back within the step. If they belong to its end, as with the leapfrog, a corner
// loses its velocity of approach, so that a corner at rest on the wall keeps none. No force ever
// pulls a corner back.
//
// There is no penalty stiffness: no parameter to choose, no shorter time step.
namespace pliant::undeformed {

/// A particle that a wall has pushed.
struct PushedParticle {
  int body;
  std::int32_t slot;
};

/// Numbers of the blocks with these particles; `first_slot(owner)` is that of a block.
template <class FirstSlot>
std::set<int> blocks_of(std::span<const PushedParticle> pushed,
                        const std::vector<BlockOwner>& owners, FirstSlot&& first_slot) {
  std::set<int> blocks;
  for (const PushedParticle& particle : pushed) {
    const auto after = std::upper_bound(
        owners.begin(), owners.end(), particle, [&](const PushedParticle& p, const BlockOwner& o) {
          return p.body < o.body || (p.body == o.body && p.slot < first_slot(o));
        });
    blocks.insert(static_cast<int>(after - owners.begin()) - 1);
  }
  return blocks;
}

/// Prevents the surfaces of bodies from entering walls, (TL.12).
template <class T, int D>
class WallContact {
 public:
  /// A step writes the displacements of a body to its member `moved`.
  WallContact(State<D>& state, const Case& settings, Displacements<T, D> moved);

  /// Whether the case has contact walls. Attached walls alone are seldom met.
  bool is_expected() const { return is_expected_; }
  /// Makes the surfaces of all bodies with contact_surface(body), if the case has walls. Contact
  /// walls meet the particles inside as well, add_inner_particles(body, surface): a tool that is
  /// small compared with the facets, or pressed in deeper than its radius, passes between the
  /// corners. The bodies must not move in memory.
  template <class Bodies>
  void take_surfaces(Bodies& bodies, ImpulseCarriers carriers) {
    surfaces_.clear();
    if (walls_.empty()) return;
    for (auto& body : bodies) {
      ContactSurface<D> surface = contact_surface(body);
      if (is_expected_) add_inner_particles(body, surface);
      surfaces_.emplace_back(body, moved_, std::move(surface), carriers, has_tools_);
    }
    search_.begin(surfaces_, walls_);
  }
  /// Lets the walls push particles that have moved for `length` [s] since `time`, of it for `drift`
  /// [s] at their present velocities, with forces that have acted for `kick` [s]. Adds impulses and
  /// work of the walls to the state.
  void apply(double time, double kick, double length, double drift);
  /// The particles that the last call has pushed, some of them more than once; only if the case
  /// has no contact walls.
  std::span<const PushedParticle> pushed() const { return pushed_; }

 private:
  /// Gauss-Seidel sweeps over the corners of a surface.
  void push_out(std::size_t surface);
  /// Adds what friction took, notes a wall inside the body, and lists the particles for pushed().
  void conclude(std::size_t surface);
  /// Returns the distance by which it moves the corner, in the step or at its end [m].
  double push(PushedSurface<T, D>& surface, const MetWall<D>& met, WallMeeting<D>& meeting);
  /// Adds an impulse on the body, and its work, to what the wall gave.
  void add_push(const MetWall<D>& met, const WallMeeting<D>& meeting, const Point<D>& impulse);
  /// Adds the energy that friction on a corner took in the step.
  void add_friction(const PushedSurface<T, D>& surface, const MetWall<D>& met,
                    const WallMeeting<D>& meeting);

  State<D>& state_;
  Displacements<T, D> moved_;
  bool is_expected_ = false;
  bool has_tools_ = false;  ///< walls that meet facets
  std::vector<MetWall<D>> walls_;
  std::vector<PushedSurface<T, D>> surfaces_;
  WallSearch<T, D> search_;
  WallMeetings<T, D> meetings_;  ///< of one surface
  std::vector<PushedParticle> pushed_;
};

extern template class WallContact<double, 2>;
extern template class WallContact<double, 3>;
extern template class WallContact<float, 2>;
extern template class WallContact<float, 3>;

}  // namespace pliant::undeformed
