#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/remeshed/ghosts/fit_terms.hpp"

/// Weighted least-squares fits to the particles around a foot point on the surface. A fit is a
/// coefficient for each particle that depends only on places: its weight times a polynomial.
namespace pliant::remeshed {

template <int D>
using Position = Eigen::Matrix<double, D, 1>;

template <int D>
struct FitParticle {
  std::int32_t slot;
  double weight;
  double surface_distance;  ///< phi or the distance to the wall, over h
  Position<D> position;     ///< relative to the foot point, over h
};

template <int D>
using FitParticles = std::vector<FitParticle<D>>;

/// The place of a ghost and its surface, for its fits.
template <int D>
struct FitSite {
  Position<D> ghost;        ///< x_g - x_f, over h
  Position<D> normal;       ///< unit vector, out of the body
  double surface_distance;  ///< of the ghost, over h
};

/// The reach of a fit.
template <int D>
struct FitReach {
  double radius;                             ///< [h]
  Position<D> normal = Position<D>::Zero();  ///< unit normal of the surface
  double narrowing = 1;  ///< factor by which the radius is smaller along the surface

  /// Parameters of the weight, see kernels::FitTerms.
  double steepness() const { return narrowing * narrowing / (radius * radius); }
  Position<D> broad() const { return std::sqrt(narrowing * narrowing - 1) / radius * normal; }
};

/// (RP.43) at the ghost, `linear` of the terms, and at the foot point, `surface`. Like the other
/// fits, returns false if the particles do not determine the fit.
template <class T, int D>
bool fit_in_all_directions(const FitParticles<D>& particles, const FitSite<D>& site,
                           kernels::FitTerms<T, D>& terms);

/// The same with only the terms {1, n.x}.
template <class T, int D>
bool fit_along_normal(const FitParticles<D>& particles, const FitSite<D>& site,
                      kernels::FitTerms<T, D>& terms);

/// (RP.44) at the ghost, `constrained` of the terms: the mean of the fits with the last term, the
/// squared distance, whose share is `curved`, and without it.
template <class T, int D>
bool fit_constrained(const FitParticles<D>& particles, const FitSite<D>& site, double curved,
                     kernels::FitTerms<T, D>& terms);

/// The last fallback: proportional to the distance.
template <class T, int D>
bool fit_proportional(const FitParticles<D>& particles, const FitSite<D>& site,
                      kernels::FitTerms<T, D>& terms);

}  // namespace pliant::remeshed
