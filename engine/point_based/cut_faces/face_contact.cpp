#include "engine/point_based/cut_faces/face_contact.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/lattice/column.hpp"
#include "engine/point_based/cutting/subdivide.hpp"

namespace pliant::point_based {

namespace {

// Gauss-Seidel sweeps, since points share nodes. The error that remains in each step shakes faces
// that rest on each other: with 4 sweeps a block under its weight gained a third of its energy.
constexpr int most_sweeps = 16;
constexpr double settled = 1e-3;   // changes in a sweep, relative to those in the first
constexpr int most_tries = 32;     // moves after which a point belongs to a rim
constexpr double cell_size = 0.5;  // of a lattice with one pair in each cell that a cut passes [H]
constexpr double similar = 0.5;    // cosine between normals of pairs in one cell
constexpr double far_apart = 4;    // faces that cannot meet [H]
constexpr double deepest_overlap =
    1;  // of a point behind a face; deeper points belong to another place [H]
constexpr double far_slid = 0.5;  // sliding after which lower nodes are found again [H]
constexpr int attempts = 3;       // to find them

/// Unit vectors normal to each other and to `n`.
std::array<Point<2>, 1> tangents_of(const Point<2>& n) { return {Point<2>{-n[1], n[0]}}; }
std::array<Point<3>, 2> tangents_of(const Point<3>& n) {
  const Column<3> normal(n[0], n[1], n[2]);
  const Column<3> first = normal.unitOrthogonal(), second = normal.cross(first);
  return {Point<3>{first[0], first[1], first[2]}, Point<3>{second[0], second[1], second[2]}};
}

/// The normal of a face with these tangents, of any length.
Point<2> normal_of(const std::array<Point<2>, 1>& t) { return {t[0][1], -t[0][0]}; }
Point<3> normal_of(const std::array<Point<3>, 2>& t) {
  const Column<3> n = column<3>(t[0]).cross(column<3>(t[1]));
  return {n[0], n[1], n[2]};
}

/// Sum over the nodes of a side of weight(k) times their present places [m].
template <class T, int D, class Side, class Weight>
Point<D> weighted_place(const Body<T, D>& body, const Side& side, Weight&& weight) {
  Point<D> sum = {};
  for (int k = 0; k < side.count; ++k) {
    const Point<D> x = body.position(side.share[k].slot);
    for (int a = 0; a < D; ++a) sum[a] += weight(k) * x[a];
  }
  return sum;
}

template <class T, int D, class Side>
Point<D> place_of(const Body<T, D>& body, const Side& side) {
  return weighted_place(body, side, [&side](int k) { return side.share[k].weight; });
}

/// Scales `v` to length 1; returns its former length.
template <int D>
double to_unit_length(Point<D>& v) {
  const double length = column<D>(v).norm();
  for (double& component : v) component /= length > 0 ? length : 1;
  return length;
}

}  // namespace

template <class T, int D>
FaceContact<T, D>::FaceContact(const Body<T, D>& body, double friction)
    : size_(body.resolution),
      friction_(friction),
      held_(undeformed::held_directions(body)),
      has_changed_(body.slots) {}

template <class T, int D>
void FaceContact<T, D>::add(const CutSurface<D>& cut, std::int32_t number) {
  const std::int32_t added = cut.stations() < 2 ? 0
                             : D == 2           ? 1
                                                : 2 * (cut.points_per_station() - 1);
  for (std::size_t p = cut.pieces().size() - added; p < cut.pieces().size(); ++p) {
    subdivide<D>(cut.corners(p), size_, [&](const std::array<Point<D>, D>& piece) {
      Point<D> normal = undeformed::area_vector<D>(piece);
      if (to_unit_length<D>(normal) == 0) return;
      waiting_.push_back({centre<D>(piece), normal, number, 0});
    });
  }
}

template <class T, int D>
void FaceContact<T, D>::follow(const CutBonds<D>& bonds) {
  std::erase_if(waiting_, [&](Waiting& waiting) {
    if (bonds.front_distance(waiting.cut, waiting.place, size_) < size_) {
      return ++waiting.tries > most_tries;
    }
    if (!bonds.is_inside(waiting.place) || !occupies_cell(waiting)) return true;
    pairs_.push_back({waiting.place, waiting.normal, tangents_of(waiting.normal), {}, {}});
    return true;
  });
}

template <class T, int D>
bool FaceContact<T, D>::occupies_cell(const Waiting& waiting) {
  std::array<std::int64_t, D + 1> key;
  for (int a = 0; a < D; ++a) {
    key[a] = static_cast<std::int64_t>(std::floor(waiting.place[a] / (cell_size * size_)));
  }
  key[D] = waiting.cut;
  std::vector<Point<D>>& normals = cells_[key];
  if (std::ranges::any_of(normals, [&](const Point<D>& n) {
        return column<D>(n).dot(column<D>(waiting.normal)) > similar;
      })) {
    return false;
  }
  normals.push_back(waiting.normal);
  return true;
}

template <class T, int D>
auto FaceContact<T, D>::opposite(const Body<T, D>& body, const Point<D>& upper, const Side& below,
                                 bool have_met) const -> std::optional<Opposite> {
  const Column<D> apart = column<D>(upper) - column<D>(place_of(body, below));
  if (apart.norm() > far_apart * size_) return std::nullopt;
  std::array<Point<D>, D - 1> tangent;
  Eigen::Matrix<double, D, D - 1> frame;
  for (int t = 0; t < D - 1; ++t) {
    tangent[t] = weighted_place(body, below, [&](int k) { return below.slope[t][k]; });
    frame.col(t) = column<D>(tangent[t]);
  }
  Opposite found{normal_of(tangent), 0, {}};
  if (to_unit_length<D>(found.normal) == 0) return std::nullopt;
  found.gap = column<D>(found.normal).dot(apart);
  if ((found.gap >= 0 && !have_met) || found.gap < -deepest_overlap * size_) return std::nullopt;
  Eigen::Map<Eigen::Matrix<double, D - 1, 1>>(found.slid.data()) =
      (frame.transpose() * frame).ldlt().solve(frame.transpose() * apart);
  return found;
}

template <class T, int D>
auto FaceContact<T, D>::faces_of(const Body<T, D>& body, const TissueMap<D>& tissue,
                                 const Pair& pair, bool have_met) const -> std::optional<Faces> {
  if (pair.above.count == 0 || pair.below.count == 0) return std::nullopt;
  const Point<D> upper = place_of(body, pair.above);
  auto found = opposite(body, upper, pair.below, have_met);
  if (!found) return std::nullopt;
  Faces faces{pair.below, {}, 0};
  MaterialPoint<D> place = pair.place;
  const auto has_slid = [&] {
    return std::any_of(found->slid.begin(), found->slid.end(),
                       [&](double s) { return std::abs(s) > far_slid * size_; });
  };
  for (int attempt = 0; attempt < attempts && has_slid(); ++attempt) {
    for (int t = 0; t < D - 1; ++t) {
      for (int a = 0; a < D; ++a) place[a] += found->slid[t] * pair.tangent[t][a];
    }
    if (!tissue.is_inside(place)) return std::nullopt;
    faces.below = side_of(body, tissue, pair, place, -1);
    found = opposite(body, upper, faces.below, have_met);
    if (faces.below.count == 0 || !found) return std::nullopt;
  }
  faces.normal = found->normal;
  faces.gap = found->gap;
  for (int t = 0; t < D - 1; ++t) {
    for (int k = 0; k < faces.below.count; ++k) {
      faces.below.share[k].weight += found->slid[t] * faces.below.slope[t][k];
    }
  }
  return faces;
}

template <class T, int D>
double FaceContact<T, D>::push(Body<T, D>& body, const Side& above, const Faces& faces,
                               double length, double drift, ContactPair& meeting) {
  const Point<D>& n = faces.normal;
  undeformed::BodyCarriers<T, D> carriers(body, body.displacement, held_);
  const auto soft_side = [&](const Side& side) {
    return undeformed::compliance<D>(carriers, side.shares(), n);
  };
  const double soft = soft_side(above) + soft_side(faces.below);
  if (soft == 0) return 0;
  Point<D> slip = undeformed::carried<T, D>(body.velocity, above.shares());
  const Point<D> lower = undeformed::carried<T, D>(body.velocity, faces.below.shares());
  for (int a = 0; a < D; ++a) slip[a] -= lower[a];
  const double approach = -column<D>(slip).dot(column<D>(n));
  for (int a = 0; a < D; ++a) slip[a] += approach * n[a];
  const bool in_middle = drift == length;
  const double pushed =
      std::max(in_middle ? -faces.gap / length : approach, -meeting.impulse * soft);
  const double back = std::max(-faces.gap, -meeting.moved * soft);
  meeting.impulse += pushed / soft;
  meeting.moved += back / soft;
  // Corrects friction that exceeds Coulomb's law for the impulse of all sweeps.
  Point<D> drag = meeting.drag;
  for (int a = 0; a < D; ++a) drag[a] += slip[a] / soft;
  const double wanted = column<D>(drag).norm(), most_drag = friction_ * meeting.impulse;
  if (wanted > most_drag) {
    for (double& component : drag) component *= most_drag / wanted;
  }
  Point<D> impulse, moved;
  for (int a = 0; a < D; ++a) {
    const double taken = drag[a] - meeting.drag[a];
    impulse[a] = pushed * n[a] / soft - taken;
    moved[a] = back * n[a] / soft - drift * taken;
  }
  meeting.drag = drag;
  undeformed::push_point<D>(carriers, above.shares(), impulse, moved);
  for (int a = 0; a < D; ++a) impulse[a] = -impulse[a], moved[a] = -moved[a];
  undeformed::push_point<D>(carriers, faces.below.shares(), impulse, moved);
  return std::max(std::abs(pushed) * length, std::abs(back));
}

template <class T, int D>
void FaceContact<T, D>::apply(Body<T, D>& body, const TissueMap<D>& tissue, double length,
                              double drift) {
  // Most faces are separate in most steps.
  meetings_.clear();
  double first = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const auto faces = faces_of(body, tissue, pairs_[i], false);
    if (!faces) continue;
    ContactPair& meeting = meetings_.emplace_back(ContactPair{i});
    first = std::max(first, push(body, pairs_[i].above, *faces, length, drift, meeting));
  }
  double change = first;
  for (int sweep = 1; sweep < most_sweeps && change > settled * first; ++sweep) {
    change = 0;
    for (ContactPair& meeting : meetings_) {
      const Pair& pair = pairs_[meeting.pair];
      const auto faces = faces_of(body, tissue, pair, true);
      if (!faces) continue;
      change = std::max(change, push(body, pair.above, *faces, length, drift, meeting));
    }
  }
}

template class FaceContact<double, 2>;
template class FaceContact<double, 3>;
template class FaceContact<float, 2>;
template class FaceContact<float, 3>;

}  // namespace pliant::point_based
