#include "engine/remeshed/contact/opposing_fit.hpp"

#include <limits>

namespace pliant::remeshed {

template <class T, int D>
double OpposingFit<T, D>::gap(const SurfaceSamples<D>& surface, const Lattice<D>& lattice,
                              const Point<D>& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Point<D> at = place<D>(x, lattice);
  if (!surface.holds(at, lattice, 0)) return infinity;
  gather(surface, at, true);
  if (!fit()) return infinity;
  double gap = 0;
  for (const FitParticle<D>& i : around_) gap += coefficient(i) * i.surface_distance;
  return gap;
}

template <class T, int D>
std::optional<Point<D>> OpposingFit<T, D>::add_to(ContactPoints<T, D>& contact_points,
                                                  const SurfaceSamples<D>& surface,
                                                  const Lattice<D>& lattice, const Point<D>& x) {
  gather(surface, place<D>(x, lattice), false);
  if (!fit()) return std::nullopt;
  Point<D> displacement = {};
  for (const FitParticle<D>& i : around_) {
    contact_points.record.push_back(surface.record[i.slot]);
    const double share = coefficient(i);
    contact_points.coefficient.push_back(static_cast<T>(share));
    for (int a = 0; a < D; ++a) displacement[a] += share * surface.displacement[i.slot][a];
  }
  contact_points.begin.push_back(static_cast<std::int64_t>(contact_points.record.size()));
  return displacement;
}

template <class T, int D>
void OpposingFit<T, D>::gather(const SurfaceSamples<D>& surface, const Point<D>& at,
                               bool with_ghosts) {
  around_.clear();
  surface.cells.any_near(at, [&](const auto& site, const Point<D>& shift) {
    if (!with_ghosts && surface.record[site.label] < 0) return false;
    Position<D> r;
    for (int a = 0; a < D; ++a) r[a] = site.position[a] + shift[a] - at[a];
    const double fraction = r.squaredNorm() / (contact_fit_radius * contact_fit_radius);
    if (fraction >= 1) return false;
    around_.push_back(
        {site.label, (1 - fraction) * (1 - fraction), surface.level_set[site.label], r});
    return false;
  });
}

template <class T, int D>
bool OpposingFit<T, D>::fit() {
  const FitSite<D> site = {Position<D>::Zero(), Position<D>::Zero(), 0};
  return !around_.empty() && fit_in_all_directions(around_, site, terms_);
}

template <class T, int D>
double OpposingFit<T, D>::coefficient(const FitParticle<D>& particle) const {
  double sum = terms_.linear[0];
  for (int a = 0; a < D; ++a) sum += terms_.linear[a + 1] * particle.position[a];
  return particle.weight * sum;
}

template class OpposingFit<double, 2>;
template class OpposingFit<double, 3>;
template class OpposingFit<float, 2>;
template class OpposingFit<float, 3>;

}  // namespace pliant::remeshed
