#include "engine/point_based/cutting/body_cuts.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/case/blade_track.hpp"
#include "engine/point_based/forces/node_gradient.hpp"
#include "engine/point_based/forces/node_groups.hpp"
#include "engine/point_based/forces/node_state.hpp"

namespace pliant::point_based {

namespace {

constexpr double relaxed = 1e-6;            // of D - I: no more relaxation
constexpr double longest_step = 0.1;        // share of the way from D to I
constexpr int halvings = 6;                 // of that step, before the node waits for the next step
constexpr double straight_over_way = 1e-6;  // deviation over length below which a path is straight

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

template <class T, int D>
Matrix<D> kept_gradient(const Body<T, D>& body, std::int64_t slot) {
  Matrix<D> kept;
  for (int c = 0; c < D * D; ++c) kept(c / D, c % D) = body.kept_gradient[c][slot];
  return kept;
}

template <class T, int D>
void keep(const Matrix<D>& kept, std::int64_t slot, Body<T, D>& body) {
  for (int c = 0; c < D * D; ++c) body.kept_gradient[c][slot] = static_cast<T>(kept(c / D, c % D));
}

template <int D>
Matrix<D> matrix(const std::array<double, D * D>& f) {
  return Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(f.data());
}

template <class T, int D>
double energy_of(const Body<T, D>& body, const Matrix<D>& gradient) {
  std::array<double, D * D> f;
  Eigen::Map<Eigen::Matrix<double, D, D, Eigen::RowMajor>>(f.data()) = gradient;
  return strain_energy_density<T, D>(body, f);
}

}  // namespace

template <class T, int D>
bool BodyCuts<T, D>::is_relaxing(const Body<T, D>& body, std::int64_t slot) {
  return kept_gradient(body, slot) != Matrix<D>::Identity();
}

template <class T, int D>
void BodyCuts<T, D>::find_edge(const CutCase& source, double time, Station& edge) {
  const BladeEdge place = edge_of(source, time);
  edge.resize(D - 1);
  std::copy_n(place.from.begin(), D, edge.front().begin());
  if constexpr (D == 3) edge.back() = place.to;
}

template <class T, int D>
auto BodyCuts<T, D>::blade_of(std::size_t cut) -> Blade& {
  return *std::find_if(blades_.begin(), blades_.end(),
                       [cut](const Blade& blade) { return blade.number == cut; });
}

template <class T, int D>
void BodyCuts<T, D>::put_blade(std::size_t cut, const Point<D>& from, const Point<D>& to,
                               const Body<T, D>& body) {
  Blade& blade = blade_of(cut);
  blade.puncture.reset();
  if (!std::exchange(blade.is_put, true)) end_cut(blade);
  std::size_t points = blade.cut < 0 ? 0 : blade.station.size();
  if (points == 0 && D == 2) points = 1;
  if (points == 0) {
    double square = 0;
    for (int a = 0; a < D; ++a) square += (to[a] - from[a]) * (to[a] - from[a]);
    points =
        1 + static_cast<std::size_t>(std::max(1., std::ceil(std::sqrt(square) / body.resolution)));
  }
  blade.target.clear();
  for (std::size_t k = 0; k < points; ++k) {
    Point<D> x = from;
    const double share = points > 1 ? static_cast<double>(k) / static_cast<double>(points - 1) : 0;
    for (int a = 0; a < D; ++a) x[a] += share * (to[a] - from[a]);
    blade.target.push_back(tissue_at<T, D>(body, bonds_.cuts(), x));
  }
}

template <class T, int D>
void BodyCuts<T, D>::lift_blade(std::size_t cut) {
  Blade& blade = blade_of(cut);
  blade.puncture.reset();
  blade.is_put = true;
  blade.target.clear();
  end_cut(blade);
}

template <class T, int D>
void BodyCuts<T, D>::end_cut(Blade& blade) {
  if (blade.cut < 0) return;
  blade.cut = -1;
  moves_.blade.push_back(&blade - blades_.data());
  moves_.points.push_back(0);
  moves_.time.push_back(moves_.time.back());
}

template <class T, int D>
void BodyCuts<T, D>::move_blade(std::size_t b, const Station& station, double time) {
  Blade& blade = blades_[b];
  if (tissue_) resist(blade, station, time);
  if (blade.cut < 0) blade.cut = bonds_.add_cut();
  blade.station = station;
  blade.followed = time;
  moves_.blade.push_back(static_cast<std::int64_t>(b));
  moves_.points.push_back(static_cast<std::int64_t>(station.size()));
  for (const MaterialPoint<D>& x : station) {
    moves_.place.insert(moves_.place.end(), x.begin(), x.end());
  }
  moves_.time.push_back(time);
  if (!has_moved_) bonds_.begin_moves();
  has_moved_ = true;
  bonds_.move(blade.cut, blade.station);
  if (faces_) faces_->add(bonds_.cuts()[blade.cut], blade.cut);
}

template <class T, int D>
double BodyCuts<T, D>::way_to(const Blade& blade, const Station& edge) {
  double farthest = 0;
  for (std::size_t k = 0; k < edge.size(); ++k) {
    double square = 0;
    for (int a = 0; a < D; ++a) {
      square += (edge[k][a] - blade.station[k][a]) * (edge[k][a] - blade.station[k][a]);
    }
    farthest = std::max(farthest, std::sqrt(square));
  }
  return farthest;
}

template <class T, int D>
void BodyCuts<T, D>::move_by_case(std::size_t b, double time) {
  Blade& blade = blades_[b];
  if (blade.is_done || time < blade.source.start) return;
  const bool ends = time >= blade.source.end;
  const double until = std::min(time, blade.source.end);
  find_edge(blade.source, until, edge_);
  if (blade.puncture && !enters(b, time)) {
    blade.is_done = ends;
    return;
  }
  if (blade.cut >= 0 && !ends && way_to(blade, edge_) < least_advance_) return;
  follow_path(b, until, time);
  blade.is_done = ends;
}

// A fast blade passes several nodes in a step. If its path is straight, one piece of the cut
// suffices for them.
template <class T, int D>
void BodyCuts<T, D>::follow_path(std::size_t b, double until, double time) {
  Blade& blade = blades_[b];
  const double from = blade.cut < 0 ? blade.source.start : blade.followed;
  if (blade.cut < 0 && from < until) {
    find_edge(blade.source, from, next_edge_);
    move_blade(b, next_edge_, time);
  }
  const double way = blade.cut < 0 ? 0 : way_to(blade, edge_);
  const int parts = std::max(1, static_cast<int>(std::ceil(way / longest_advance_)));
  const Station before = blade.station;
  double bend = 0;
  std::vector<Station> between(parts - 1);
  for (int k = 1; k < parts; ++k) {
    Station& edge = between[k - 1];
    const double share = static_cast<double>(k) / parts;
    find_edge(blade.source, from + (until - from) * share, edge);
    for (std::size_t p = 0; p < edge.size(); ++p) {
      for (int a = 0; a < D; ++a) {
        const double straight = before[p][a] + share * (edge_[p][a] - before[p][a]);
        bend = std::max(bend, std::abs(edge[p][a] - straight));
      }
    }
  }
  for (const Station& edge : between) {
    if (bend > straight_over_way * way) move_blade(b, edge, time);
  }
  move_blade(b, edge_, time);
}

template <class T, int D>
void BodyCuts<T, D>::move_by_caller(std::size_t b, double time) {
  Blade& blade = blades_[b];
  if (blade.target.empty()) return;
  if (blade.cut >= 0 && way_to(blade, blade.target) < least_advance_) return;
  move_blade(b, blade.target, time);
  blade.target.clear();
}

template <class T, int D>
bool BodyCuts<T, D>::move(double time) {
  has_moved_ = false;
  for (std::size_t b = 0; b < blades_.size(); ++b) {
    if (blades_[b].is_put) {
      move_by_caller(b, time);
    } else {
      move_by_case(b, time);
    }
  }
  if (faces_ && has_moved_) faces_->follow(bonds_);
  return has_moved_;
}

template <class T, int D>
void BodyCuts<T, D>::update(int block, Body<T, D>& body) {
  BlockCuts& cuts = blocks_[block];
  relax(cuts, body);
  if (!has_moved_) return;
  const std::vector<std::int32_t>& changed = bonds_.update(static_cast<std::size_t>(block));
  for (const std::int32_t slot : changed) {
    if (!keeps_bonds_of(slot)) cuts.added += dissolve_group_gently(slot, body, cuts.relaxing);
    change_bonds_of(slot, cuts, body);
    if (is_relaxing(body, slot)) cuts.relaxing.push_back(slot);
  }
  std::sort(cuts.relaxing.begin(), cuts.relaxing.end());
  cuts.relaxing.erase(std::unique(cuts.relaxing.begin(), cuts.relaxing.end()), cuts.relaxing.end());
}

template <class T, int D>
double BodyCuts<T, D>::fold() {
  double added = 0;
  for (BlockCuts& cuts : blocks_) added += std::exchange(cuts.added, 0);
  return added;
}

template <class T, int D>
void BodyCuts<T, D>::change_bonds_of(std::int32_t slot, BlockCuts& cuts, Body<T, D>& body) {
  constexpr double least_volume_ratio = 0.05;
  const NodeBlock& block = body.block_of(slot);
  const NodeFit<D> before = node_fit(body, block, slot);
  const auto gradient = with_kept(body, slot, before.gradient);
  cuts.added -= before.stabilisation + strain_energy(body, block, slot, gradient);
  set_bonds_of(slot, body);
  keep<T, D>(Matrix<D>::Identity(), slot, body);
  const NodeFit<D> after = node_fit(body, block, slot);
  const Matrix<D> fit = matrix<D>(after.gradient);
  if (body.volume[slot] > 0 && fit.determinant() > least_volume_ratio) {
    keep<T, D>(fit.inverse() * matrix<D>(gradient), slot, body);
  }
  cuts.added +=
      after.stabilisation + strain_energy(body, block, slot, with_kept(body, slot, after.gradient));
}

// Like set_bonds, considers the neighbours and the next candidate, which may set the support.
template <class T, int D>
bool BodyCuts<T, D>::keeps_bonds_of(std::int32_t slot) const {
  const std::int64_t first = bonds_.bonds().first[slot];
  const std::int64_t end = std::min(bonds_.bonds().first[slot + 1], first + choice_.neighbours + 1);
  const auto factors = bonds_.factors().subspan(first, end - first);
  return std::ranges::all_of(factors, [](double factor) { return factor == 1; });
}

template <class T, int D>
void BodyCuts<T, D>::set_bonds_of(std::int32_t slot, Body<T, D>& body) {
  const std::int64_t first = bonds_.bonds().first[slot], end = bonds_.bonds().first[slot + 1];
  set_bonds(choice_, bonds_.factors().subspan(first, end - first), slot, body);
}

// Takes as large a step towards I as does not raise the present energy.
template <class T, int D>
void BodyCuts<T, D>::relax(BlockCuts& cuts, Body<T, D>& body) {
  const Matrix<D> identity = Matrix<D>::Identity();
  for (const std::int32_t slot : cuts.relaxing) {
    const Matrix<D> kept = kept_gradient(body, slot);
    const Matrix<D> fit = matrix<D>(fitted_gradient(body, body.block_of(slot), slot));
    const double energy = energy_of<T, D>(body, fit * kept);
    double step = (kept - identity).cwiseAbs().maxCoeff() < relaxed ? 1 : longest_step;
    for (int i = 0; i < halvings; ++i, step /= 2) {
      const Matrix<D> next = kept + step * (identity - kept);
      const double relaxed_energy = energy_of<T, D>(body, fit * next);
      if (relaxed_energy > energy) continue;
      cuts.added += body.volume[slot] * (relaxed_energy - energy);
      keep<T, D>(next, slot, body);
      break;
    }
  }
  std::erase_if(cuts.relaxing, [&](std::int32_t slot) { return !is_relaxing(body, slot); });
}

template class BodyCuts<double, 2>;
template class BodyCuts<double, 3>;
template class BodyCuts<float, 2>;
template class BodyCuts<float, 3>;

}  // namespace pliant::point_based
