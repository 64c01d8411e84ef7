#include "engine/remeshed/observe/integrals.hpp"

#include <algorithm>
#include <cmath>

#include "engine/remeshed/observe/point_state.hpp"

namespace pliant::remeshed {

namespace {

constexpr int sub_cells = 10;          // to a side, of a cell that the surface may cut
constexpr double coverage_slope = 10;  // (RP.42)
const double gauss = 0.5 / std::sqrt(3.0);

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
        if (distance < -reach && wall > reach) {
          add_whole(x, e);
        } else {
          add_cut(x, e, wall < reach);
        }
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

  // Gauss points: products of linear fields are integrated exactly.
  void add_whole(const Point<D>& x, const Expansion<D>& e) {
    const double volume = std::pow(h_, D) / (1 << D);
    for (int corner = 0; corner < (1 << D); ++corner) {
      Point<D> s;
      for (int a = 0; a < D; ++a) s[a] = corner >> a & 1 ? gauss : -gauss;
      add(x, s, e, volume);
    }
  }

  void add_cut(const Point<D>& x, const Expansion<D>& e, bool is_near_wall) {
    const double volume = std::pow(h_ / sub_cells, D);
    const int count = kernels::power(sub_cells, D);
    for (int k = 0; k < count; ++k) {
      Point<D> s, at = x;
      for (int a = 0, rest = k; a < D; ++a, rest /= sub_cells) {
        s[a] = (rest % sub_cells + 0.5) / sub_cells - 0.5;
        at[a] += h_ * s[a];
      }
      double phi = e.phi;
      for (int a = 0; a < D; ++a) {
        phi += e.phi_slope[a] * s[a];
        for (int b = 0; b < D; ++b) phi += 0.5 * e.phi_curvature[a][b] * s[a] * s[b];
      }
      double covered = std::clamp(0.5 - coverage_slope * phi, 0.0, 1.0);
      if (is_near_wall) {
        const double wall = distance_to_walls(at) / h_;
        covered *= std::clamp(0.5 + coverage_slope * wall, 0.0, 1.0);
      }
      if (covered > 0) add(x, s, e, volume * covered);
    }
  }

  void add(const Point<D>& x, const Point<D>& s, const Expansion<D>& e, double volume) {
    double density = e.density, energy = e.energy;
    Point<D> u = e.velocity;
    Vector r = {}, velocity = {};
    for (int a = 0; a < D; ++a) {
      density += e.density_slope[a] * s[a];
      energy += e.energy_slope[a] * s[a];
      for (int c = 0; c < D; ++c) u[c] += e.velocity_slope[a][c] * s[a];
      r[a] = x[a] + h_ * s[a] - about_[a];
    }
    std::copy(u.begin(), u.end(), velocity.begin());
    sum_.volume += volume;
    sum_.mass += density * volume;
    sum_.strain_energy += energy * volume;
    add_motion(sum_, density * volume, r, velocity);
  }

  const LatticeView<T, D>& view_;
  const Boundaries<D>& boundaries_;
  Vector about_;
  double h_;
  BodyIntegrals sum_;
};

}  // namespace

template <class T, int D>
BodyIntegrals integrate(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                        const Vector& about) {
  return Integrator<T, D>(view, boundaries, about)();
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
      sum.mass += f.get(Field::mass)[p];
      sum.strain_energy += energy_density<T, D>(body, f, p) * volume;
      add_motion(sum, f.get(Field::mass)[p], r, u);
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
