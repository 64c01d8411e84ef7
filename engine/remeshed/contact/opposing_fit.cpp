#include "engine/remeshed/contact/opposing_fit.hpp"

#include <limits>

namespace pliant::remeshed {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

template <class T, int D>
double OpposingFit<T, D>::gap(const SurfaceSamples<D>& surface, const Lattice<D>& lattice,
                              const Point<D>& x, double farthest) {
  surface_ = &surface;
  const Point<D> at = place<D>(x, lattice);
  if (!surface.holds(at, lattice, 0)) return infinity;
  if (gather(at) > farthest || around_.empty() || !fit(around_)) return infinity;
  double gap = 0;
  for (const FitParticle<D>& i : around_) gap += coefficient(i) * i.surface_distance;
  return gap;
}

// Returns a lower bound on the gap, from the nearest sample.
template <class T, int D>
double OpposingFit<T, D>::gather(const Point<D>& at) {
  particles_.clear();
  around_.clear();
  double nearest = contact_fit_radius, least_gap = 0;
  surface_->cells.any_near(at, [&](const auto& site, const Point<D>& shift) {
    Position<D> r;
    for (int a = 0; a < D; ++a) r[a] = site.position[a] + shift[a] - at[a];
    const double fraction = r.squaredNorm() / (contact_fit_radius * contact_fit_radius);
    if (fraction >= 1) return false;
    const double phi = surface_->level_set[site.label];
    around_.push_back({site.label, (1 - fraction) * (1 - fraction), phi, r});
    if (surface_->record[site.label] >= 0) particles_.push_back(around_.back());
    if (const double distance = r.norm(); distance < nearest) {
      nearest = distance;
      least_gap = phi - distance;
    }
    return false;
  });
  return least_gap;
}

template <class T, int D>
bool OpposingFit<T, D>::fit(const FitParticles<D>& particles) {
  const FitSite<D> site = {Position<D>::Zero(), Position<D>::Zero(), 0};
  return fit_in_all_directions(particles, site, terms_);
}

template <class T, int D>
double OpposingFit<T, D>::coefficient(const FitParticle<D>& particle) const {
  double sum = terms_.linear[0];
  for (int a = 0; a < D; ++a) sum += terms_.linear[a + 1] * particle.position[a];
  return particle.weight * sum;
}

template <class T, int D>
bool OpposingFit<T, D>::add_to(ContactPoints<T, D>& contact_points) {
  if (!fit(particles_)) return false;
  for (const FitParticle<D>& i : particles_) {
    contact_points.record.push_back(surface_->record[i.slot]);
    contact_points.coefficient.push_back(static_cast<T>(coefficient(i)));
  }
  contact_points.begin.push_back(static_cast<std::int64_t>(contact_points.record.size()));
  return true;
}

template class OpposingFit<double, 2>;
template class OpposingFit<double, 3>;
template class OpposingFit<float, 2>;
template class OpposingFit<float, 3>;

}  // namespace pliant::remeshed
