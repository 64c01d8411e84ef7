#include "engine/undeformed/contact/wall_meeting.hpp"

#include <algorithm>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::undeformed {

namespace {

constexpr double least_compliance = 1e-3;  // along the normal, relative to other directions

/// The weight of a corner in the mean with the middles around it, (TL.35).
template <int D>
inline constexpr double corner_weight = D == 2 ? 1. / 3 : 0.1;

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
  if (met.face == Face::sharp) {
    for (const Candidate& candidate : candidates_) add_middles(surface, candidate, wall, met);
  }
  first_.push_back(meetings_.size());
}

template <class T, int D>
void WallMeetings<T, D>::find_candidates(const PushedSurface<T, D>& surface,
                                         std::span<const std::int32_t> near, const Wall<D>& wall,
                                         const MetWall<D>& met, const WallSearch<T, D>& search) {
  candidates_.clear();
  for (const std::int32_t index : near) {
    const std::int32_t corner = surface.corners[index].number;
    const double reach = margin_ + (met.face == Face::plane ? 0 : surface.half_edge(corner));
    const bool has_many_carriers = surface.shape.shares(corner).size() > 2;
    if (has_many_carriers && !search.may_touch(surface, corner, met, reach)) continue;
    Sample own = sample(surface, corner, corner, met);
    if (!search.may_reach(met, own.place, reach)) continue;
    own.gap = wall.distance(own.place);
    own.weight = 1;
    if (own.gap < reach) candidates_.push_back({index, own});
  }
}

template <class T, int D>
auto WallMeetings<T, D>::sample(const PushedSurface<T, D>& surface, std::int32_t corner,
                                std::int32_t other, const MetWall<D>& met) -> Sample {
  Point<D> x = surface.place(corner);
  if (other != corner) {
    const Point<D> end = surface.place(other);
    for (int a = 0; a < D; ++a) x[a] = 0.5 * (x[a] + end[a]);
  }
  const Point<D> shift = met.step.shift_at(x);
  return {corner, other, 0, shift, difference<D>(x, shift), 0};
}

template <class T, int D>
auto WallMeetings<T, D>::middle_to(const PushedSurface<T, D>& surface, std::int32_t other,
                                   const Wall<D>& wall, const MetWall<D>& met) -> Sample& {
  for (Sample& known : samples_) {
    if (known.other == other) return known;
  }
  Sample middle = sample(surface, samples_.front().corner, other, met);
  middle.gap = wall.distance(middle.place);
  return samples_.emplace_back(middle);
}

// (TL.35)
template <class T, int D>
void WallMeetings<T, D>::weigh_facets(const PushedSurface<T, D>& surface, const Wall<D>& wall,
                                      const MetWall<D>& met) {
  constexpr double facing = 0.5;  // cosine of the angle between the normals
  const std::int32_t corner = samples_.front().corner;
  const Point<D> n = wall.normal(samples_.front().place);
  samples_.front().weight = 0;
  for (const std::int32_t f : surface.facets_at(corner)) {
    const std::array<std::int32_t, D>& facet = surface.shape.facet[f];
    std::array<Point<D>, D> x;
    for (int v = 0; v < D; ++v) x[v] = surface.place(facet[v]);
    const Point<D> area = area_vector<D>(x);
    const double size = norm<D>(area);
    if (dot<D>(area, n) > -facing * size) continue;
    samples_.front().weight += corner_weight<D> * size;
    for (const std::int32_t other : facet) {
      if (other == corner) continue;
      middle_to(surface, other, wall, met).weight += (1 - corner_weight<D>) / (D - 1) * size;
    }
  }
  if (samples_.size() == 1) samples_.front().weight = 1;
}

template <class T, int D>
void WallMeetings<T, D>::add_middles(const PushedSurface<T, D>& surface, const Candidate& candidate,
                                     const Wall<D>& wall, const MetWall<D>& met) {
  const std::int32_t corner = candidate.sample.corner;
  samples_.assign(1, candidate.sample);
  for (const std::int32_t f : surface.facets_at(corner)) {
    for (const std::int32_t other : surface.shape.facet[f]) {
      if (corner < other || !is_candidate(other)) middle_to(surface, other, wall, met).weight = 1;
    }
  }
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    add_meeting(surface, candidate.index, std::span(samples_).subspan(i, 1), wall, met);
  }
}

template <class T, int D>
bool WallMeetings<T, D>::is_candidate(std::int32_t corner) const {
  const auto at = std::lower_bound(
      candidates_.begin(), candidates_.end(), corner,
      [](const Candidate& one, std::int32_t number) { return one.sample.corner < number; });
  return at != candidates_.end() && at->sample.corner == corner;
}

template <class T, int D>
void WallMeetings<T, D>::add_meeting(const PushedSurface<T, D>& surface, std::int32_t index,
                                     std::span<const Sample> samples, const Wall<D>& wall,
                                     const MetWall<D>& met) {
  double sum = 0, least = margin_;
  for (const Sample& s : samples) {
    sum += s.weight;
    least = std::min(least, s.gap);
  }
  if (least >= margin_) return;
  WallMeeting<D> meeting;
  meeting.corner = index;
  const std::size_t first = bearing_.size();
  for (const Sample& s : samples) {
    const double weight = s.weight / sum;
    const Point<D> normal = wall.normal(s.place);
    for (int a = 0; a < D; ++a) {
      meeting.normal[a] += weight * normal[a];
      meeting.place[a] += weight * s.place[a];
      meeting.velocity[a] += weight * s.shift[a] / met.length;
    }
    meeting.offset += weight * s.gap;
    add_bearing(surface, s.corner, 0.5 * weight, first);
    add_bearing(surface, s.other, 0.5 * weight, first);
  }
  normalise<D>(meeting.normal);
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
  meeting.offset -= dot<D>(meeting.normal, carried<T, D>(body.*surface.moved, bearing));
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
