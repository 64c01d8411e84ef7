#include "engine/point_based/cutting/enrichment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/lattice/column.hpp"
#include "engine/point_based/cutting/crossing.hpp"

namespace pliant::point_based {
namespace {

template <int D>
Column<D> start_of_blade(const CutSurface<D>& cut, std::int32_t station) {
  return column<D>(cut.point(station, 0));
}
template <int D>
Column<D> end_of_blade(const CutSurface<D>& cut, std::int32_t station) {
  return column<D>(cut.point(station, cut.points_per_station() - 1));
}
template <int D>
Column<D> centre(const CutSurface<D>& cut, std::int32_t station) {
  return (start_of_blade(cut, station) + end_of_blade(cut, station)) / 2;
}

/// Unit normal of the part between two stations, on the same side as the normals of its pieces.
Column<2> normal_between(const CutSurface<2>& cut, std::int32_t station) {
  const Column<2> along = centre(cut, station + 1) - centre(cut, station);
  return Column<2>(-along[1], along[0]).normalized();
}
Column<3> normal_between(const CutSurface<3>& cut, std::int32_t station) {
  const Column<3> along = centre(cut, station + 1) - centre(cut, station);
  const Column<3> blade = end_of_blade(cut, station) + end_of_blade(cut, station + 1) -
                          start_of_blade(cut, station) - start_of_blade(cut, station + 1);
  return along.cross(blade).normalized();
}

}  // namespace

template <int D>
double piece_enrichment(const MaterialPoint<D>& x, const std::array<MaterialPoint<D>, D>& piece) {
  const PieceDistance<D> to = distance_to_piece<D>(x, piece);
  return to.distance > 0 ? std::clamp(to.across / to.distance, -1., 1.) : 0;
}

template <int D>
EnrichmentGrid<D>::EnrichmentGrid(const CutSurface<D>& cut) {
  const std::int32_t last = cut.stations() - 1;
  const Column<D> chord = (centre(cut, last) - centre(cut, 0)).normalized();
  Column<D> weighted = Column<D>::Zero();
  double length = 0;
  for (std::int32_t i = 0; i < last; ++i) {
    const Column<D> from = centre(cut, i), to = centre(cut, i + 1);
    weighted += (to - from).norm() * (from + to) / 2;
    length += (to - from).norm();
  }
  const Column<D> middle = weighted / length;
  chord_ = as_point<D>(chord);
  middle_ = as_point<D>(middle);
  ends_.reserve(last + 1);
  for (std::int32_t i = 0; i <= last; ++i) {
    ends_.push_back(chord.dot(centre(cut, i) - middle));
    if (i > 0 && !(ends_[i] > ends_[i - 1])) {
      throw std::invalid_argument(
          "the enrichment grid needs a cut that advances along the line between its ends");
    }
  }
  regions_.reserve(last);
  for (std::int32_t i = 0; i < last; ++i) {
    const Column<D> from = (start_of_blade(cut, i) + start_of_blade(cut, i + 1)) / 2;
    const Column<D> to = (end_of_blade(cut, i) + end_of_blade(cut, i + 1)) / 2;
    regions_.push_back({as_point<D>((from + to) / 2), as_point<D>(normal_between(cut, i)),
                        as_point<D>(from), as_point<D>(to)});
  }
}

template <int D>
double EnrichmentGrid<D>::operator()(const MaterialPoint<D>& x) const {
  const Column<D> at = column<D>(x);
  const double t = column<D>(chord_).dot(at - column<D>(middle_));
  // Regions are closed at their start and open at their end: each t belongs to one.
  const auto after = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, t);
  const Region& region = regions_[after - ends_.begin() - 1];
  const double s = column<D>(region.normal).dot(at - column<D>(region.origin));
  double outside = std::max(ends_.front() - t, 0.) + std::max(t - ends_.back(), 0.);
  if constexpr (D == 3) {
    const Column<3> blade = column<3>(region.across_to) - column<3>(region.across_from);
    const double along = blade.normalized().dot(at - column<3>(region.across_from));
    outside = std::hypot(outside, std::max(-along, 0.) + std::max(along - blade.norm(), 0.));
  }
  const double distance = std::hypot(outside, s);
  return distance > 0 ? s / distance : 0;
}

template double piece_enrichment<2>(const MaterialPoint<2>&,
                                    const std::array<MaterialPoint<2>, 2>&);
template double piece_enrichment<3>(const MaterialPoint<3>&,
                                    const std::array<MaterialPoint<3>, 3>&);
template class EnrichmentGrid<2>;
template class EnrichmentGrid<3>;

}  // namespace pliant::point_based
