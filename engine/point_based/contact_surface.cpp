#include "engine/point_based/contact_surface.hpp"

namespace pliant::point_based {

using undeformed::Share;

template <class T, int D>
undeformed::ContactSurface<D> contact_surface(const Body<T, D>& body) {
  undeformed::ContactSurface<D> surface;
  surface.facet = body.surface.facet;
  for (std::size_t c = 0; c < body.surface.start.size(); ++c) {
    const std::int32_t slot = body.surface.node[c];
    const Point<D> from = difference<D>(body.surface.start[c], body.start[slot]);
    std::vector<Share> shares = {{slot, 1}};
    if (from != Point<D>{} && !body.has_cuts()) {
      body.for_each_bond(body.block_of(slot), slot,
                         [&](int, std::int64_t other, const Point<D>& g, double) {
                           const double weight = dot<D>(g, from);
                           shares.push_back({static_cast<std::int32_t>(other), weight});
                           shares.front().weight -= weight;
                         });
    }
    surface.add(body.surface.start[c], shares);
  }
  if (!body.has_cuts()) return surface;
  body.for_each_node([&](std::int64_t slot) {
    surface.add(body.start[slot], std::array{Share{static_cast<std::int32_t>(slot), 1}});
  });
  return surface;
}

template undeformed::ContactSurface<2> contact_surface(const Body<double, 2>&);
template undeformed::ContactSurface<3> contact_surface(const Body<double, 3>&);
template undeformed::ContactSurface<2> contact_surface(const Body<float, 2>&);
template undeformed::ContactSurface<3> contact_surface(const Body<float, 3>&);

}  // namespace pliant::point_based
