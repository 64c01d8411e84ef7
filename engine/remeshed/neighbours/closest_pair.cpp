#include "engine/remeshed/neighbours/closest_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/remeshed/neighbours/neighbour_lists.hpp"

namespace pliant::remeshed {

template <class T, int D>
double closest_pair(const Body<T, D>& body) {
  constexpr double radius = 2;
  std::vector<SlotSite<D>> sites;
  Point<D> lower, upper;
  lower.fill(std::numeric_limits<double>::max());
  upper.fill(std::numeric_limits<double>::lowest());
  const Layout<D>& layout = body.population.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t slot, const Cell<D>& cell) {
      if (body.population.kind[slot] != Kind::interior) return;
      sites.push_back(site_of<T, D>(body, slot, cell));
      for (int a = 0; a < D; ++a) {
        lower[a] = std::min(lower[a], sites.back().position[a]);
        upper[a] = std::max(upper[a], sites.back().position[a]);
      }
    });
  }
  SlotList<D> cells;
  cells.cover(lower, upper, period_of<D>(body.lattice), radius, sites.size());
  cells.sort(sites.size(), [&](auto&& f) {
    for (const SlotSite<D>& site : sites) f(site);
  });
  double least2 = radius * radius;
  for (const SlotSite<D>& p : sites) {
    cells.any_near(p.position, [&](const SlotSite<D>& q, const Point<D>& shift) {
      double distance2 = 0;
      for (int a = 0; a < D; ++a) {
        const double d = q.position[a] + shift[a] - p.position[a];
        distance2 += d * d;
      }
      if (q.label.slot != p.label.slot || shift != Point<D>{}) least2 = std::min(least2, distance2);
      return false;
    });
  }
  return std::sqrt(least2);
}

template double closest_pair<double, 2>(const Body<double, 2>&);
template double closest_pair<double, 3>(const Body<double, 3>&);
template double closest_pair<float, 2>(const Body<float, 2>&);
template double closest_pair<float, 3>(const Body<float, 3>&);

}  // namespace pliant::remeshed
