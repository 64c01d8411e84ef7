#include "engine/point_based/body_cuts.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/point_based/node_state.hpp"
#include "engine/point_based/surface.hpp"

namespace pliant::point_based {

namespace {

constexpr double advance_over_resolution = 0.125;  // a blade moves on by this at a time
constexpr double inside_over_resolution = 1e-6;
constexpr double relaxed = 1e-6;      // of D - I
constexpr double longest_step = 0.1;  // of the way from D to I
constexpr int halvings = 6;           // of that step before a node waits for the next

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

template <class T, int D>
bool is_relaxing(const Body<T, D>& body, std::int64_t slot) {
  return kept_gradient(body, slot) != Matrix<D>::Identity();
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

/// Bonds to all candidates, in the numbers of slots.
template <class T, int D>
BondRows rows_of(const BondChoice<D>& choice, const Body<T, D>& body) {
  BondRows rows;
  rows.first = {0};
  for (std::int64_t slot = 0; slot < body.slots; ++slot) {
    if (body.number[slot] >= 0) {
      for (const auto& candidate : choice.candidates[body.number[slot]]) {
        rows.neighbour.push_back(static_cast<std::int32_t>(choice.slot_of[candidate.node]));
      }
    }
    rows.first.push_back(static_cast<std::int64_t>(rows.neighbour.size()));
  }
  return rows;
}

template <class T, int D>
std::vector<double> sizes_of(const Body<T, D>& body) {
  std::vector<double> sizes(body.slots, body.resolution);
  body.for_each_node([&](std::int64_t slot) {
    sizes[slot] = std::pow(body.mass[slot] / body.material.density, 1. / D);
  });
  return sizes;
}

}  // namespace

template <class T, int D>
BodyCuts<T, D>::BodyCuts(const Case& settings, int body_number, BondChoice<D> choice,
                         const Body<T, D>& body)
    : choice_(std::move(choice)),
      least_advance_(advance_over_resolution * body.resolution),
      bonds_(body.start, sizes_of(body), rows_of(choice_, body),
             static_cast<CutRule>(settings.point_based.cut_rule),
             inside_of<D>(body.source->geometry, inside_over_resolution * body.resolution)) {
  for (const CutCase& cut : settings.cuts) {
    if (cut.body == body_number) blades_.push_back({cut, -1, {}, false});
  }
}

template <class T, int D>
std::vector<MaterialPoint<D>> BodyCuts<T, D>::edge_at(const CutCase& source, double time) const {
  MaterialPoint<D> from, to;
  for (int a = 0; a < D; ++a) {
    const double moved = source.path[a](time);
    from[a] = source.from[a] + moved;
    to[a] = source.to[a] + moved;
  }
  if constexpr (D == 2) return {from};
  return {from, to};
}

template <class T, int D>
const std::vector<std::int32_t>& BodyCuts<T, D>::move(std::size_t b, double time) {
  Blade& blade = blades_[b];
  if (blade.cut < 0) blade.cut = bonds_.add_cut();
  blade.station = edge_at(blade.source, time);
  blade.is_done = time >= blade.source.end;
  moved_blade_.push_back(static_cast<std::int64_t>(b));
  moved_time_.push_back(time);
  return bonds_.advance(blade.cut, blade.station);
}

template <class T, int D>
double BodyCuts<T, D>::advance(double time, Body<T, D>& body) {
  double added = 0;
  for (std::size_t b = 0; b < blades_.size(); ++b) {
    const Blade& blade = blades_[b];
    if (blade.is_done || time < blade.source.start) continue;
    const double at = std::min(time, blade.source.end);
    if (blade.cut >= 0 && at < blade.source.end) {
      const auto edge = edge_at(blade.source, at);
      double farthest = 0;
      for (std::size_t k = 0; k < edge.size(); ++k) {
        double square = 0;
        for (int a = 0; a < D; ++a) {
          square += (edge[k][a] - blade.station[k][a]) * (edge[k][a] - blade.station[k][a]);
        }
        farthest = std::max(farthest, std::sqrt(square));
      }
      if (farthest < least_advance_) continue;
    }
    for (const std::int32_t slot : move(b, at)) {
      added += change_bonds_of(slot, body);
      if (is_relaxing(body, slot)) relaxing_.push_back(slot);
    }
  }
  std::sort(relaxing_.begin(), relaxing_.end());
  relaxing_.erase(std::unique(relaxing_.begin(), relaxing_.end()), relaxing_.end());
  return added;
}

template <class T, int D>
double BodyCuts<T, D>::change_bonds_of(std::int32_t slot, Body<T, D>& body) {
  constexpr double least_volume_ratio = 0.05;
  const NodeBlock& block = body.block_of(slot);
  const NodeState<D> before = node_state(body, block, slot);
  set_bonds_of(slot, body);
  keep<T, D>(Matrix<D>::Identity(), slot, body);
  const Matrix<D> fit = matrix<D>(present_gradient(body, block, slot));
  if (body.volume[slot] > 0 && fit.determinant() > least_volume_ratio) {
    keep<T, D>(fit.inverse() * matrix<D>(before.gradient), slot, body);
  }
  return node_state(body, block, slot).energy - before.energy;
}

template <class T, int D>
void BodyCuts<T, D>::set_bonds_of(std::int32_t slot, Body<T, D>& body) {
  const std::int64_t first = bonds_.bonds().first[slot], end = bonds_.bonds().first[slot + 1];
  set_bonds(choice_, bonds_.factors().subspan(first, end - first), slot, body);
}

// Of the way to I, as much as does not raise the energy now.
template <class T, int D>
double BodyCuts<T, D>::relax(Body<T, D>& body) {
  double added = 0;
  const Matrix<D> identity = Matrix<D>::Identity();
  for (const std::int32_t slot : relaxing_) {
    const Matrix<D> kept = kept_gradient(body, slot);
    const Matrix<D> present = matrix<D>(present_gradient(body, body.block_of(slot), slot));
    const Matrix<D> fit = present * kept.inverse();
    const double energy = energy_of<T, D>(body, present);
    double step = (kept - identity).cwiseAbs().maxCoeff() < relaxed ? 1 : longest_step;
    for (int i = 0; i < halvings; ++i, step /= 2) {
      const Matrix<D> next = kept + step * (identity - kept);
      const double relaxed_energy = energy_of<T, D>(body, fit * next);
      if (relaxed_energy > energy) continue;
      added += body.volume[slot] * (relaxed_energy - energy);
      keep<T, D>(next, slot, body);
      break;
    }
  }
  std::erase_if(relaxing_, [&](std::int32_t slot) { return !is_relaxing(body, slot); });
  return added;
}

template <class T, int D>
void BodyCuts<T, D>::put(ArchiveWriter& archive, const std::string& name) const {
  archive.put(name + "/blade", std::span<const std::int64_t>(moved_blade_));
  archive.put(name + "/time", std::span<const double>(moved_time_));
}

template <class T, int D>
void BodyCuts<T, D>::get(const ArchiveReader& archive, const std::string& name, Body<T, D>& body) {
  const auto blade = archive.get<std::int64_t>(name + "/blade");
  const auto time = archive.get<double>(name + "/time");
  std::vector<std::int32_t> changed;
  for (std::size_t i = 0; i < blade.size(); ++i) {
    const auto& nodes = move(static_cast<std::size_t>(blade[i]), time[i]);
    changed.insert(changed.end(), nodes.begin(), nodes.end());
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for (const std::int32_t slot : changed) {
    set_bonds_of(slot, body);
    if (is_relaxing(body, slot)) relaxing_.push_back(slot);
  }
}

template class BodyCuts<double, 2>;
template class BodyCuts<double, 3>;
template class BodyCuts<float, 2>;
template class BodyCuts<float, 3>;

}  // namespace pliant::point_based
