#pragma once

#include <optional>
#include <vector>

#include "engine/remeshed/contact/surface_samples.hpp"
#include "engine/remeshed/ghosts/surface_fits.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

inline constexpr double contact_fit_radius = 2.6;  ///< [h] as for ghosts

/// Fits of another body around a point, (RP.56), (RP.58). Reuses its memory, so that later searches
/// do not allocate.
template <class T, int D>
class OpposingFit {
 public:
  /// The gap from x [m] to the surface of a body, by its level set [h]. Infinite if there is too
  /// little of the body.
  double gap(const SurfaceSamples<D>& surface, const Lattice<D>& lattice, const Point<D>& x);

  /// Adds the fit of the body's surface particles at x to `contact_points`, and gives their
  /// displacement there [m]; none if they do not determine it.
  std::optional<Point<D>> add_to(ContactPoints<T, D>& contact_points,
                                 const SurfaceSamples<D>& surface, const Lattice<D>& lattice,
                                 const Point<D>& x);

 private:
  void gather(const SurfaceSamples<D>& surface, const Point<D>& at, bool with_ghosts);
  bool fit();
  double coefficient(const FitParticle<D>& particle) const;

  FitParticles<D> around_;  ///< samples near the point
  kernels::FitTerms<double, D> terms_;
};

extern template class OpposingFit<double, 2>;
extern template class OpposingFit<double, 3>;
extern template class OpposingFit<float, 2>;
extern template class OpposingFit<float, 3>;

}  // namespace pliant::remeshed
