#include "engine/undeformed/contact/wall_meeting.hpp"

#include <algorithm>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::undeformed {

namespace {

constexpr double least_compliance = 1e-3;  // along the normal, relative to other directions

/// The weight of a corner in the mean with the middles around it, (TL.35).
template <int D>
inline constexpr double corner_weight = D == 2 ? 1. / 3 : 0.1;

/// What the corner gains of the weights of the middles, and the other ends of their edges lose,
/// (TL.35). With 0 a wall that touches a corner lies above the middles, and pushes nothing yet;
/// with 1/4 a flat surface meets a round wall with its corners alone.
constexpr double taken_at_ends = 0.15;

}  // namespace

template <class T, int D>
void WallMeetings<T, D>::clear() {
  meetings_.clear();
  bearing_.clear();
  first_.assign(1, 0);
}

template <class T, int D>
void WallMeetings<T, D>::add(const PushedSurface<T, D>& surface, std::span<const std::int32_t> near,
                             const Wall<D>& wall, const MetWall<D>& met,
                             const WallSearch<T, D>& search) {
  find_candidates(surface, near, wall, met, search);
  for (const Candidate& candidate : candidates_) {
    samples_.assign(1, candidate.sample);
    if (met.face == Face::smooth) weigh_facets(surface, wall, met);
    add_meeting(surface, candidate.index, samples_, wall, met);
  }
  if (met.face == Face::sharp) add_middles(surface, wall, met);
  first_.push_back(meetings_.size());
}

template <class T, int D>
void WallMeetings<T, D>::find_candidates(const PushedSurface<T, D>& surface,
                                         std::span<const std::int32_t> near, const Wall<D>& wall,
                                         const MetWall<D>& met, const WallSearch<T, D>& search) {
  candidates_.clear();
  for (const std::int32_t index : near) {
    const std::int32_t corner = surface.corners[index].number;
    const double reach = margin_ + reach_of_facets(met.face, surface.half_edge(corner));
    const bool has_many_carriers = surface.shape.shares(corner).size() > 2;
    if (has_many_carriers && !search.may_touch(surface, corner, met, reach)) continue;
    const Point<D> x = surface.place(corner);
    Sample own = sample(corner, x, corner, x, met);
    if (!search.may_reach(met, own.place, reach)) continue;
    own.gap = wall.distance(own.place);
    if (own.gap < reach) candidates_.push_back({index, own});
  }
}

template <class T, int D>
auto WallMeetings<T, D>::sample(std::int32_t corner, const Point<D>& x, std::int32_t other,
                                const Point<D>& y, const MetWall<D>& met) -> Sample {
  Point<D> middle;
  for (int a = 0; a < D; ++a) middle[a] = 0.5 * (x[a] + y[a]);
  const Point<D> shift = met.step.shift_at(middle);
  return {corner, other, 1, shift, difference<D>(middle, shift), 0};
}

// (TL.35)
template <class T, int D>
void WallMeetings<T, D>::weigh_facets(const PushedSurface<T, D>& surface, const Wall<D>& wall,
                                      const MetWall<D>& met) {
  constexpr double facing = 0.5;  // cosine of the angle between the normals
  Sample& own = samples_.front();
  const std::int32_t corner = own.corner;
  const std::span<const std::int32_t> neighbours = surface.neighbours(corner);
  places_.assign(1, surface.place(corner));
  weights_.assign(1 + neighbours.size(), 0);
  for (const std::int32_t other : neighbours) places_.push_back(surface.place(other));
  const Point<D> n = wall.normal(own.place);
  for (const std::int32_t f : surface.facets_at(corner)) {
    std::array<std::size_t, D> at = {};  // 0: the corner itself
    std::array<Point<D>, D> x;
    for (int v = 0; v < D; ++v) {
      const std::int32_t number = surface.shape.facet[f][v];
      if (number != corner)
        at[v] = 1 + (std::ranges::find(neighbours, number) - neighbours.begin());
      x[v] = places_[at[v]];
    }
    const Point<D> area = area_vector<D>(x);
    const double size = norm<D>(area);
    if (dot<D>(area, n) > -facing * size) continue;
    for (int v = 0; v < D; ++v) {
      weights_[at[v]] += size * (at[v] == 0 ? corner_weight<D> : (1 - corner_weight<D>) / (D - 1));
    }
  }
  if (weights_[0] > 0) own.weight = weights_[0];
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    if (weights_[1 + i] == 0) continue;
    Sample middle = sample(corner, places_[0], neighbours[i], places_[1 + i], met);
    Sample end = sample(neighbours[i], places_[1 + i], neighbours[i], places_[1 + i], met);
    middle.weight = weights_[1 + i];
    end.weight = -taken_at_ends * middle.weight;
    samples_.front().weight += taken_at_ends * middle.weight;
    for (Sample* point : {&middle, &end}) {
      point->gap = wall.distance(point->place);
      samples_.push_back(*point);
    }
  }
}

template <class T, int D>
void WallMeetings<T, D>::add_middles(const PushedSurface<T, D>& surface, const Wall<D>& wall,
                                     const MetWall<D>& met) {
  constexpr double alike = 1e-9;  // cosines of the angle between normals on a plane
  candidate_at_.resize(surface.shape.corners(), -1);
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    candidates_[i].normal = wall.normal(candidates_[i].sample.place);
    candidate_at_[candidates_[i].sample.corner] = static_cast<std::int32_t>(i);
  }
  for (const Candidate& candidate : candidates_) {
    const std::int32_t corner = candidate.sample.corner;
    for (const std::int32_t other : surface.neighbours(corner)) {
      if (const std::int32_t at = candidate_at_[other]; at >= 0) {
        const bool is_flat = dot<D>(candidate.normal, candidates_[at].normal) > 1 - alike;
        if (other < corner || is_flat) continue;
      }
      Sample middle = sample(corner, surface.place(corner), other, surface.place(other), met);
      middle.gap = wall.distance(middle.place);
      add_meeting(surface, candidate.index, {&middle, 1}, wall, met);
    }
  }
  for (const Candidate& candidate : candidates_) candidate_at_[candidate.sample.corner] = -1;
}

template <class T, int D>
void WallMeetings<T, D>::add_meeting(const PushedSurface<T, D>& surface, std::int32_t index,
                                     std::span<const Sample> samples, const Wall<D>& wall,
                                     const MetWall<D>& met) {
  double sum = 0, gap = 0;
  for (const Sample& s : samples) {
    sum += s.weight;
    gap += s.weight * s.gap;
  }
  gap /= sum;
  if (gap >= margin_) return;
  WallMeeting<D> meeting;
  meeting.corner = index;
  const std::size_t first = bearing_.size();
  for (const Sample& s : samples) {
    const double weight = s.weight / sum;
    for (int a = 0; a < D; ++a) {
      meeting.place[a] += weight * s.place[a];
      meeting.velocity[a] += weight * s.shift[a] / met.length;
    }
    add_bearing(surface, s.corner, 0.5 * weight, first);
    add_bearing(surface, s.other, 0.5 * weight, first);
  }
  meeting.normal = wall.normal(meeting.place);
  meeting.first_bearing = static_cast<std::int32_t>(first);
  meeting.last_bearing = static_cast<std::int32_t>(bearing_.size());
  Body<T, D>& body = *surface.body;
  const BodyCarriers<T, D> carriers(body, body.*surface.moved, surface.held);
  const std::span<const Share> bearing = bearing_of(meeting);
  meeting.compliance = compliance<D>(carriers, bearing, meeting.normal);
  if (meeting.compliance < least_compliance * surface.corners[index].compliance) {
    bearing_.resize(first);
    return;
  }
  meeting.before = carried<T, D>(body.*surface.moved, bearing);
  meeting.offset = gap - dot<D>(meeting.normal, meeting.before);
  const Point<D> velocity = carried<T, D>(body.velocity, bearing);
  for (int a = 0; a < D; ++a) meeting.before[a] -= met.drift * velocity[a];
  meetings_.push_back(meeting);
}

template <class T, int D>
void WallMeetings<T, D>::add_bearing(const PushedSurface<T, D>& surface, std::int32_t corner,
                                     double weight, std::size_t first) {
  for (const Share& share : surface.bearing(corner)) {
    const auto known =
        std::find_if(bearing_.begin() + static_cast<std::ptrdiff_t>(first), bearing_.end(),
                     [&](const Share& s) { return s.slot == share.slot; });
    if (known == bearing_.end()) {
      bearing_.push_back({share.slot, weight * share.weight});
    } else {
      known->weight += weight * share.weight;
    }
  }
}

template class WallMeetings<double, 2>;
template class WallMeetings<double, 3>;
template class WallMeetings<float, 2>;
template class WallMeetings<float, 3>;

}  // namespace pliant::undeformed
