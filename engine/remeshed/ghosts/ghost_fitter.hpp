#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "engine/remeshed/ghosts/fit_search.hpp"
#include "engine/remeshed/ghosts/reentrant_corners.hpp"

namespace pliant::remeshed {

/// Appends the fits of one block's ghosts to their lists, in the order of calls.
///
/// Ghosts wait until there is one for each lane of a pack. Some are fitted again one by one: near
/// contact walls, with less reach along the surface, and if the particles within R do not determine
/// a fit, or hardly, with more particles or fewer terms.
template <class T, int D>
class GhostFitter {
 public:
  GhostFitter(const Body<T, D>& body, const Population<T, D>& population, BlockGhosts<T, D>& ghosts,
              const LevelSet<T, D>& level_set, const Boundaries<D>& boundaries,
              const ReentrantCorners<D>& corners, const kernels::RemeshedTable<T, D>& kernels,
              std::int32_t* used);

  /// (RP.43) and (RP.44) around a foot point; `wall` is nullptr at a free surface. `at_edge` is set
  /// where a side of the body meets a contact wall, (RP.81).
  void fit(const FitSite<D>& site, const Point<D>& foot, const Wall<D>* wall, bool at_edge);
  /// (RP.49)
  void average(const Cell<D>& cell);
  /// Fits the waiting ghosts.
  void finish();

 private:
  static constexpr int pack = Layout<D>::pack;

  using Terms = kernels::FitTerms<T, D>;

  struct Waiting {
    FitSite<D> site;
    Point<D> centre;  ///< foot point in cells
    FitReach<D> reach;
    const Wall<D>* wall;
    double curved;      ///< share of the fit (RP.44) with its last term
    bool at_rim;        ///< whether a no-slip wall or a re-entrant corner is near
    bool near_contact;  ///< whether a contact wall is near
    FitParticles<D> particles;

    /// Whether the curved fit is nearly undetermined, as in sharp corners of few particles, where
    /// it would need shorter steps: its coefficients have the sum `sum`, (RP.44).
    bool amplifies(T sum) const {
      return curved > 0 && std::abs(sum) > 10 * std::abs(site.surface_distance);
    }
  };
  /// Arguments of the kernel, [entry] or [lane] as in SurfaceFits.
  struct Lanes {
    std::array<std::vector<T>, D> position;
    std::vector<T> distance;
    alignas(64) std::array<std::array<T, pack>, D> ghost, normal;
    alignas(64) std::array<T, pack> ghost_distance, curved, constrained_sum, fitted;
    alignas(64) std::array<std::array<T, pack>, D + 1> linear, surface;
    alignas(64) std::array<std::array<T, pack>, D + 2> constrained;
  };
  /// Reused by each thread, so that later remeshings do not allocate.
  struct Scratch {
    std::array<Waiting, pack> waiting;
    Lanes lanes;
  };
  static Scratch& scratch();

  bool has_curved_fit(const Wall<D>& wall, const Point<D>& foot) const;
  void fill_lanes(int length);
  void fill_lane(int lane, int length);
  void fit_lanes(int length);
  Terms terms_of_lane(int lane) const;
  void fit_alone(Waiting& ghost);
  bool fit_fully(const Waiting& ghost, Terms& terms) const;
  void fit_poorly(const Waiting& ghost, Terms& terms) const;
  static void place(const Waiting& ghost, Terms& terms);
  void append(const Waiting& ghost, const Terms& terms, T constrained_sum);

  const Body<T, D>& body_;
  BlockGhosts<T, D>& ghosts_;
  FitSearch<T, D> search_;
  const LevelSet<T, D>& level_set_;
  const Boundaries<D>& boundaries_;
  const ReentrantCorners<D>& corners_;
  double rim_reach_;  ///< [h]
  const kernels::RemeshedTable<T, D>& kernels_;
  std::int32_t* used_;
  Scratch& scratch_ = scratch();
  int waiting_ = 0;
};

extern template class GhostFitter<double, 2>;
extern template class GhostFitter<double, 3>;
extern template class GhostFitter<float, 2>;
extern template class GhostFitter<float, 3>;

}  // namespace pliant::remeshed
