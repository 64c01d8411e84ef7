#include "engine/remeshed/contact/crossing_momentum.hpp"

#include <cmath>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::remeshed {

namespace {

/// Calls f(contact, sign, is_with_held) for each contact of a body; the sign is that of its impulse
/// on the body.
template <int D, class F>
void for_each_contact(const std::vector<ContactCase>& contacts,
                      const std::vector<MomentumGain<D>>& bodies, std::size_t body, F&& f) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    for (int side = 0; side < 2; ++side) {
      if (contacts[c].bodies[side] != static_cast<int>(body)) continue;
      f(c, side == 0 ? -1. : 1., !bodies[contacts[c].bodies[1 - side]].is_free);
    }
  }
}

}  // namespace

template <int D>
void follow_free_bodies(const std::vector<ContactCase>& contacts,
                        const std::vector<MomentumGain<D>>& bodies,
                        std::vector<Point<D>>& impulses) {
  const auto size = [](const Point<D>& vector) { return std::sqrt(dot<D>(vector, vector)); };
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!bodies[b].is_free) continue;
    Point<D> missing = bodies[b].gained;
    double with_held = 0;
    for_each_contact<D>(contacts, bodies, b, [&](std::size_t c, double sign, bool is_with_held) {
      for (int a = 0; a < D; ++a) missing[a] -= sign * impulses[c][a];
      if (is_with_held) with_held += size(impulses[c]);
    });
    if (with_held == 0) continue;
    for_each_contact<D>(contacts, bodies, b, [&](std::size_t c, double sign, bool is_with_held) {
      if (!is_with_held) return;
      const double share = size(impulses[c]) / with_held;
      for (int a = 0; a < D; ++a) impulses[c][a] += sign * share * missing[a];
    });
  }
}

template void follow_free_bodies<2>(const std::vector<ContactCase>&,
                                    const std::vector<MomentumGain<2>>&, std::vector<Point<2>>&);
template void follow_free_bodies<3>(const std::vector<ContactCase>&,
                                    const std::vector<MomentumGain<3>>&, std::vector<Point<3>>&);

}  // namespace pliant::remeshed
