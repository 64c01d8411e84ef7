#include "engine/total_lagrangian/observe/measure.hpp"

#include <cmath>
#include <optional>

#include "engine/geometry/padded.hpp"
#include "engine/method/no_value.hpp"
#include "engine/method/velocity_error.hpp"
#include "engine/total_lagrangian/observe/cell_values.hpp"
#include "engine/total_lagrangian/observe/place_in_cell.hpp"
#include "engine/total_lagrangian/parameters.hpp"
#include "engine/total_lagrangian/stress_point.hpp"

namespace pliant::total_lagrangian {

namespace {

template <class T, int D>
int block_count(const Body<T, D>& body) {
  return static_cast<int>(body.layout.blocks().size());
}

template <class T, int D, class F>
void for_each_particle_of(const Body<T, D>& body, int block, F&& f) {
  body.layout.for_each_slot(body.layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    if (body.is_particle(p)) f(p, cell);
  });
}

template <class T, int D, class F>
void for_each_particle(const Body<T, D>& body, F&& f) {
  for (int b = 0; b < block_count(body); ++b) for_each_particle_of(body, b, f);
}

/// Volume and strain energy of the stress points of a block.
template <class T, int D>
BodyIntegrals integrate_stress_points(const Body<T, D>& body, int block, double ahead) {
  BodyIntegrals sum;
  body.layout.for_each_slot(body.layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    if (!(body.fraction[p] > 0)) return;
    const StressPoint<D> point = stress_point<T, D>(body, p, cell, ahead);
    sum.strain_energy += point.energy;
    sum.volume += point.volume * point.volume_ratio;
  });
  return sum;
}

}  // namespace

template <class T, int D>
undeformed::FreeSurface<D> Measurer<T, D>::free_surface(int index) const {
  const Body<T, D>& body = state_.bodies[index];
  undeformed::FreeSurface<D> surface;
  for (const Facet<D>& facet : body.facets) {
    if (!facet.free) continue;
    auto& corner = surface.emplace_back();
    for (int v = 0; v < D; ++v) corner[v] = body.position(facet.vertex[v]);
  }
  return surface;
}

// Linear interpolation in each direction, in the cell in which the point started.
template <class T, int D>
double Measurer<T, D>::point_displacement(const MeasurementCase& m) const {
  const Body<T, D>& body = state_.bodies[m.body];
  const PlaceInCell<D> place = place_in_cell<T, D>(body, unpadded<D>(m.point));
  const auto corners = body.corners(place.cell);
  double sum = 0, weights = 0;
  for (int c = 0; c < (1 << D); ++c) {
    if (corners[c] < 0 || !body.is_particle(corners[c])) continue;
    sum += place.weight(c) * body.displacement[m.axis][corners[c]];
    weights += place.weight(c);
  }
  return weights > 0.5 ? sum / weights : no_value;
}

template <class T, int D>
double Measurer<T, D>::value_at(const MeasurementCase& m, const Vector& start) const {
  return total_lagrangian::material_value<T, D>(state_.bodies[m.body], start, m.field);
}

template <class T, int D>
double Measurer<T, D>::material_value(const MeasurementCase& m) const {
  return value_at(m, m.point);
}

template <class T, int D>
double Measurer<T, D>::point_value(const MeasurementCase& m) const {
  const std::optional<Vector> start = start_of<T, D>(state_.bodies[m.body], m.point);
  return start ? value_at(m, *start) : no_value;
}

template <class T, int D>
double Measurer<T, D>::mean_value(const MeasurementCase& m) const {
  return total_lagrangian::mean_value<T, D>(state_.bodies[m.body], m, state_.clock.time);
}

template <class T, int D>
double Measurer<T, D>::velocity_error(const MeasurementCase& m) const {
  const Body<T, D>& body = state_.bodies[m.body];
  const std::vector<Point<D>> velocity = present_velocity(body);
  VelocityError error(m, state_.clock.time);
  for_each_particle(body, [&](std::int64_t p, const Cell<D>& cell) {
    Point<D> x = body.place(p, cell);
    for (int a = 0; a < D; ++a) x[a] += body.displacement[a][p];
    error.add(padded<D>(x), padded<D>(velocity[p]), D);
  });
  return error.value();
}

// Advances velocities from the middle of the step to the present time by the acceleration of that
// step, contact included, (TL.8), so that kinetic and strain energy belong to the same time.
template <class T, int D>
std::vector<Point<D>> Measurer<T, D>::present_velocity(const Body<T, D>& body) const {
  const Clock& clock = state_.clock;
  const double lag = clock.lag();
  std::vector<Point<D>> velocity(body.layout.slots()), change(body.layout.slots());
  for_each_particle(body, [&](std::int64_t p, const Cell<D>&) {
    for (int a = 0; a < D; ++a) {
      const double force = static_cast<double>(body.internal[a][p]) + body.traction[a][p];
      const double u = velocity[p][a] = body.velocity[a][p];
      change[p][a] = lag * (force / (clock.mass_scaling * body.mass[p]) - clock.damping * u);
    }
  });
  for (const auto& of_block : body.held) {
    for (const ConstrainedParticle<D>& held : of_block) {
      double along = 0, slips = 0;
      for (int a = 0; a < D; ++a) {
        along += change[held.slot][a] * held.normal[a];
        slips += held.normal[a] * held.normal[a];
      }
      for (int a = 0; a < D; ++a) {
        change[held.slot][a] = slips > 0 ? change[held.slot][a] - along * held.normal[a] : 0;
      }
    }
  }
  for (std::size_t p = 0; p < velocity.size(); ++p) {
    for (int a = 0; a < D; ++a) velocity[p][a] += change[p][a];
  }
  return velocity;
}

template <class T, int D>
BodyIntegrals Measurer<T, D>::integrals(int index, const Vector& about) const {
  const Body<T, D>& body = state_.bodies[index];
  const double scaling = state_.clock.mass_scaling;
  const std::vector<Point<D>> velocity = present_velocity(body);
  const auto of_block = [&](int block) {
    BodyIntegrals sum = integrate_stress_points(body, block, 0);
    for_each_particle_of(body, block, [&](std::int64_t p, const Cell<D>& cell) {
      Vector r = {}, u = {};
      const Point<D> start = body.place(p, cell);
      for (int a = 0; a < D; ++a) {
        r[a] = start[a] + body.displacement[a][p] - about[a];
        u[a] = velocity[p][a];
      }
      sum.mass += body.mass[p];
      add_motion(sum, body.mass[p], r, u, scaling);
    });
    return sum;
  };
  return workers_.template sum<BodyIntegrals>(block_count(body), of_block);
}

template <class T, int D>
double Measurer<T, D>::strain_energy(const Body<T, D>& body, double ahead) const {
  const auto of_block = [&](int block) { return integrate_stress_points(body, block, ahead); };
  return workers_.template sum<BodyIntegrals>(block_count(body), of_block).strain_energy;
}

// A wall takes up the forces on a particle along the directions in which it holds it.
template <class T, int D>
double Measurer<T, D>::power_on(const Body<T, D>& body) const {
  const double rate = state_.clock.damping * state_.clock.mass_scaling;
  double power = 0;
  for_each_particle(body, [&](std::int64_t p, const Cell<D>&) {
    for (int a = 0; a < D; ++a) {
      const double u = body.velocity[a][p];
      power += u * (body.traction[a][p] - rate * body.mass[p] * u);
    }
  });
  for (const auto& of_block : body.held) {
    for (const ConstrainedParticle<D>& held : of_block) {
      const bool slips = held.normal != Point<D>{};
      double along = 0;
      for (int a = 0; a < D; ++a) along += body.velocity[a][held.slot] * held.normal[a];
      for (int a = 0; a < D; ++a) {
        const double force = double{body.internal[a][held.slot]} + body.traction[a][held.slot];
        power -= force * (slips ? along * held.normal[a] : body.velocity[a][held.slot]);
      }
    }
  }
  return power;
}

template <class T, int D>
double Measurer<T, D>::total_energy(int index, const BodyIntegrals& sum) const {
  const Body<T, D>& body = state_.bodies[index];
  const Clock& clock = state_.clock;
  if (clock.step_length == 0) return sum.kinetic_energy + sum.strain_energy;
  double kinetic = 0;
  for_each_particle(body, [&](std::int64_t p, const Cell<D>&) {
    for (int a = 0; a < D; ++a) {
      const double u = body.velocity[a][p];
      kinetic += clock.mass_scaling * body.mass[p] * u * u / 2;
    }
  });
  const double lag = clock.lag(), half = clock.step_length / 2;
  return kinetic + 2 * strain_energy(body, -lag) -
         (strain_energy(body, -lag - half) + strain_energy(body, half - lag)) / 2 +
         lag * power_on(body);
}

template class Measurer<double, 2>;
template class Measurer<double, 3>;
template class Measurer<float, 2>;
template class Measurer<float, 3>;

}  // namespace pliant::total_lagrangian
