#pragma once

#include <array>
#include <cmath>
#include <numeric>

#include "engine/case/case.hpp"
#include "engine/remeshed/observe/covered_cells.hpp"

namespace pliant::remeshed {

/// Integral of a linear field, from the moments of the region.
template <int D>
double integral(double value, const Point<D>& slope, double zeroth, const Point<D>& first) {
  return std::inner_product(slope.begin(), slope.end(), first.begin(), value * zeroth);
}

/// Inertial density and velocity of a node, and their central differences [per cell].
template <int D>
struct NodeMotion {
  double density = 0;
  Point<D> velocity = {};
  Point<D> density_slope = {};
  std::array<Point<D>, D> velocity_slope = {};  ///< [direction][component]

  template <class T>
  NodeMotion(const FieldStore<T, D>& f, const CoveredCells<T, D>& cells, std::int64_t p,
             const Cell<D>& cell)
      : density(density_at(f, p)) {
    for (int c = 0; c < D; ++c) velocity[c] = f.get(Field::velocity, c)[p];
    cells.for_each_pair(cell, [&](int a, std::int64_t up, std::int64_t down) {
      density_slope[a] = (density_at(f, up) - density_at(f, down)) / 2;
      for (int c = 0; c < D; ++c) {
        const T* u = f.get(Field::velocity, c);
        velocity_slope[a][c] = (u[up] - u[down]) / 2;
      }
    });
  }

 private:
  template <class T>
  static double density_at(const FieldStore<T, D>& f, std::int64_t p) {
    return static_cast<double>(f.get(Field::mass)[p]) / f.get(Field::volume)[p];
  }
};

/// Integrals of the inertia and the motion of a body, relative to one point, (RP.42), (RP.70).
struct MotionIntegrals {
  double mass = 0;
  Vector first_moment = {};
  std::array<Vector, 3> second_moment = {};
  Vector momentum = {};
  Vector angular_momentum = {};  ///< in 2D z only
  double kinetic_energy = 0;

  /// Adds a cell of size h whose node is at r [m]. Density and velocity are linear in the cell, so
  /// moments integrate them exactly.
  template <int D>
  void add(double h, const Point<D>& r_of_node, const NodeMotion<D>& e, const Moments<D>& m) {
    const double volume = std::pow(h, D);
    const double mass_of_cell = integral<D>(e.density, e.density_slope, m.zeroth, m.first);
    double energy = 0;
    Vector r = {}, moment = {}, impulse = {};
    std::array<Vector, 3> spread = {};  // sums of s_a times the momentum c: [a][c]
    std::array<Point<D>, D> inertia = {};
    for (int a = 0; a < D; ++a) {
      r[a] = r_of_node[a];
      moment[a] = integral<D>(e.density, e.density_slope, m.first[a], m.second[a]);
      for (int b = 0; b < D; ++b) {
        inertia[a][b] = integral<D>(e.density, e.density_slope, m.second[a][b], m.third[a][b]);
      }
    }
    for (int c = 0; c < D; ++c) {
      impulse[c] = mass_of_cell * e.velocity[c];
      for (int a = 0; a < D; ++a) {
        impulse[c] += e.velocity_slope[a][c] * moment[a];
        spread[a][c] = moment[a] * e.velocity[c];
        for (int b = 0; b < D; ++b) spread[a][c] += e.velocity_slope[b][c] * inertia[a][b];
        energy += 0.5 * e.velocity_slope[a][c] * spread[a][c];
      }
      energy += 0.5 * e.velocity[c] * impulse[c];
    }
    mass += volume * mass_of_cell;
    kinetic_energy += volume * energy;
    for (int c = 0; c < 3; ++c) {
      const int a = (c + 1) % 3, b = (c + 2) % 3;
      first_moment[c] += volume * (mass_of_cell * r[c] + h * moment[c]);
      momentum[c] += volume * impulse[c];
      angular_momentum[c] +=
          volume * (r[a] * impulse[b] - r[b] * impulse[a] + h * (spread[a][b] - spread[b][a]));
    }
    for (int a = 0; a < D; ++a) {
      for (int b = 0; b < D; ++b) {
        second_moment[a][b] +=
            volume * (mass_of_cell * r[a] * r[b] + h * (r[a] * moment[b] + moment[a] * r[b]) +
                      h * h * inertia[a][b]);
      }
    }
  }
};

}  // namespace pliant::remeshed
