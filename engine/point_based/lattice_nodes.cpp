#include "engine/point_based/lattice_nodes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "engine/geometry/distance_walk.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/point_based/nearest_nodes.hpp"
#include "kernels/layout.hpp"

namespace pliant::point_based {

namespace {

constexpr int sub_cells = 10;             // to a side, of a cell that the surface cuts
constexpr double on_surface = 1e-9;       // [h] distances that rounding may leave
constexpr double smallest_volume = 0.02;  // of a cell, of a node of its own

template <int D>
class Sampling {
 public:
  static constexpr int corners = 1 << D;

  Sampling(const Shape& shape, double spacing)
      : shape_(shape),
        spacing_(spacing),
        has_mesh_(contains_mesh(shape)),
        pitch_(lattice_pitch<D>(shape, spacing)) {
    const Box<3> box = bounding_box(shape);
    std::int64_t count = 1;
    for (int a = 0; a < D; ++a) {
      const auto cells =
          static_cast<std::int32_t>(std::round((box.upper[a] - box.lower[a]) / pitch_[a]));
      // One more layer on each side, where volumes find no lattice point inside.
      start_[a] = box.lower[a] - pitch_[a];
      extent_[a] = cells + 3;
      stride_[a] = count;
      count *= extent_[a];
    }
    phi_.reserve(count);
    DistanceWalk distance(shape, D, 2 * spacing);
    for_each_cell<D>({}, last(0), [&](const Cell<D>& cell) {
      const double phi = distance(padded<D>(at(cell))) / spacing;
      // Points on the surface count as inside, always: edges of the body stay sharp.
      phi_.push_back(std::abs(phi) < on_surface ? 0 : phi);
    });
    volume_.assign(count, 0);
  }

  NodeCloud<D> cloud() {
    for_each_cell<D>({}, last(1), [&](const Cell<D>& cell) { share_out(cell); });
    NodeCloud<D> cloud;
    for_each_cell<D>({}, last(0), [&](const Cell<D>& cell) {
      const double volume = volume_[index(cell)];
      if (volume >= smallest_volume) {
        cloud.positions.push_back(at(cell));
        cloud.volumes.push_back(volume);
      } else if (volume > 0) {
        strays_.push_back({at(cell), volume});
      }
    });
    if (cloud.positions.empty()) return {};
    const NearestNodes<D> nearest(cloud.positions);
    for (const auto& [x, volume] : strays_) cloud.volumes[nearest.nearest(x)] += volume;
    for (double& volume : cloud.volumes) {
      for (const double pitch : pitch_) volume *= pitch;
    }
    return cloud;
  }

 private:
  Cell<D> last(int less) const {
    Cell<D> cell;
    for (int a = 0; a < D; ++a) cell[a] = extent_[a] - 1 - less;
    return cell;
  }
  std::int64_t index(const Cell<D>& cell) const {
    std::int64_t sum = 0;
    for (int a = 0; a < D; ++a) sum += stride_[a] * cell[a];
    return sum;
  }
  Point<D> at(const Cell<D>& cell) const {
    Point<D> x;
    for (int a = 0; a < D; ++a) x[a] = start_[a] + cell[a] * pitch_[a];
    return x;
  }
  std::int64_t corner(const Cell<D>& cell, int c) const {
    std::int64_t sum = index(cell);
    for (int a = 0; a < D; ++a) sum += (c >> a & 1) * stride_[a];
    return sum;
  }

  /// [corner] what the body fills of the part of a cell that is nearest to each corner, as a share
  /// of it.
  std::array<double, corners> parts(const Cell<D>& cell) const {
    std::array<double, corners> phi, part = {};
    for (int c = 0; c < corners; ++c) phi[c] = phi_[corner(cell, c)];
    const auto [least, most] = std::minmax_element(phi.begin(), phi.end());
    if (*least >= 0) return part;
    if (*most <= 0) {
      part.fill(1.0 / corners);
      return part;
    }
    const int count = kernels::power(sub_cells, D);
    for (int k = 0; k < count; ++k) {
      Point<D> s;
      int nearest = 0;
      for (int a = 0, rest = k; a < D; ++a, rest /= sub_cells) {
        s[a] = (rest % sub_cells + 0.5) / sub_cells;
        if (2 * s[a] > 1) nearest |= 1 << a;
      }
      const double value = has_mesh_ ? between(phi, s) : distance(cell, s);
      part[nearest] += std::clamp(0.5 - sub_cells * value, 0.0, 1.0) / count;
    }
    return part;
  }

  /// phi at the place `s` in [0, 1]^D of a cell [h]: of the shape itself, which is exact at
  /// edges...
  double distance(const Cell<D>& cell, const Point<D>& s) const {
    Point<D> x = at(cell);
    for (int a = 0; a < D; ++a) x[a] += s[a] * pitch_[a];
    return signed_distance(shape_, padded<D>(x), D) / spacing_;
  }
  /// ... or linear between the corners, for meshes, whose distances take long.
  double between(const std::array<double, corners>& phi, const Point<D>& s) const {
    double value = 0;
    for (int c = 0; c < corners; ++c) {
      double weight = 1;
      for (int a = 0; a < D; ++a) weight *= c >> a & 1 ? s[a] : 1 - s[a];
      value += weight * phi[c];
    }
    return value;
  }

  void share_out(const Cell<D>& cell) {
    const auto part = parts(cell);
    for (int c = 0; c < corners; ++c) {
      if (part[c] == 0) continue;
      int distance = D + 1, takers = 0;
      for (int other = 0; other < corners; ++other) {
        if (phi_[corner(cell, other)] > 0) continue;
        const int away = std::popcount(static_cast<unsigned>(c ^ other));
        takers = away < distance ? 1 : takers + (away == distance ? 1 : 0);
        distance = std::min(distance, away);
      }
      for (int other = 0; other < corners; ++other) {
        if (phi_[corner(cell, other)] > 0) continue;
        if (std::popcount(static_cast<unsigned>(c ^ other)) != distance) continue;
        volume_[corner(cell, other)] += part[c] / takers;
      }
    }
  }

  const Shape& shape_;
  double spacing_;  ///< h, as asked for
  bool has_mesh_;
  Point<D> pitch_, start_;
  Cell<D> extent_;
  std::array<std::int64_t, D> stride_;
  std::vector<double> phi_, volume_;                 ///< [lattice point] [h], [cell]
  std::vector<std::pair<Point<D>, double>> strays_;  ///< volumes without a node of their own
};

}  // namespace

template <int D>
Point<D> lattice_pitch(const Shape& shape, double spacing) {
  const Box<3> box = bounding_box(shape);
  Point<D> pitch;
  for (int a = 0; a < D; ++a) {
    const double side = box.upper[a] - box.lower[a];
    pitch[a] = side / std::max(1.0, std::round(side / spacing));
  }
  return pitch;
}

template <int D>
NodeCloud<D> lattice_nodes(const Shape& shape, double spacing) {
  return Sampling<D>(shape, spacing).cloud();
}

template Point<2> lattice_pitch<2>(const Shape&, double);
template Point<3> lattice_pitch<3>(const Shape&, double);
template NodeCloud<2> lattice_nodes<2>(const Shape&, double);
template NodeCloud<3> lattice_nodes<3>(const Shape&, double);

}  // namespace pliant::point_based
