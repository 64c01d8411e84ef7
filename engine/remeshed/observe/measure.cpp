#include "engine/remeshed/observe/measure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/case/attached_walls.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/lattice/corner_weights.hpp"
#include "engine/method/no_value.hpp"
#include "engine/method/region_share.hpp"
#include "engine/method/velocity_error.hpp"
#include "engine/remeshed/contact/contact_momentum_correction.hpp"
#include "engine/remeshed/level_set/interpolant.hpp"
#include "engine/remeshed/neighbours/closest_pair.hpp"
#include "engine/remeshed/observe/particle_values.hpp"
#include "engine/remeshed/observe/surface.hpp"
#include "engine/remeshed/observe/surface_area.hpp"

namespace pliant::remeshed {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double on_wall = 1e-9;  // [h] rounding errors of distances
}  // namespace

template <class T, int D>
std::vector<double> Measurer<T, D>::operator()(std::span<const MeasurementCase> measurements) {
  std::vector<double> values;
  for (const MeasurementCase& m : measurements) values.push_back(value(m));
  return values;
}

template <class T, int D>
const std::vector<LatticeView<T, D>>& Measurer<T, D>::nodes() {
  if (nodes_.empty()) nodes_ = find_nodes_();
  return nodes_;
}

template <class T, int D>
auto Measurer<T, D>::function_of(MeasurementCase::Kind kind) -> Function {
  using Quantity = MeasurementCase::Kind;
  static constexpr Function functions[] = {
      {Quantity::extent, &Measurer::extent, Reads::nodes},
      {Quantity::surface_distance, &Measurer::surface_distance, Reads::nodes},
      {Quantity::mean_radius, &Measurer::mean_radius, Reads::nodes},
      {Quantity::point_displacement, &Measurer::point_displacement, Reads::particles},
      {Quantity::point_value, &Measurer::point_value, Reads::nodes},
      {Quantity::material_value, &Measurer::material_value, Reads::particles},
      {Quantity::mean_value, &Measurer::mean_value, Reads::particles},
      {Quantity::mass, &Measurer::integral, Reads::particles},
      {Quantity::centre_of_mass, &Measurer::integral, Reads::particles},
      {Quantity::momentum, &Measurer::integral, Reads::particles},
      {Quantity::angular_momentum, &Measurer::integral, Reads::particles},
      {Quantity::kinetic_energy, &Measurer::integral, Reads::particles},
      {Quantity::strain_energy, &Measurer::integral, Reads::particles},
      {Quantity::total_energy, &Measurer::integral, Reads::particles},
      {Quantity::energy_ratio, &Measurer::integral, Reads::particles},
      {Quantity::wall_force, &Measurer::wall_impulse, Reads::particles},
      {Quantity::wall_moment, &Measurer::wall_angular_impulse, Reads::particles},
      {Quantity::contact_force, &Measurer::contact_impulse, Reads::particles},
      {Quantity::volume, &Measurer::integral, Reads::particles},
      {Quantity::surface_area, &Measurer::area, Reads::nodes},
      {Quantity::minimum_particle_distance, &Measurer::minimum_particle_distance, Reads::particles},
      {Quantity::velocity_error, &Measurer::velocity_error, Reads::particles},
  };
  const auto known = std::ranges::find(functions, kind, &Function::kind);
  return known == std::end(functions) ? Function{} : *known;
}

template <class T, int D>
double Measurer<T, D>::value(const MeasurementCase& m) {
  const Function function = function_of(m.kind);
  return function.evaluate ? (this->*function.evaluate)(m) : no_value;
}

template <class T, int D>
double Measurer<T, D>::wall_impulse(const MeasurementCase& m) {
  return state_.wall_impulse[state_.boundaries.wall_of[m.boundary]].force[m.axis];
}

template <class T, int D>
double Measurer<T, D>::wall_angular_impulse(const MeasurementCase& m) {
  return state_.wall_impulse[state_.boundaries.wall_of[m.boundary]].moment_about(
      m.point)[D == 2 ? 2 : m.axis];
}

template <class T, int D>
double Measurer<T, D>::contact_impulse(const MeasurementCase& m) {
  double on_first = 0;
  for (std::size_t c = 0; c < state_.contact_impulse.size(); ++c) {
    const std::array<int, 2>& of = settings_.contacts[c].bodies;
    if (of == m.bodies) on_first -= state_.contact_impulse[c][m.axis];
    if (of == std::array{m.bodies[1], m.bodies[0]}) on_first += state_.contact_impulse[c][m.axis];
  }
  return on_first;
}

// The level set continues through walls to which the body is attached, but the surface does not.
template <class T, int D>
std::function<bool(const Vector&)> Measurer<T, D>::free_points(const MeasurementCase& m) const {
  const double t = state_.clock.time;
  return [this, &m, t](const Vector& x) {
    return !is_in_wall(x) && (!m.where || (*m.where)(x[0], x[1], x[2], t) != 0);
  };
}

template <class T, int D>
double Measurer<T, D>::extent(const MeasurementCase& m) {
  const auto farthest =
      remeshed::extent<T, D>(nodes()[m.body], m.axis, m.lower_side, free_points(m));
  if (!farthest) return no_value;
  return m.lower_side ? m.reference - *farthest : *farthest - m.reference;
}

template <class T, int D>
double Measurer<T, D>::surface_distance(const MeasurementCase& m) {
  const auto distance = ray_to_surface(nodes()[m.body], m.point, m.direction, free_points(m));
  return distance ? *distance - m.reference : no_value;
}

template <class T, int D>
double Measurer<T, D>::mean_radius(const MeasurementCase& m) {
  double sum = 0;
  for (int k = 0; k < m.directions; ++k) {
    const double angle = 2 * pi * (k + 0.5) / m.directions;
    const auto r = ray_to_surface(nodes()[m.body], m.point, {std::cos(angle), std::sin(angle), 0},
                                  free_points(m));
    if (!r) return no_value;
    sum += *r;
  }
  return sum / m.directions;
}

template <class T, int D>
double Measurer<T, D>::point_displacement(const MeasurementCase& m) {
  const std::string component(1, static_cast<char>('x' + m.axis));
  return remeshed::material_value<T, D>(state_.bodies[m.body], m.point,
                                        "displacement_" + component);
}

template <class T, int D>
double Measurer<T, D>::material_value(const MeasurementCase& m) {
  return remeshed::material_value<T, D>(state_.bodies[m.body], m.point, m.field);
}

template <class T, int D>
double Measurer<T, D>::mean_value(const MeasurementCase& m) {
  const Body<T, D>& body = state_.bodies[m.body];
  const LatticeView<T, D> particles{body, body.population, body.stage[0]};
  const bool is_strain = m.field.starts_with("strain");
  const double t = state_.clock.time;
  const auto in_cell_around = [&](const Point<D>& centre) {
    return [&, centre](const Point<D>& r) {
      Point<D> x = centre;
      for (int a = 0; a < D; ++a) x[a] += (r[a] - 0.5) * settings_.discretisation.spacing;
      return x;
    };
  };
  double sum = 0, volume = 0;
  for (const Block<D>& block : body.population.layout.blocks()) {
    body.population.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != pliant::remeshed::Kind::interior) return;
      const Point<D> at = body.position(p, cell);
      const double share = m.where ? share_in_region<D>(*m.where, t, in_cell_around(at)) : 1;
      if (share == 0) return;
      const double v = share * body.stage[0].get(Field::volume)[p];
      sum += v * (is_strain ? strain_around<T, D>(particles, cell, at, m.field)
                            : field_value<T, D>(body, body.stage[0], m.field, p));
      volume += v;
    });
  }
  return volume > 0 ? sum / volume : no_value;
}

template <class T, int D>
double Measurer<T, D>::minimum_particle_distance(const MeasurementCase& m) {
  return closest_pair<T, D>(state_.bodies[m.body]);
}

template <class T, int D>
double Measurer<T, D>::area(const MeasurementCase& m) {
  return surface_area(nodes()[m.body], state_.boundaries,
                      initial_surface(settings_, settings_.bodies[m.body]));
}

template <class T, int D>
double Measurer<T, D>::integral(const MeasurementCase& m) {
  return value_of(m, integrals(m.body, m.point), D);
}

template <class T, int D>
bool Measurer<T, D>::is_in_wall(const Vector& x) const {
  Point<D> at;
  std::copy(x.begin(), x.begin() + D, at.begin());
  return state_.boundaries.nearest_wall(at).second < -on_wall * settings_.discretisation.spacing;
}

template <class T, int D>
const BodyIntegrals& Measurer<T, D>::integrals(int body, const Vector& about) {
  return integrals_.of(body, about, [&] { return integrate_body(body, about); });
}

template <class T, int D>
BodyIntegrals Measurer<T, D>::integrate_body(int body, const Vector& about) {
  using Policy = decltype(Case::remeshing)::Policy;
  const Body<T, D>& particles = state_.bodies[body];
  const bool is_bounded = particles.has_surface || !state_.boundaries.walls.empty();
  if (!find_nodes_ || settings_.remeshing.policy == Policy::never || !is_bounded) {
    return sum_particles<T, D>(particles, about);
  }
  BodyIntegrals sum = integrate<T, D>(nodes()[body], state_.boundaries, about, workers_);
  if (state_.momentum_budgets.empty()) return sum;
  const Point<D> momentum = budget_momentum<T, D>(state_, body);
  std::copy(momentum.begin(), momentum.end(), sum.momentum.begin());
  return sum;
}

template <class T, int D>
BodyIntegrals Measurer<T, D>::totals() {
  BodyIntegrals sum;
  for (int b = 0; b < static_cast<int>(state_.bodies.size()); ++b) {
    add(sum, integrals(b, {}));
  }
  return sum;
}

template <class T, int D>
double Measurer<T, D>::velocity_error(const MeasurementCase& m) {
  const Body<T, D>& body = state_.bodies[m.body];
  VelocityError error(m, state_.clock.time);
  for (const Block<D>& block : body.population.layout.blocks()) {
    body.population.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != pliant::remeshed::Kind::interior) return;
      Point<D> u;
      for (int a = 0; a < D; ++a) u[a] = body.stage[0].get(Field::velocity, a)[p];
      error.add(padded<D>(body.position(p, cell)), padded<D>(u), D);
    });
  }
  return error.value();
}

// Linear in the cell around the point; the field is evaluated at its corner nodes. Strains are fits
// over the nodes around the point.
template <class T, int D>
double Measurer<T, D>::point_value(const MeasurementCase& m) {
  const LatticeView<T, D>& view = nodes()[m.body];
  const Point<D> x = unpadded<D>(m.point);
  const bool is_strain = m.field.starts_with("strain");
  double value = 0, phi = 0;
  const auto add = [&](const Cell<D>& cell, double weight) {
    const std::int64_t p = view.population.layout.slot(view.body.lattice.wrapped(cell));
    if (p < 0 || view.population.kind[p] == remeshed::Kind::vacant) return false;
    if (!is_strain) value += weight * field_value<T, D>(view.body, view.fields, m.field, p);
    phi += weight * view.fields.get(Field::level_set)[p];
    return true;
  };
  if (!for_each_corner<D>(view.body.lattice, x, add)) return no_value;
  const bool is_outside = (view.body.has_surface && phi > 0) || is_in_wall(m.point);
  if (is_outside) return no_value;
  if (!is_strain) return value;
  Cell<D> cell;
  for (int a = 0; a < D; ++a) cell[a] = view.body.lattice.cell(a, x[a]);
  return strain_around<T, D>(view, cell, x, m.field);
}

template class Measurer<double, 2>;
template class Measurer<double, 3>;
template class Measurer<float, 2>;
template class Measurer<float, 3>;

}  // namespace pliant::remeshed
