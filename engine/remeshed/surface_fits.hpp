#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// Weighted least-squares fits of the particles around a foot point on the surface. They depend on
/// places alone, so that a fit is a list of coefficients, one for each particle.
namespace pliant::remeshed {

template <int D>
using Position = Eigen::Matrix<double, D, 1>;

template <int D>
struct FitParticle {
  std::int32_t slot;
  double weight;
  double surface_distance;  ///< phi or the distance to the wall, over h
  Position<D> position;     ///< from the foot point, over h
};

template <int D>
using FitParticles = std::vector<FitParticle<D>>;

/// What a ghost's fits are made about.
template <int D>
struct FitSite {
  Position<D> ghost;        ///< x_g - x_f over h
  Position<D> normal;       ///< unit, out of the body
  double surface_distance;  ///< of the ghost, over h
};

/// Where a fit looks for particles.
template <int D>
struct FitReach {
  double radius;                             ///< [h]
  Position<D> normal = Position<D>::Zero();  ///< unit, of the surface
  double narrowing = 1;                      ///< of the radius along the surface

  /// r^2/R^2 of the weight at a place from the foot point, over h.
  double fraction(const Position<D>& x) const {
    const double square = x.squaredNorm(), along = normal.dot(x);
    return (square + (narrowing * narrowing - 1) * (square - along * along)) / (radius * radius);
  }
};

/// Coefficients of (RP.32) at the ghost, appended to `c`, and at the foot point, appended to `a`.
/// False, as the others, where the particles do not determine the fit.
template <int D>
bool fit_in_all_directions(const FitParticles<D>& particles, const FitSite<D>& site,
                           std::vector<double>& c, std::vector<double>& a);

/// The same in {1, n.x} alone.
template <int D>
bool fit_along_normal(const FitParticles<D>& particles, const FitSite<D>& site,
                      std::vector<double>& c, std::vector<double>& a);

/// Coefficients of (RP.33) at the ghost; its last term, the square of the distance, only if
/// `curved`.
template <int D>
bool fit_constrained(const FitParticles<D>& particles, const FitSite<D>& site, bool curved,
                     std::vector<double>& b);

/// The last resort: proportional to the distance.
template <int D>
bool fit_proportional(const FitParticles<D>& particles, const FitSite<D>& site,
                      std::vector<double>& b);

}  // namespace pliant::remeshed
