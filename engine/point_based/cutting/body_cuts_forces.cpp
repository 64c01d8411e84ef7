#include <algorithm>

#include "engine/case/blade_track.hpp"
#include "engine/point_based/cutting/body_cuts.hpp"

// The forces of blades, (PB.18), and of cut faces on each other, (PB.20). The case defines how fast
// its blades move in a step. A caller only defines places: the blade moves there with the mean
// velocity since the last place, for as long as that move took. If it is put elsewhere before, the
// rest of its way is added to the next one.
namespace pliant::point_based {

template <class T, int D>
void BodyCuts<T, D>::resist(Blade& blade, const Station& station, double time) {
  const bool begins = blade.cut < 0;
  const double taken = time - blade.moved;
  const double left = std::max(0., blade.moves_until - time);
  if (begins) blade.velocity.assign(station.size(), {});
  for (std::size_t k = 0; !begins && taken > 0 && k < station.size(); ++k) {
    for (int a = 0; a < D; ++a) {
      double& velocity = blade.velocity[k][a];
      velocity = (station[k][a] - blade.station[k][a] + left * velocity) / taken;
    }
  }
  blade.moves_until = time + taken;
  blade.moved = time;
  blade.resistance.follow(begins ? Station{} : blade.station, station, *tissue_);
}

template <class T, int D>
void BodyCuts<T, D>::load(double time, double length, Body<T, D>& body,
                          std::span<BladeLoad<D>> sums) {
  if (!tissue_) return;
  for (auto& of_block : body.bladed) of_block.clear();
  for (Blade& blade : blades_) {
    if (blade.cut < 0 || blade.is_done || !blade.resistance.acts()) continue;
    if (blade.is_put) {
      if (time < blade.moves_until) blade.resistance.load(blade.velocity, body, sums[blade.number]);
      continue;
    }
    find_edge(blade.source, time, edge_);
    find_edge(blade.source, std::min(time + length, blade.source.end), next_edge_);
    for (std::size_t k = 0; k < edge_.size(); ++k) {
      for (int a = 0; a < D; ++a) next_edge_[k][a] = (next_edge_[k][a] - edge_[k][a]) / length;
    }
    blade.resistance.load(next_edge_, body, sums[blade.number]);
  }
}

template <class T, int D>
void BodyCuts<T, D>::push_faces_apart(Body<T, D>& body, double length, double drift) {
  if (!faces_) return;
  if (has_moved_) {
    std::vector<std::int32_t> changed;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      changed.insert(changed.end(), bonds_.changed(b).begin(), bonds_.changed(b).end());
    }
    faces_->find_nodes(body, *tissue_, changed);
  }
  faces_->apply(body, *tissue_, length, drift);
}

// A blade that starts inside the body does not puncture.
template <class T, int D>
bool BodyCuts<T, D>::enters(std::size_t b, double time) {
  Blade& blade = blades_[b];
  if (blade.outside.empty()) {
    const Station points = blade.puncture->points_of(edge_);
    if (std::any_of(points.begin(), points.end(),
                    [this](const Point<D>& x) { return bonds_.is_inside(x); })) {
      blade.puncture.reset();
      return true;
    }
  }
  if (blade.puncture->mean_force() == 0) blade.outside = edge_;
  if (!blade.puncture->has_entered()) return false;
  blade.puncture.reset();
  move_blade(b, blade.outside, time);
  return true;
}

template <class T, int D>
bool BodyCuts<T, D>::has_punctures() const {
  return std::any_of(blades_.begin(), blades_.end(),
                     [](const Blade& blade) { return blade.source.puncture_force > 0; });
}

template <class T, int D>
double BodyCuts<T, D>::press_surface(Body<T, D>& body, double time, const ContactStep& step,
                                     std::span<BladeLoad<D>> sums) {
  double power = 0;
  for (Blade& blade : blades_) {
    if (!blade.puncture || blade.is_done || time < blade.source.start) continue;
    find_edge(blade.source, time, edge_);
    find_edge(blade.source, std::min(time + step.length, blade.source.end), next_edge_);
    const BladeLoad<D> exerted = blade.puncture->push(body, edge_, next_edge_, step);
    for (int a = 0; a < D; ++a) sums[blade.number].force[a] += exerted.force[a];
    sums[blade.number].power += exerted.power;
    power += exerted.power;
  }
  return power;
}

template void BodyCuts<double, 2>::resist(Blade&, const Station&, double);
template void BodyCuts<double, 3>::resist(Blade&, const Station&, double);
template void BodyCuts<float, 2>::resist(Blade&, const Station&, double);
template void BodyCuts<float, 3>::resist(Blade&, const Station&, double);
template void BodyCuts<double, 2>::push_faces_apart(Body<double, 2>&, double, double);
template void BodyCuts<double, 3>::push_faces_apart(Body<double, 3>&, double, double);
template void BodyCuts<float, 2>::push_faces_apart(Body<float, 2>&, double, double);
template void BodyCuts<float, 3>::push_faces_apart(Body<float, 3>&, double, double);
template void BodyCuts<double, 2>::load(double, double, Body<double, 2>&, std::span<BladeLoad<2>>);
template void BodyCuts<double, 3>::load(double, double, Body<double, 3>&, std::span<BladeLoad<3>>);
template void BodyCuts<float, 2>::load(double, double, Body<float, 2>&, std::span<BladeLoad<2>>);
template void BodyCuts<float, 3>::load(double, double, Body<float, 3>&, std::span<BladeLoad<3>>);
template bool BodyCuts<double, 2>::enters(std::size_t, double);
template bool BodyCuts<double, 2>::has_punctures() const;
template double BodyCuts<double, 2>::press_surface(Body<double, 2>&, double, const ContactStep&,
                                                   std::span<BladeLoad<2>>);
template bool BodyCuts<double, 3>::enters(std::size_t, double);
template bool BodyCuts<double, 3>::has_punctures() const;
template double BodyCuts<double, 3>::press_surface(Body<double, 3>&, double, const ContactStep&,
                                                   std::span<BladeLoad<3>>);
template bool BodyCuts<float, 2>::enters(std::size_t, double);
template bool BodyCuts<float, 2>::has_punctures() const;
template double BodyCuts<float, 2>::press_surface(Body<float, 2>&, double, const ContactStep&,
                                                  std::span<BladeLoad<2>>);
template bool BodyCuts<float, 3>::enters(std::size_t, double);
template bool BodyCuts<float, 3>::has_punctures() const;
template double BodyCuts<float, 3>::press_surface(Body<float, 3>&, double, const ContactStep&,
                                                  std::span<BladeLoad<3>>);

}  // namespace pliant::point_based
