#include <algorithm>
#include <cmath>

#include "engine/lattice/column.hpp"
#include "engine/method/decompositions.hpp"
#include "engine/point_based/cut_faces/face_contact.hpp"

// The nodes that the faces of a cut move with, (PB.20).
namespace pliant::point_based {

namespace {

constexpr double seed_distance =
    0.3;  // of the place whose nearest node is the seed, from the cut [H]
constexpr double flat_share = 1e-3;  // nodes that lie almost in a plane or on a line

}  // namespace

template <class T, int D>
void FaceContact<T, D>::fit(const Body<T, D>& body, const Pair& pair, const MaterialPoint<D>& place,
                            double size, Side& side) {
  using Vector = Eigen::Matrix<double, D + 1, 1>;
  Eigen::Matrix<double, D + 1, D + 1> moment = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  std::array<Vector, most> basis;
  std::array<double, most> weight;
  double farthest = 0;
  for (int k = 0; k < side.count; ++k) {
    const Column<D> away = (column<D>(body.start[side.share[k].slot]) - column<D>(place)) / size;
    weight[k] = away.squaredNorm();
    farthest = std::max(farthest, weight[k]);
    basis[k] << 1, away;
  }
  for (int k = 0; k < side.count; ++k) {
    weight[k] = 1e-2 + 1 - weight[k] / farthest;
    moment += weight[k] * basis[k] * basis[k].transpose();
  }
  const Eigen::Matrix<double, D + 1, D + 1> inverse = pseudo_inverse<D + 1>(moment, flat_share);
  const Vector value = inverse.col(0);
  for (int t = 0; t < D - 1; ++t) {
    const Vector along = inverse.template rightCols<D>() * column<D>(pair.tangent[t]) / size;
    for (int k = 0; k < side.count; ++k) side.slope[t][k] = weight[k] * basis[k].dot(along);
  }
  for (int k = 0; k < side.count; ++k) side.share[k].weight = weight[k] * basis[k].dot(value);
}

// A node is on the side of the seed if it has a bond with it.
template <class T, int D>
auto FaceContact<T, D>::side_of(const Body<T, D>& body, const TissueMap<D>& tissue,
                                const Pair& pair, const MaterialPoint<D>& place, double sign) const
    -> Side {
  Side side;
  MaterialPoint<D> beside = place;
  for (int a = 0; a < D; ++a) beside[a] += sign * seed_distance * size_ * pair.normal[a];
  double least = HUGE_VAL;
  const auto near = tissue.nodes.nearest(place, 5 * most / 2);
  for (const auto& [distance, node] : near) {
    const Column<D> x = column<D>(tissue.start[node]);
    const double square = (x - column<D>(beside)).squaredNorm();
    if (square >= least || sign * column<D>(pair.normal).dot(x - column<D>(place)) <= 0) continue;
    least = square;
    side.seed = tissue.slot[node];
  }
  if (side.seed < 0) return side;
  std::vector<std::int32_t> bonded = {side.seed};
  body.for_each_bond(body.block_of(side.seed), side.seed,
                     [&](int, std::int64_t other, const Point<D>&, double) {
                       bonded.push_back(static_cast<std::int32_t>(other));
                     });
  for (const auto& [distance, node] : near) {
    if (side.count == most) break;
    const std::int32_t slot = tissue.slot[node];
    const bool is_beyond =
        sign * column<D>(pair.normal).dot(column<D>(tissue.start[node]) - column<D>(place)) > 0;
    if (is_beyond && std::find(bonded.begin(), bonded.end(), slot) != bonded.end()) {
      side.share[side.count++].slot = slot;
    }
  }
  if (side.count <= D) side.count = 0;
  if (side.count > 0) fit(body, pair, place, size_, side);
  return side;
}

template <class T, int D>
void FaceContact<T, D>::find_nodes(const Body<T, D>& body, const TissueMap<D>& tissue,
                                   std::span<const std::int32_t> changed) {
  for (const std::int32_t slot : changed) has_changed_[slot] = true;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    Pair& pair = pairs_[p];
    const bool is_new = p >= found_;
    if (is_new || (pair.above.seed >= 0 && has_changed_[pair.above.seed])) {
      pair.above = side_of(body, tissue, pair, pair.place, 1);
    }
    if (is_new || (pair.below.seed >= 0 && has_changed_[pair.below.seed])) {
      pair.below = side_of(body, tissue, pair, pair.place, -1);
    }
  }
  found_ = pairs_.size();
  for (const std::int32_t slot : changed) has_changed_[slot] = false;
}

template <class T, int D>
void FaceContact<T, D>::find_nodes(const Body<T, D>& body, const TissueMap<D>& tissue) {
  found_ = 0;
  find_nodes(body, tissue, {});
}

template void FaceContact<double, 2>::fit(const Body<double, 2>&, const Pair&,
                                          const MaterialPoint<2>&, double, Side&);
template void FaceContact<double, 3>::fit(const Body<double, 3>&, const Pair&,
                                          const MaterialPoint<3>&, double, Side&);
template void FaceContact<float, 2>::fit(const Body<float, 2>&, const Pair&,
                                         const MaterialPoint<2>&, double, Side&);
template void FaceContact<float, 3>::fit(const Body<float, 3>&, const Pair&,
                                         const MaterialPoint<3>&, double, Side&);
template void FaceContact<double, 2>::find_nodes(const Body<double, 2>&, const TissueMap<2>&,
                                                 std::span<const std::int32_t>);
template void FaceContact<double, 2>::find_nodes(const Body<double, 2>&, const TissueMap<2>&);
template auto FaceContact<double, 2>::side_of(const Body<double, 2>&, const TissueMap<2>&,
                                              const Pair&, const MaterialPoint<2>&, double) const
    -> Side;
template void FaceContact<double, 3>::find_nodes(const Body<double, 3>&, const TissueMap<3>&,
                                                 std::span<const std::int32_t>);
template void FaceContact<double, 3>::find_nodes(const Body<double, 3>&, const TissueMap<3>&);
template auto FaceContact<double, 3>::side_of(const Body<double, 3>&, const TissueMap<3>&,
                                              const Pair&, const MaterialPoint<3>&, double) const
    -> Side;
template void FaceContact<float, 2>::find_nodes(const Body<float, 2>&, const TissueMap<2>&,
                                                std::span<const std::int32_t>);
template void FaceContact<float, 2>::find_nodes(const Body<float, 2>&, const TissueMap<2>&);
template auto FaceContact<float, 2>::side_of(const Body<float, 2>&, const TissueMap<2>&,
                                             const Pair&, const MaterialPoint<2>&, double) const
    -> Side;
template void FaceContact<float, 3>::find_nodes(const Body<float, 3>&, const TissueMap<3>&,
                                                std::span<const std::int32_t>);
template void FaceContact<float, 3>::find_nodes(const Body<float, 3>&, const TissueMap<3>&);
template auto FaceContact<float, 3>::side_of(const Body<float, 3>&, const TissueMap<3>&,
                                             const Pair&, const MaterialPoint<3>&, double) const
    -> Side;

}  // namespace pliant::point_based
