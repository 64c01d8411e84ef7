#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/undeformed/contact/wall_search.hpp"

namespace pliant::undeformed {

/// A point of a surface that a wall may push in a step, or the mean of several, and what the wall
/// has given to it.
template <int D>
struct WallMeeting {
  std::int32_t corner = 0;  ///< index in the corners of the surface; one end of an edge
  std::int32_t first_bearing = 0, last_bearing = 0;  ///< its range in the bearing particles
  Point<D> normal = {};                              ///< of the wall, towards the body
  Point<D> place = {};     ///< where the wall pushes, while it is where it was at the start [m]
  Point<D> velocity = {};  ///< of the wall there [m/s]
  double offset = 0;       ///< gap at no displacement of the bearing particles [m]
  double compliance = 0;   ///< along the normal [1/kg]
  double impulse = 0;      ///< along the normal [N s]
  double moved = 0;        ///< along the normal [kg m]
  Point<D> friction = {};  ///< impulse along the wall [N s]
  Point<D> held = {};      ///< along the wall, so that pushes do not move it there [kg m]
  Point<D> before = {};    ///< displacement when the forces of the step acted, without pushes [m]

  bool is_pushed() const { return impulse > 0 || moved > 0; }
};

/// What a surface and walls have to do with each other in a step, wall by wall, (TL.35).
template <class T, int D>
class WallMeetings {
 public:
  /// `spacing` of the particles [m].
  explicit WallMeetings(double spacing) : margin_(0.05 * spacing) {}

  void clear();
  /// Adds what `wall` may push in the step, as `met` says, of the corners `near` and around them.
  void add(const PushedSurface<T, D>& surface, std::span<const std::int32_t> near,
           const Wall<D>& wall, const MetWall<D>& met, const WallSearch<T, D>& search);

  /// Those with the wall that was added w-th.
  std::span<WallMeeting<D>> of_wall(std::size_t w) {
    return std::span(meetings_).subspan(first_[w], first_[w + 1] - first_[w]);
  }
  std::span<const Share> bearing_of(const WallMeeting<D>& meeting) const {
    return {bearing_.data() + meeting.first_bearing, bearing_.data() + meeting.last_bearing};
  }

 private:
  /// A point of the surface: a corner, or the middle between it and another one.
  struct Sample {
    std::int32_t corner, other;  ///< the corner twice if it is one
    double weight;
    Point<D> shift;  ///< of the wall there in the step [m]
    Point<D> place;  ///< as in WallMeeting
    double gap;
  };
  /// A corner near the wall.
  struct Candidate {
    std::int32_t index;  ///< in the corners of the surface
    Sample sample;
    Point<D> normal = {};  ///< of a wall with edges
  };

  void find_candidates(const PushedSurface<T, D>& surface, std::span<const std::int32_t> near,
                       const Wall<D>& wall, const MetWall<D>& met, const WallSearch<T, D>& search);
  /// That between a corner at x and another one at y, of weight 1, without its gap.
  static Sample sample(std::int32_t corner, const Point<D>& x, std::int32_t other,
                       const Point<D>& y, const MetWall<D>& met);
  /// Weighs the corner that is the only sample, and adds the middles of the edges of facets that
  /// face the wall.
  void weigh_facets(const PushedSurface<T, D>& surface, const Wall<D>& wall, const MetWall<D>& met);
  /// Adds the middle of each edge at a candidate, unless both ends are above one plane of the wall:
  /// their pushes then keep it outside.
  void add_middles(const PushedSurface<T, D>& surface, const Wall<D>& wall, const MetWall<D>& met);
  /// Adds the mean of `samples` unless it is farther from the wall than the margin.
  void add_meeting(const PushedSurface<T, D>& surface, std::int32_t index,
                   std::span<const Sample> samples, const Wall<D>& wall, const MetWall<D>& met);
  void add_bearing(const PushedSurface<T, D>& surface, std::int32_t corner, double weight,
                   std::size_t first);

  double margin_;  ///< gap that other pushes may close in a step [m]
  std::vector<WallMeeting<D>> meetings_;
  std::vector<std::size_t> first_ = {0};  ///< [wall + 1]
  std::vector<Share> bearing_;
  std::vector<Candidate> candidates_;
  std::vector<std::int32_t> candidate_at_;  ///< [corner] its number among them, or -1
  std::vector<Sample> samples_;             ///< of one meeting
  std::vector<Point<D>> places_;            ///< of a corner and its neighbours
  std::vector<double> weights_;             ///< of the samples between them
};

extern template class WallMeetings<double, 2>;
extern template class WallMeetings<double, 3>;
extern template class WallMeetings<float, 2>;
extern template class WallMeetings<float, 3>;

}  // namespace pliant::undeformed
