#include "engine/total_lagrangian/contact_surface.hpp"

#include <map>
#include <set>
#include <tuple>
#include <vector>

namespace pliant::total_lagrangian {

namespace {

constexpr double at_particle = 1e-6;  // relative to the way from one particle to the next

/// Identifies a corner of a facet. A corner on a particle is the same for all lines from it.
template <int D>
std::tuple<std::int32_t, std::int32_t, Point<D>> name_of(const Vertex<D>& v) {
  if (v.along < at_particle) return {v.first, v.first, {}};
  return {v.first, v.second, v.start};
}

}  // namespace

template <class T, int D>
undeformed::ContactSurface<D> contact_surface(const Body<T, D>& body) {
  using undeformed::Share;
  undeformed::ContactSurface<D> surface;
  std::map<std::tuple<std::int32_t, std::int32_t, Point<D>>, std::int32_t> known;
  for (const Facet<D>& facet : body.facets) {
    auto& corners = surface.facet.emplace_back();
    for (int i = 0; i < D; ++i) {
      const Vertex<D>& v = facet.vertex[i];
      const auto [at, is_new] = known.insert({name_of(v), surface.corners()});
      corners[i] = at->second;
      if (!is_new) continue;
      if (v.first == v.second) {
        surface.add(v.start, std::array{Share{v.first, 1}});
      } else {
        surface.add(v.start, std::array{Share{v.first, 1 - v.along}, Share{v.second, v.along}});
      }
    }
    const std::set<std::int32_t> different(corners.begin(), corners.end());
    if (different.size() < D) surface.facet.pop_back();
  }
  return surface;
}

template <class T, int D>
void add_inner_particles(const Body<T, D>& body, undeformed::ContactSurface<D>& surface) {
  surface.first_inner = surface.corners();
  std::vector<int> whole_cells(body.slots);
  const auto for_each_slot = [&](const auto& f) {
    for (const Block<D>& block : body.layout.blocks()) body.layout.for_each_slot(block, f);
  };
  for_each_slot([&](std::int64_t slot, const Cell<D>& cell) {
    if (body.fraction[slot] < 1) return;
    for (const std::int64_t p : body.corners(cell)) ++whole_cells[p];
  });
  for_each_slot([&](std::int64_t p, const Cell<D>& cell) {
    if (whole_cells[p] < 1 << D) return;
    surface.add(body.place(p, cell),
                std::array{undeformed::Share{static_cast<std::int32_t>(p), 1}});
  });
}

template undeformed::ContactSurface<2> contact_surface(const Body<double, 2>&);
template undeformed::ContactSurface<3> contact_surface(const Body<double, 3>&);
template undeformed::ContactSurface<2> contact_surface(const Body<float, 2>&);
template undeformed::ContactSurface<3> contact_surface(const Body<float, 3>&);
template void add_inner_particles(const Body<double, 2>&, undeformed::ContactSurface<2>&);
template void add_inner_particles(const Body<double, 3>&, undeformed::ContactSurface<3>&);
template void add_inner_particles(const Body<float, 2>&, undeformed::ContactSurface<2>&);
template void add_inner_particles(const Body<float, 3>&, undeformed::ContactSurface<3>&);

}  // namespace pliant::total_lagrangian
