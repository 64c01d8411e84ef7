#include "engine/remeshed/loads/shear_patches.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/lattice/tangents.hpp"
#include "engine/remeshed/loads/facet_parts.hpp"
#include "engine/remeshed/loads/loaded_surface.hpp"

namespace pliant::remeshed {

namespace {

constexpr double full_depth = 2.5;    // [h] down to which a particle has the whole weight
constexpr double depth = 4.5;         // [h] where the weight ends
constexpr double radius = 3;          // [h] along the surface
constexpr double least_spread = 0.1;  // [h^2] of places along the surface that bear a moment

template <int D>
constexpr int moments = ShearPatch<D>::moments;
template <int D>
using Moment = Eigen::Matrix<double, moments<D>, 1>;
template <int D>
using Square = Eigen::Matrix<double, D, D>;
template <int D>
using Balance = Eigen::Matrix<double, moments<D>, moments<D>>;

template <int D>
Moment<D> torque(const PlaceVector<D>& x, const PlaceVector<D>& force) {
  if constexpr (D == 2) {
    return Moment<D>(x[0] * force[1] - x[1] * force[0]);
  } else {
    return x.cross(force);
  }
}

/// G_j of (RP.107): fields of force G_j (x - mean x) that bear moments, and have no resultant. They
/// turn about the normal, and push along it with a part that is linear along the surface.
template <int D>
std::array<Square<D>, moments<D>> moment_fields(const std::array<Point<D>, D>& axes) {
  const PlaceVector<D> n = column<D>(axes[0]), s = column<D>(axes[1]);
  if constexpr (D == 2) {
    return {n * s.transpose()};
  } else {
    const PlaceVector<D> t = column<D>(axes[2]);
    return {t * s.transpose() - s * t.transpose(), n * s.transpose(), n * t.transpose()};
  }
}

/// The unit normal and unit vectors across it.
template <int D>
std::array<Point<D>, D> axes_of(const PlaceVector<D>& normal) {
  const auto along = tangents<D>(normal);
  std::array<Point<D>, D> axes = {as_point<D>(normal)};
  for (int i = 1; i < D; ++i) axes[i] = as_point<D>(along.col(i - 1));
  return axes;
}

/// Moments of what is behind a patch, with the weights of (RP.107).
template <int D>
struct Behind {
  double material = 0;
  PlaceVector<D> first = PlaceVector<D>::Zero();
  Square<D> second = Square<D>::Zero();
};

/// sum of x cross G x from the sum of x x^T.
template <int D>
Moment<D> moment_of(const Square<D>& field, const Square<D>& second) {
  const Square<D> product = field * second;
  if constexpr (D == 2) {
    return Moment<D>(product(1, 0) - product(0, 1));
  } else {
    return {product(2, 1) - product(1, 2), product(0, 2) - product(2, 0),
            product(1, 0) - product(0, 1)};
  }
}

template <class T, int D>
class ShareFinder {
 public:
  ShareFinder(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
              const std::vector<LoadedFacet<D>>& facets, BlockShear<D>& shear)
      : view_(view),
        boundaries_(boundaries),
        facets_(facets),
        shear_(shear),
        spacing_(view.body.lattice.spacing) {}

  void find(ShearPatch<D>& patch) {
    PlaceVector<D> centre;
    if (!find_centre(patch, centre)) return;
    const std::size_t first = shear_.shares.size();
    const Behind<D> behind = look_behind(patch, centre);
    if (shear_.shares.size() == first || behind.material == 0) {
      shear_.shares.resize(first);
      return;
    }
    const PlaceVector<D> mean = behind.first / behind.material;
    patch.material = behind.material;
    patch.lever = as_point<D>(mean - centre);
    find_balance(behind.second / behind.material - mean * mean.transpose(), patch);
    for (std::size_t s = first; s < shear_.shares.size(); ++s) {
      Point<D>& offset = shear_.shares[s].offset;
      for (int a = 0; a < D; ++a) offset[a] -= mean[a];
    }
  }

 private:
  bool find_centre(ShearPatch<D>& patch, PlaceVector<D>& centre) const {
    PlaceVector<D> area = PlaceVector<D>::Zero();
    centre = PlaceVector<D>::Zero();
    double size = 0;
    for (int f = patch.first_facet; f < patch.first_facet + patch.facet_count; ++f) {
      std::array<PlaceVector<D>, D> places;
      PlaceVector<D> middle = PlaceVector<D>::Zero();
      for (int i = 0; i < D; ++i) {
        places[i] = column<D>(facets_[f].corners[i].place);
        middle += places[i] / D;
      }
      const PlaceVector<D> of_facet = facets_[f].share * area_under_traction(facets_[f], places);
      area += of_facet;
      centre += of_facet.norm() * middle;
      size += of_facet.norm();
    }
    if (area.norm() == 0) return false;
    centre /= size;
    patch.axes = axes_of<D>(area.normalized());
    return true;
  }

  PlaceVector<D> area_under_traction(const LoadedFacet<D>& facet,
                                     const std::array<PlaceVector<D>, D>& places) const {
    PlaceVector<D> area = PlaceVector<D>::Zero();
    for_each_loaded_part<D>(facet.parts, area_of(places),
                            [&](int load, const PlaceVector<D>& part, const PlaceVector<D>&) {
                              if (boundaries_.is_traction(load)) area += part;
                            });
    return area;
  }

  // Places in a cylinder behind the patch.
  Behind<D> look_behind(const ShearPatch<D>& patch, const PlaceVector<D>& centre) {
    const PlaceVector<D> n = column<D>(patch.axes[0]);
    const PlaceVector<D> middle = centre - depth / 2 * spacing_ * n;
    Cell<D> lower, upper;
    for (int a = 0; a < D; ++a) {
      const double along = std::abs(n[a]);
      const double across = std::sqrt(std::max(1 - along * along, 0.));
      const double reach = spacing_ * (1 + depth / 2 * along + radius * across);
      lower[a] = view_.body.lattice.cell(a, middle[a] - reach);
      upper[a] = view_.body.lattice.cell(a, middle[a] + reach);
    }
    Behind<D> behind;
    const auto number = static_cast<std::int32_t>(&patch - shear_.patches.data());
    for_each_cell<D>(lower, upper, [&](const Cell<D>& cell) {
      const Point<D> place = view_.body.lattice.node(cell);
      const Weights weights = weights_at((column<D>(place) - centre) / spacing_, n);
      if (weights.force > 0) add(cell, place, weights, number, behind);
    });
    return behind;
  }

  /// w of (RP.107), and that of the stress, (RP.112), in spacings.
  struct Weights {
    double force = 0, stress = 0;
  };
  static Weights weights_at(const PlaceVector<D>& from_centre, const PlaceVector<D>& n) {
    const double below = -n.dot(from_centre);
    if (below < -1) return {};
    const double across2 = (from_centre + below * n).squaredNorm();
    const double beside = std::max(1 - across2 / (radius * radius), 0.);
    constexpr double ramp = depth - full_depth;
    const double rest = std::max(depth - std::max(below, 0.), 0.);
    return {beside * std::min(rest / ramp, 1.),
            beside * (rest < ramp ? rest * rest / (2 * ramp) : rest - ramp / 2)};
  }

  void add(const Cell<D>& cell, const Point<D>& place, const Weights& weights, std::int32_t patch,
           Behind<D>& behind) {
    const double weight = weights.force;
    const std::int64_t slot = view_.population.layout.slot(view_.body.lattice.wrapped(cell));
    if (slot < 0 || view_.population.kind[slot] == Kind::vacant) return;
    const double phi = view_.fields.get(Field::level_set)[slot] / spacing_;
    const double to_wall = boundaries_.nearest_wall(place).second / spacing_;
    const double material =
        weight * std::clamp(0.5 - phi, 0., 1.) * std::clamp(0.5 + to_wall, 0., 1.);
    const PlaceVector<D> x = column<D>(place);
    behind.material += material;
    behind.first += material * x;
    behind.second += material * x * x.transpose();
    if (view_.population.kind[slot] != Kind::interior) return;
    shear_.shares.push_back(
        {static_cast<std::int32_t>(slot), patch, weight, weights.stress * spacing_, place});
  }

  // Directions along which the places have no spread bear no moment.
  void find_balance(const Square<D>& second, ShearPatch<D>& patch) const {
    const auto fields = moment_fields<D>(patch.axes);
    const Square<D> spread = second / (spacing_ * spacing_);
    Balance<D> moment;
    for (int j = 0; j < moments<D>; ++j) moment.col(j) = moment_of<D>(fields[j], spread);
    const bool is_borne = std::abs(moment.determinant()) > std::pow(least_spread, moments<D>);
    const double scale = 1 / (patch.material * spacing_ * spacing_);
    Eigen::Map<Balance<D>>(patch.balance.data()) =
        is_borne ? Balance<D>(scale * moment.inverse()) : Balance<D>::Zero();
  }

  const LatticeView<T, D>& view_;
  const Boundaries<D>& boundaries_;
  const std::vector<LoadedFacet<D>>& facets_;
  BlockShear<D>& shear_;
  double spacing_;
};

}  // namespace

template <class T, int D>
void find_shear_shares(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                       const std::vector<LoadedFacet<D>>& facets, BlockShear<D>& shear) {
  shear.shares.clear();
  ShareFinder<T, D> finder(view, boundaries, facets, shear);
  for (ShearPatch<D>& patch : shear.patches) finder.find(patch);
}

template <class T, int D>
void list_shear_shares(Body<T, D>& body, const Layout<D>& layout, int block) {
  const Block<D>& range = layout.blocks()[block];
  auto& own = body.shear[block].own;
  own.clear();
  const auto list = [&](int other) {
    const std::vector<ShearShare<D>>& shares = body.shear[other].shares;
    for (std::size_t s = 0; s < shares.size(); ++s) {
      const std::int64_t from_first = shares[s].slot - range.first_slot;
      if (from_first < 0 || from_first >= range.slot_count) continue;
      own.push_back({other, static_cast<std::int32_t>(s)});
    }
  };
  list(block);
  for (const int other : layout.neighbours()[block]) list(other);
  body.shear[block].before.resize(own.size());
}

template <class T, int D>
void evaluate_shear(Body<T, D>& body, int block, int stage, const BoundaryValues<D>& values) {
  for (ShearPatch<D>& patch : body.shear[block].patches) {
    if (patch.material == 0) continue;
    PlaceVector<D> force = PlaceVector<D>::Zero();
    for (int f = patch.first_facet; f < patch.first_facet + patch.facet_count; ++f) {
      force += force_at_stage<T, D>(body, body.loaded[block][f], stage, values).shear;
    }
    const Eigen::Map<const Balance<D>> balance(patch.balance.data());
    const Moment<D> share = -balance * torque<D>(column<D>(patch.lever), force);
    const auto fields = moment_fields<D>(patch.axes);
    Square<D> turn = Square<D>::Zero();
    for (int j = 0; j < moments<D>; ++j) turn += share[j] * fields[j];
    patch.mean = as_point<D>(force / patch.material);
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) patch.turn[i * D + j] = turn(i, j);
    }
  }
}

template void find_shear_shares<double, 2>(const LatticeView<double, 2>&, const Boundaries<2>&,
                                           const std::vector<LoadedFacet<2>>&, BlockShear<2>&);
template void list_shear_shares<double, 2>(Body<double, 2>&, const Layout<2>&, int);
template void evaluate_shear<double, 2>(Body<double, 2>&, int, int, const BoundaryValues<2>&);
template void find_shear_shares<double, 3>(const LatticeView<double, 3>&, const Boundaries<3>&,
                                           const std::vector<LoadedFacet<3>>&, BlockShear<3>&);
template void list_shear_shares<double, 3>(Body<double, 3>&, const Layout<3>&, int);
template void evaluate_shear<double, 3>(Body<double, 3>&, int, int, const BoundaryValues<3>&);
template void find_shear_shares<float, 2>(const LatticeView<float, 2>&, const Boundaries<2>&,
                                          const std::vector<LoadedFacet<2>>&, BlockShear<2>&);
template void list_shear_shares<float, 2>(Body<float, 2>&, const Layout<2>&, int);
template void evaluate_shear<float, 2>(Body<float, 2>&, int, int, const BoundaryValues<2>&);
template void find_shear_shares<float, 3>(const LatticeView<float, 3>&, const Boundaries<3>&,
                                          const std::vector<LoadedFacet<3>>&, BlockShear<3>&);
template void list_shear_shares<float, 3>(Body<float, 3>&, const Layout<3>&, int);
template void evaluate_shear<float, 3>(Body<float, 3>&, int, int, const BoundaryValues<3>&);

}  // namespace pliant::remeshed
