#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/lattice/mean_phi.hpp"
#include "engine/total_lagrangian/cell_moments.hpp"
#include "kernels/layout.hpp"

namespace pliant::total_lagrangian {

/// phi on every node of a box of cells, and the fractions of the cells. Keeps references to the
/// lattice and the shape.
template <int D>
class Nodes {
 public:
  static constexpr double smallest =
      0.01;  ///< fraction of a cell below which it gets no stress point

  Nodes(const Lattice<D>& lattice, const Shape& shape, const Box<3>& box)
      : lattice_(lattice), shape_(shape), has_mesh_(contains_mesh(shape)) {
    std::int64_t count = 1;
    for (int a = 0; a < D; ++a) {
      lower_[a] = lattice.cell(a, box.lower[a]) - 2;
      extent_[a] = lattice.cell(a, box.upper[a]) + 3 - lower_[a];
      count *= extent_[a];
    }
    phi_.reserve(count);
    fraction_.resize(count, unknown);
    for_each([&](const Cell<D>& cell) { phi_.push_back(on_node(lattice.node(cell))); });
    if (has_mesh_) phi_ = mean_phi<D>(phi_, extent_);
  }

  /// Moves the node of a cell to `x`.
  void move(const Cell<D>& cell, const Point<D>& x) {
    phi_[index(cell)] = on_node(x);
    moved_[index(cell)] = x;
    for (int c = 0; c < corners; ++c) {
      Cell<D> around = cell;
      for (int a = 0; a < D; ++a) around[a] -= c >> a & 1;
      if (has_cell(around)) fraction_[index(around)] = unknown;
    }
  }

  /// Takes the stress point of a cell away, until a corner moves.
  void empty(const Cell<D>& cell) { fraction_[index(cell)] = 0; }

  template <class F>
  void for_each(F&& f) const {
    Cell<D> cell;
    for (int z = 0; z < (D == 3 ? extent_[D - 1] : 1); ++z) {
      for (int y = 0; y < extent_[1]; ++y) {
        for (int x = 0; x < extent_[0]; ++x) {
          cell[D - 1] = lower_[D - 1] + z;
          cell[1] = lower_[1] + y;
          cell[0] = lower_[0] + x;
          f(cell);
        }
      }
    }
  }

  bool has_cell(const Cell<D>& cell) const {
    for (int a = 0; a < D; ++a) {
      if (cell[a] < lower_[a] || cell[a] >= lower_[a] + extent_[a] - 1) return false;
    }
    return true;
  }

  /// [h]
  double phi(const Cell<D>& cell) const { return phi_[index(cell)]; }

  /// Share of a cell inside the shape, (TL.1); 0 where the cell gets no stress point. Computed
  /// once, unless a corner moves.
  double fraction(const Cell<D>& cell) const {
    double& known = fraction_[index(cell)];
    if (known == unknown) {
      const Part part = find_part(cell);
      known = part.fraction;
      if (known > 0 && known < 1) moments_[index(cell)] = part.moment;
    }
    return known;
  }

  /// Moments of the part of a cell inside the shape, (TL.36); null for whole and empty cells.
  const CellMoments<D>* moments(const Cell<D>& cell) const {
    const double share = fraction(cell);
    return share > 0 && share < 1 ? &moments_.at(index(cell)) : nullptr;
  }

  const Cell<D>& lower() const { return lower_; }
  Cell<D> upper() const {
    Cell<D> cell = lower_;
    for (int a = 0; a < D; ++a) cell[a] += extent_[a] - 1;
    return cell;
  }

 private:
  static constexpr int corners = 1 << D;

  struct Part {
    double fraction = 0;
    CellMoments<D> moment = moments_of_whole_cell<D>;
  };

  static constexpr int sub_cells = 10;        // along a side of a cell that the surface cuts
  static constexpr double on_surface = 1e-9;  // [h] rounding errors of distances
  // Half a sub-cell plus half its diagonal [h]: if abs(phi) in the middle of 2^D sub-cells is at
  // least this, the surface cuts none of them.
  static constexpr double far = (0.5 + 0.87) / sub_cells;
  static constexpr double never_far = std::numeric_limits<double>::infinity();
  static constexpr double unknown = -1;  // fraction

  Part find_part(const Cell<D>& cell) const {
    std::array<double, corners> corner;
    for (int c = 0; c < corners; ++c) corner[c] = phi(at_corner(cell, c));
    const auto [least, most] = std::minmax_element(corner.begin(), corner.end());
    if (*most <= 0) return {.fraction = 1};
    if (*least >= 0) return {};
    Part part;
    if (has_mesh_) {
      part = part_inside([&](const Point<D>& s) { return between(corner, s); }, never_far);
    } else if (is_moved(cell)) {
      const auto places = places_of_corners(cell);
      part = part_inside([&](const Point<D>& s) { return phi_at(within(places, s)); }, never_far);
    } else {
      part = part_inside([&](const Point<D>& s) { return phi_at(on_lattice(cell, s)); }, far);
    }
    return part.fraction < smallest ? Part{} : part;
  }

  double phi_at(const Point<D>& x) const {
    return signed_distance(shape_, padded<D>(x), D) / lattice_.spacing;
  }

  // Nodes on the surface always count as inside: edges of the body stay sharp.
  double on_node(const Point<D>& x) const {
    const double phi = phi_at(x);
    return std::abs(phi) < on_surface ? -on_surface : phi;
  }

  static Cell<D> at_corner(Cell<D> cell, int c) {
    for (int a = 0; a < D; ++a) cell[a] += c >> a & 1;
    return cell;
  }

  // Weight of a corner at the place `s` in [0, 1]^D of a cell.
  static double weight(const Point<D>& s, int c) {
    double weight = 1;
    for (int a = 0; a < D; ++a) weight *= c >> a & 1 ? s[a] : 1 - s[a];
    return weight;
  }

  std::array<Point<D>, corners> places_of_corners(const Cell<D>& cell) const {
    std::array<Point<D>, corners> places;
    for (int c = 0; c < corners; ++c) {
      const Cell<D> at = at_corner(cell, c);
      const auto moved = moved_.find(index(at));
      places[c] = moved == moved_.end() ? lattice_.node(at) : moved->second;
    }
    return places;
  }

  static Point<D> within(const std::array<Point<D>, corners>& places, const Point<D>& s) {
    Point<D> x = {};
    for (int c = 0; c < corners; ++c) {
      const double share = weight(s, c);
      for (int a = 0; a < D; ++a) x[a] += share * places[c][a];
    }
    return x;
  }

  bool is_moved(const Cell<D>& cell) const {
    for (int c = 0; c < corners && !moved_.empty(); ++c) {
      if (moved_.count(index(at_corner(cell, c))) > 0) return true;
    }
    return false;
  }

  Point<D> on_lattice(const Cell<D>& cell, const Point<D>& s) const {
    Point<D> x = lattice_.node(cell);
    for (int a = 0; a < D; ++a) x[a] += s[a] * lattice_.spacing;
    return x;
  }

  // phi interpolated between the corners, for meshes.
  static double between(const std::array<double, corners>& corner, const Point<D>& s) {
    double value = 0;
    for (int c = 0; c < corners; ++c) value += weight(s, c) * corner[c];
    return value;
  }

  // The mean of clamp(1/2 - 10 phi/h, 0, 1) over the sub-cells. A group of 2^D sub-cells counts as
  // one where abs(phi) in its middle is at least `far_off`.
  template <class Phi>
  static Part part_inside(Phi&& phi, double far_off) {
    constexpr int groups = sub_cells / 2;
    CellMoments<D> sum = {};
    for (int g = 0; g < kernels::power(groups, D); ++g) {
      Point<D> middle;
      for (int a = 0, rest = g; a < D; ++a, rest /= groups) {
        middle[a] = (rest % groups + 0.5) / groups;
      }
      if (far_off < never_far) {
        const double distance = phi(middle);
        if (std::abs(distance) >= far_off) {
          if (distance < 0) add(middle, corners, sum);
          continue;
        }
      }
      for (int k = 0; k < corners; ++k) {
        Point<D> s = middle;
        for (int a = 0; a < D; ++a) s[a] += ((k >> a & 1) - 0.5) / sub_cells;
        add(s, std::clamp(0.5 - sub_cells * phi(s), 0.0, 1.0), sum);
      }
    }
    if (sum[0] == 0) return {};
    Part part = {sum[0] / kernels::power(sub_cells, D), sum};
    for (double& moment : part.moment) moment /= sum[0];
    return part;
  }

  static void add(const Point<D>& s, double share, CellMoments<D>& sum) {
    if (share == 0) return;
    CellMoments<D> product = {share};
    sum[0] += share;
    for (int m = 1; m < corners; ++m) {
      const int lowest = std::countr_zero(static_cast<unsigned>(m));
      product[m] = product[m & (m - 1)] * (2 * s[lowest] - 1);
      sum[m] += product[m];
    }
  }

  std::int64_t index(const Cell<D>& cell) const {
    std::int64_t at = 0;
    for (int a = D - 1; a >= 0; --a) at = at * extent_[a] + (cell[a] - lower_[a]);
    return at;
  }

  const Lattice<D>& lattice_;
  const Shape& shape_;
  bool has_mesh_;
  Cell<D> lower_, extent_;
  std::vector<double> phi_;
  mutable std::vector<double> fraction_;                    ///< [index] of cells
  mutable std::map<std::int64_t, CellMoments<D>> moments_;  ///< [index] of cells that are cut
  std::map<std::int64_t, Point<D>> moved_;                  ///< [index]
};

}  // namespace pliant::total_lagrangian
