#include "engine/remeshed/observe/integrals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/remeshed/observe/point_state.hpp"

namespace pliant::remeshed {

namespace {

constexpr int sub_cells = 10;          // to a side, of a cell that the surface may cut
constexpr double coverage_slope = 10;  // (RP.42)

using Row = std::array<double, sub_cells>;

// Place of a sub-cell along an axis, in [-1/2, 1/2] cells.
constexpr double centre(int i) { return (i + 0.5) / sub_cells - 0.5; }

// Integrals of a weight, and of it times s_a, s_a s_b and s_a s_b s_c, with s in [-1/2, 1/2]^D.
template <int D>
struct Moments {
  double zeroth = 0;
  Point<D> first = {};
  std::array<Point<D>, D> second = {};
  std::array<std::array<Point<D>, D>, D> third = {};

  static Moments of_whole_cell() {
    Moments whole;
    whole.zeroth = 1;
    for (int a = 0; a < D; ++a) whole.second[a][a] = 1.0 / 12;
    return whole;
  }

  // The sub-cells of a row along the first axis; t is its place, with 1 for the first component.
  void add_row(const Row& weights, const Point<D>& t) {
    std::array<double, 4> sums = {};  // times powers of s_0
    for (int i = 0; i < sub_cells; ++i) {
      const double s = centre(i);
      sums[0] += weights[i];
      sums[1] += weights[i] * s;
      sums[2] += weights[i] * s * s;
      sums[3] += weights[i] * s * s * s;
    }
    for (double& sum : sums) sum /= kernels::power(sub_cells, D);
    zeroth += sums[0];
    for (int a = 0; a < D; ++a) {
      first[a] += t[a] * sums[a == 0];
      for (int b = 0; b < D; ++b) {
        second[a][b] += t[a] * t[b] * sums[(a == 0) + (b == 0)];
        for (int c = 0; c < D; ++c) {
          third[a][b][c] += t[a] * t[b] * t[c] * sums[(a == 0) + (b == 0) + (c == 0)];
        }
      }
    }
  }
};

// Values of one node and their central differences [per cell].
template <int D>
struct Expansion {
  double density, energy;
  Point<D> velocity;
  Point<D> density_slope = {}, energy_slope = {};
  std::array<Point<D>, D> velocity_slope = {};  // [direction][component]
  double phi = 0;                               // [h]
  Point<D> phi_slope = {};
  std::array<Point<D>, D> phi_curvature = {};
};

// Of a linear field times what the moments are of.
template <int D>
double integral(double value, const Point<D>& slope, double zeroth, const Point<D>& first) {
  return std::inner_product(slope.begin(), slope.end(), first.begin(), value * zeroth);
}

template <class T, int D>
class Integrator {
 public:
  Integrator(const LatticeView<T, D>& view, const Boundaries<D>& boundaries, const Vector& about)
      : view_(view), boundaries_(boundaries), about_(about), h_(view.body.lattice.spacing) {}

  BodyIntegrals operator()() {
    const Layout<D>& layout = view_.population.layout;
    const T* phi = view_.fields.get(Field::level_set);
    const double reach = 0.5 * std::sqrt(static_cast<double>(D)) + 0.2;
    for (const Block<D>& block : layout.blocks()) {
      layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
        if (view_.population.kind[p] == Kind::vacant || !view_.body.lattice.is_wrapped(cell))
          return;
        const double distance = phi[p] / h_;
        if (distance > reach) return;
        const Point<D> x = view_.body.lattice.node(cell);
        const double wall = distance_to_walls(x) / h_;
        if (wall < -reach) return;
        const Expansion<D> e = expand(p, cell);
        const bool is_whole = distance < -reach && wall > reach;
        add(x, e, is_whole ? whole_ : covered(x, e, wall < reach));
      });
    }
    return sum_;
  }

 private:
  double distance_to_walls(const Point<D>& x) const {
    return std::min(boundaries_.nearest_wall(x).second, boundaries_.nearest_contact(x).second);
  }

  std::int64_t neighbour(Cell<D> cell, int axis, int step) const {
    cell[axis] += step;
    return view_.population.layout.slot(view_.body.lattice.wrapped(cell));
  }

  bool holds_particle(std::int64_t p) const {
    return p >= 0 && view_.population.kind[p] != Kind::vacant;
  }

  Expansion<D> expand(std::int64_t p, const Cell<D>& cell) const {
    const FieldStore<T, D>& f = view_.fields;
    const T* phi = f.get(Field::level_set);
    Expansion<D> e;
    e.density = density<T, D>(f, p);
    e.energy = energy_density<T, D>(view_.body, f, p);
    for (int c = 0; c < D; ++c) e.velocity[c] = f.get(Field::velocity, c)[p];
    e.phi = phi[p] / h_;
    for (int a = 0; a < D; ++a) {
      const std::int64_t up = neighbour(cell, a, 1), down = neighbour(cell, a, -1);
      if (up < 0 || down < 0) continue;
      e.phi_slope[a] = (phi[up] - phi[down]) / (2 * h_);
      e.phi_curvature[a][a] = (phi[up] - 2 * phi[p] + phi[down]) / h_;
      if (holds_particle(up) && holds_particle(down)) add_slopes(e, a, up, down);
      for (int b = a + 1; b < D; ++b) {
        e.phi_curvature[a][b] = e.phi_curvature[b][a] = mixed(cell, a, b, phi);
      }
    }
    return e;
  }

  void add_slopes(Expansion<D>& e, int a, std::int64_t up, std::int64_t down) const {
    const FieldStore<T, D>& f = view_.fields;
    e.density_slope[a] = (density<T, D>(f, up) - density<T, D>(f, down)) / 2;
    e.energy_slope[a] =
        (energy_density<T, D>(view_.body, f, up) - energy_density<T, D>(view_.body, f, down)) / 2;
    for (int c = 0; c < D; ++c) {
      const T* u = f.get(Field::velocity, c);
      e.velocity_slope[a][c] = (u[up] - u[down]) / 2;
    }
  }

  double mixed(Cell<D> cell, int a, int b, const T* phi) const {
    double sum = 0;
    for (const int i : {-1, 1}) {
      for (const int j : {-1, 1}) {
        Cell<D> corner = cell;
        corner[a] += i;
        corner[b] += j;
        const std::int64_t q = view_.population.layout.slot(view_.body.lattice.wrapped(corner));
        if (q < 0) return 0;
        sum += i * j * phi[q];
      }
    }
    return sum / (4 * h_);
  }

  Moments<D> covered(const Point<D>& x, const Expansion<D>& e, bool is_near_wall) const {
    Moments<D> moments;
    for (int k = 0; k < kernels::power(sub_cells, D - 1); ++k) {
      Point<D> t = {1};
      for (int a = 1, rest = k; a < D; ++a, rest /= sub_cells) t[a] = centre(rest % sub_cells);
      Row row = coverage(e, t);
      if (is_near_wall) leave_out_walls(x, t, row);
      moments.add_row(row, t);
    }
    return moments;
  }

  static Row coverage(const Expansion<D>& e, const Point<D>& t) {
    double phi = e.phi, slope = e.phi_slope[0];  // at the middle of the row
    for (int a = 1; a < D; ++a) {
      phi += e.phi_slope[a] * t[a];
      slope += e.phi_curvature[0][a] * t[a];
      for (int b = 1; b < D; ++b) phi += 0.5 * e.phi_curvature[a][b] * t[a] * t[b];
    }
    Row row;
    for (int i = 0; i < sub_cells; ++i) {
      const double s = centre(i);
      const double at = phi + s * (slope + 0.5 * e.phi_curvature[0][0] * s);
      row[i] = std::clamp(0.5 - coverage_slope * at, 0.0, 1.0);
    }
    return row;
  }

  void leave_out_walls(const Point<D>& x, const Point<D>& t, Row& row) const {
    Point<D> at;
    for (int a = 1; a < D; ++a) at[a] = x[a] + h_ * t[a];
    for (int i = 0; i < sub_cells; ++i) {
      if (row[i] == 0) continue;
      at[0] = x[0] + h_ * centre(i);
      row[i] *= std::clamp(0.5 + coverage_slope * distance_to_walls(at) / h_, 0.0, 1.0);
    }
  }

  // Density, energy and velocity are linear in the cell, so that moments integrate them exactly.
  void add(const Point<D>& x, const Expansion<D>& e, const Moments<D>& m) {
    const double volume = std::pow(h_, D);
    const double mass = integral<D>(e.density, e.density_slope, m.zeroth, m.first);
    double kinetic_energy = 0;
    Vector r = {}, first_moment = {}, momentum = {};
    std::array<Vector, 3> spread = {};  // of s_a times the momentum c: [a][c]
    for (int a = 0; a < D; ++a) {
      r[a] = x[a] - about_[a];
      first_moment[a] = integral<D>(e.density, e.density_slope, m.first[a], m.second[a]);
    }
    for (int c = 0; c < D; ++c) {
      momentum[c] = mass * e.velocity[c];
      for (int a = 0; a < D; ++a) {
        momentum[c] += e.velocity_slope[a][c] * first_moment[a];
        spread[a][c] = first_moment[a] * e.velocity[c];
        for (int b = 0; b < D; ++b) {
          const double second_moment =
              integral<D>(e.density, e.density_slope, m.second[a][b], m.third[a][b]);
          spread[a][c] += e.velocity_slope[b][c] * second_moment;
        }
        kinetic_energy += 0.5 * e.velocity_slope[a][c] * spread[a][c];
      }
      kinetic_energy += 0.5 * e.velocity[c] * momentum[c];
    }
    sum_.volume += volume * m.zeroth;
    sum_.mass += volume * mass;
    sum_.strain_energy += volume * integral<D>(e.energy, e.energy_slope, m.zeroth, m.first);
    sum_.kinetic_energy += volume * kinetic_energy;
    for (int c = 0; c < 3; ++c) {
      const int a = (c + 1) % 3, b = (c + 2) % 3;
      sum_.first_moment[c] += volume * (mass * r[c] + h_ * first_moment[c]);
      sum_.momentum[c] += volume * momentum[c];
      sum_.angular_momentum[c] +=
          volume * (r[a] * momentum[b] - r[b] * momentum[a] + h_ * (spread[a][b] - spread[b][a]));
    }
  }

  const LatticeView<T, D>& view_;
  const Boundaries<D>& boundaries_;
  Vector about_;
  double h_;
  Moments<D> whole_ = Moments<D>::of_whole_cell();
  BodyIntegrals sum_;
};

}  // namespace

template <class T, int D>
BodyIntegrals integrate(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                        const Vector& about) {
  BodyIntegrals sum = Integrator<T, D>(view, boundaries, about)();
  sum.mass /= view.body.mass_scaling;
  for (double& moment : sum.first_moment) moment /= view.body.mass_scaling;
  return sum;
}

template <class T, int D>
BodyIntegrals sum_particles(const Body<T, D>& body, const Vector& about) {
  BodyIntegrals sum;
  const FieldStore<T, D>& f = body.stage[0];
  const Layout<D>& layout = body.population.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != Kind::interior) return;
      const Point<D> x = body.position(p, cell);
      Vector r = {}, u = {};
      for (int a = 0; a < D; ++a) {
        r[a] = x[a] - about[a];
        u[a] = f.get(Field::velocity, a)[p];
      }
      const double volume = f.get(Field::volume)[p];
      sum.volume += volume;
      const double mass = f.get(Field::mass)[p] / body.mass_scaling;
      sum.mass += mass;
      sum.strain_energy += energy_density<T, D>(body, f, p) * volume;
      add_motion(sum, mass, r, u, body.mass_scaling);
    });
  }
  return sum;
}

template BodyIntegrals integrate<double, 2>(const LatticeView<double, 2>&, const Boundaries<2>&,
                                            const Vector&);
template BodyIntegrals sum_particles<double, 2>(const Body<double, 2>&, const Vector&);
template BodyIntegrals integrate<double, 3>(const LatticeView<double, 3>&, const Boundaries<3>&,
                                            const Vector&);
template BodyIntegrals sum_particles<double, 3>(const Body<double, 3>&, const Vector&);
template BodyIntegrals integrate<float, 2>(const LatticeView<float, 2>&, const Boundaries<2>&,
                                           const Vector&);
template BodyIntegrals sum_particles<float, 2>(const Body<float, 2>&, const Vector&);
template BodyIntegrals integrate<float, 3>(const LatticeView<float, 3>&, const Boundaries<3>&,
                                           const Vector&);
template BodyIntegrals sum_particles<float, 3>(const Body<float, 3>&, const Vector&);

}  // namespace pliant::remeshed
