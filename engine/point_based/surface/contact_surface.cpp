#include "engine/point_based/surface/contact_surface.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace pliant::point_based {

using undeformed::Share;

namespace {

/// The displacements of a corner at X and its node at X_i differ by (F - I)(X - X_i). That is at
/// most five times their distance while no stretch exceeds 4, under any rotation.
constexpr double largest_change = 5;
constexpr double at_node = 1e-9;  // [H] rounding errors of distances

}  // namespace

template <class T, int D>
std::vector<Share> shares_of_corner(const Body<T, D>& body, std::size_t corner) {
  const std::int32_t slot = body.surface.node[corner];
  const Point<D> from = difference<D>(body.surface.start[corner], body.start[slot]);
  std::vector<Share> shares = {{slot, 1}};
  const auto fit = body.surface.fit.find(slot);
  if (fit == body.surface.fit.end() || norm<D>(from) <= at_node * body.resolution) return shares;
  for (std::size_t k = 0; k < fit->second.slot.size(); ++k) {
    const double weight = dot<D>(fit->second.gradient[k], from);
    shares.push_back({fit->second.slot[k], weight});
    shares.front().weight -= weight;
  }
  return shares;
}

template <class T, int D>
undeformed::ContactSurface<D> contact_surface(const Body<T, D>& body) {
  undeformed::ContactSurface<D> surface;
  surface.facet = body.surface.facet;
  for (std::size_t c = 0; c < body.surface.start.size(); ++c) {
    const Point<D> from = difference<D>(body.surface.start[c], body.start[body.surface.node[c]]);
    surface.add(body.surface.start[c], shares_of_corner(body, c),
                largest_change * std::sqrt(dot<D>(from, from)));
  }
  surface.is_whole = !body.has_cuts();
  if (surface.is_whole) return surface;
  body.for_each_node([&](std::int64_t slot) {
    surface.add(body.start[slot], std::array{Share{static_cast<std::int32_t>(slot), 1}});
  });
  return surface;
}

template <class T, int D>
void add_inner_particles(const Body<T, D>& body, undeformed::ContactSurface<D>& surface) {
  if (body.has_cuts()) return;  // contact_surface has them
  surface.first_inner = surface.corners();
  std::vector<bool> is_corner(body.slots);
  for (const std::int32_t slot : body.surface.node) is_corner[slot] = true;
  body.for_each_node([&](std::int64_t slot) {
    if (is_corner[slot]) return;
    surface.add(body.start[slot], std::array{Share{static_cast<std::int32_t>(slot), 1}});
  });
}

template std::vector<Share> shares_of_corner(const Body<double, 2>&, std::size_t);
template std::vector<Share> shares_of_corner(const Body<double, 3>&, std::size_t);
template std::vector<Share> shares_of_corner(const Body<float, 2>&, std::size_t);
template std::vector<Share> shares_of_corner(const Body<float, 3>&, std::size_t);
template undeformed::ContactSurface<2> contact_surface(const Body<double, 2>&);
template undeformed::ContactSurface<3> contact_surface(const Body<double, 3>&);
template undeformed::ContactSurface<2> contact_surface(const Body<float, 2>&);
template undeformed::ContactSurface<3> contact_surface(const Body<float, 3>&);
template void add_inner_particles(const Body<double, 2>&, undeformed::ContactSurface<2>&);
template void add_inner_particles(const Body<double, 3>&, undeformed::ContactSurface<3>&);
template void add_inner_particles(const Body<float, 2>&, undeformed::ContactSurface<2>&);
template void add_inner_particles(const Body<float, 3>&, undeformed::ContactSurface<3>&);

}  // namespace pliant::point_based
