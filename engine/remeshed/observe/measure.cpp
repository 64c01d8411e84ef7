#include "engine/remeshed/observe/measure.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "engine/geometry/padded.hpp"
#include "engine/remeshed/contact/momentum_correction.hpp"
#include "engine/remeshed/level_set/interpolant.hpp"
#include "engine/remeshed/neighbours/closest_pair.hpp"
#include "engine/remeshed/observe/point_state.hpp"
#include "engine/remeshed/observe/surface.hpp"
#include "engine/remeshed/observe/surface_area.hpp"

namespace pliant::remeshed {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

template <class T, int D>
double mean_radius(const LatticeView<T, D>& view, const Vector& centre, int directions) {
  double sum = 0;
  for (int k = 0; k < directions; ++k) {
    const double angle = 2 * pi * (k + 0.5) / directions;
    const auto r = ray_to_surface(view, centre, {std::cos(angle), std::sin(angle), 0});
    if (!r) return nothing;
    sum += *r;
  }
  return sum / directions;
}

}  // namespace

template <class T, int D>
Vector material_displacement(const Body<T, D>& body, const Vector& start) {
  const FieldStore<T, D>& f = body.stage[0];
  const Layout<D>& layout = body.population.layout;
  const double h = body.lattice.spacing;
  // d + xi is the displacement; node - d is where the particle started.
  const auto from_start = [&](std::int64_t p, const Cell<D>& cell) {
    Eigen::Matrix<double, D, 1> r;
    for (int a = 0; a < D; ++a) {
      r[a] = (body.lattice.node(a, cell[a]) - f.get(Field::displacement, a)[p] - start[a]) / h;
    }
    return r;
  };
  constexpr double radius = 2.6;
  Eigen::Matrix<double, D + 1, D + 1> normal = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  Eigen::Matrix<double, D + 1, D> right = Eigen::Matrix<double, D + 1, D>::Zero();
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != Kind::interior) return;
      const auto r = from_start(p, cell);
      const double fraction = r.squaredNorm() / (radius * radius);
      if (fraction >= 1) return;
      Eigen::Matrix<double, D + 1, 1> q;
      q << 1, r;
      normal += (1 - fraction) * (1 - fraction) * q * q.transpose();
      for (int a = 0; a < D; ++a) {
        const double d = f.get(Field::displacement, a)[p] + f.get(Field::drift, a)[p];
        right.col(a) += (1 - fraction) * (1 - fraction) * d * q;
      }
    });
  }
  const auto fit = normal.ldlt().solve(right).eval();
  Vector displacement = {};
  for (int a = 0; a < D; ++a) displacement[a] = fit(0, a);
  return displacement;
}

template <class T, int D>
std::vector<double> Measurer<T, D>::operator()(std::span<const MeasurementCase> measurements) {
  std::vector<double> values;
  for (const MeasurementCase& m : measurements) values.push_back(value(m));
  return values;
}

template <class T, int D>
const LatticeView<T, D>& Measurer<T, D>::nodes(int body) {
  if (nodes_.empty()) nodes_ = find_nodes_();
  return nodes_[body];
}

template <class T, int D>
double Measurer<T, D>::value(const MeasurementCase& m) {
  using Quantity = MeasurementCase::Kind;
  if (m.reads_history()) return nothing;
  switch (m.kind) {
    case Quantity::extent:
    case Quantity::surface_distance:
    case Quantity::mean_radius:
      return surface_value(m);
    case Quantity::surface_area:
      return surface_area(nodes(m.body), state_.boundaries);
    case Quantity::point_displacement:
      return material_displacement<T, D>(state_.bodies[m.body], m.point)[m.axis];
    case Quantity::wall_force:
    case Quantity::contact_force:
      return impulse(m);
    case Quantity::point_value:
      return point_value(m);
    case Quantity::minimum_particle_distance:
      return closest_pair<T, D>(state_.bodies[m.body]);
    case Quantity::velocity_error:
      return velocity_error(m);
    default:
      return value_of(m, integrals(m.body, m.point), D);
  }
}

template <class T, int D>
double Measurer<T, D>::impulse(const MeasurementCase& m) const {
  if (m.kind == MeasurementCase::Kind::wall_force) {
    return state_.wall_impulse[state_.boundaries.wall_of[m.boundary]][m.axis];
  }
  double on_first = 0;
  for (std::size_t c = 0; c < state_.contact_impulse.size(); ++c) {
    const std::array<int, 2>& of = settings_.contacts[c].bodies;
    if (of == m.bodies) on_first -= state_.contact_impulse[c][m.axis];
    if (of == std::array{m.bodies[1], m.bodies[0]}) on_first += state_.contact_impulse[c][m.axis];
  }
  return on_first;
}

template <class T, int D>
double Measurer<T, D>::surface_value(const MeasurementCase& m) {
  const double t = state_.clock.time;
  if (m.kind == MeasurementCase::Kind::mean_radius) {
    return mean_radius(nodes(m.body), m.point, m.directions);
  }
  if (m.kind == MeasurementCase::Kind::surface_distance) {
    const auto distance = ray_to_surface(nodes(m.body), m.point, m.direction);
    return distance ? *distance - m.reference : nothing;
  }
  const auto counts = [&](const Vector& x) {
    return !m.where || (*m.where)(x[0], x[1], x[2], t) != 0;
  };
  const auto farthest = extent<T, D>(nodes(m.body), m.axis, m.lower_side, counts);
  if (!farthest) return nothing;
  return m.lower_side ? m.reference - *farthest : *farthest - m.reference;
}

template <class T, int D>
const BodyIntegrals& Measurer<T, D>::integrals(int body, const Vector& about) {
  for (const Integrated& known : integrals_) {
    if (known.body == body && known.about == about) return known.sum;
  }
  integrals_.push_back({body, about, integrate_body(body, about)});
  return integrals_.back().sum;
}

template <class T, int D>
BodyIntegrals Measurer<T, D>::integrate_body(int body, const Vector& about) {
  using Policy = decltype(Case{}.remeshing)::Policy;
  const Body<T, D>& particles = state_.bodies[body];
  if (settings_.remeshing.policy == Policy::never || !particles.has_surface) {
    return sum_particles<T, D>(particles, about);
  }
  BodyIntegrals sum = integrate<T, D>(nodes(body), state_.boundaries, about);
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
double Measurer<T, D>::velocity_error(const MeasurementCase& m) const {
  const Body<T, D>& body = state_.bodies[m.body];
  const double t = state_.clock.time;
  double largest = 0, square = 0;
  std::int64_t count = 0;
  for (const Block<D>& block : body.population.layout.blocks()) {
    body.population.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != pliant::remeshed::Kind::interior) return;
      const Vector x = padded<D>(body.position(p, cell));
      for (int a = 0; a < D; ++a) {
        const double error =
            std::abs(body.stage[0].get(Field::velocity, a)[p] - m.exact[a](x[0], x[1], x[2], t));
        largest = std::max(largest, error);
        square += error * error;
      }
      ++count;
    });
  }
  const double error =
      m.norm == MeasurementCase::Norm::maximum
          ? largest
          : std::sqrt(square / static_cast<double>(std::max<std::int64_t>(count, 1)));
  return error / m.reference;
}

// A field by the name that case files give it; vectors and stress end in their axes.
template <class T, int D>
double node_value(const LatticeView<T, D>& view, const std::string& field, std::int64_t p) {
  if (field == "pressure") return pressure<T, D>(view.body, view.fields, p);
  if (field == "density") return density<T, D>(view.fields, p);
  const int last = field.back() - 'x';
  if (field.starts_with("stress")) {
    const int first = field[field.size() - 2] - 'x';
    return stress<T, D>(view.body, view.fields, p)[kernels::symmetric_index<D>(first, last)];
  }
  return view.fields.get(field.starts_with("velocity") ? Field::velocity : Field::displacement,
                         last)[p];
}

// Linear in the cell around the point; the field is evaluated at its corner nodes.
template <class T, int D>
double Measurer<T, D>::point_value(const MeasurementCase& m) {
  const LatticeView<T, D>& view = nodes(m.body);
  const Lattice<D>& lattice = view.body.lattice;
  double value = 0;
  for (int corner = 0; corner < (1 << D); ++corner) {
    Cell<D> cell;
    double weight = 1;
    for (int a = 0; a < D; ++a) {
      const double at = (m.point[a] - lattice.origin[a]) / lattice.spacing - 0.5;
      const std::int32_t below = cell_below(at);
      const int up = corner >> a & 1;
      cell[a] = below + up;
      weight *= up ? at - below : 1 - (at - below);
    }
    const std::int64_t p = view.population.layout.slot(lattice.wrapped(cell));
    if (p < 0 || view.population.kind[p] == remeshed::Kind::vacant) return nothing;
    value += weight * node_value<T, D>(view, m.field, p);
  }
  return value;
}

template class Measurer<double, 2>;
template Vector material_displacement<double, 2>(const Body<double, 2>&, const Vector&);
template class Measurer<double, 3>;
template Vector material_displacement<double, 3>(const Body<double, 3>&, const Vector&);
template class Measurer<float, 2>;
template Vector material_displacement<float, 2>(const Body<float, 2>&, const Vector&);
template class Measurer<float, 3>;
template Vector material_displacement<float, 3>(const Body<float, 3>&, const Vector&);

}  // namespace pliant::remeshed
