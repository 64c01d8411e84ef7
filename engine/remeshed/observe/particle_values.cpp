#include "engine/remeshed/observe/particle_values.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/method/field_components.hpp"
#include "engine/method/field_fit.hpp"
#include "engine/method/no_value.hpp"
#include "engine/remeshed/observe/point_state.hpp"

namespace pliant::remeshed {

namespace {

constexpr double linear_radius = 2.6, quadratic_radius = 3.2;  // [h] radius of a fit

// Calls f(slot, r, square of r) for the particles that started around a point; r [h] is relative to
// it. d + xi is the displacement, and node - d is where the particle started.
template <class T, int D, class F>
void for_each_near(const Body<T, D>& body, const Vector& start, F&& f) {
  const FieldStore<T, D>& fields = body.stage[0];
  const Layout<D>& layout = body.population.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != Kind::interior) return;
      Point<D> r;
      double square = 0;
      for (int a = 0; a < D; ++a) {
        const double began = body.lattice.node(a, cell[a]) - fields.get(Field::displacement, a)[p];
        r[a] = (began - start[a]) / body.lattice.spacing;
        if (const double n = body.lattice.period[a]; n != 0) r[a] -= n * std::round(r[a] / n);
        square += r[a] * r[a];
      }
      if (square < quadratic_radius * quadratic_radius) f(p, r, square);
    });
  }
}

// F at the point: the gradient of displacements with respect to the places where particles started.
template <class T, int D>
double material_strain(const Body<T, D>& body, const Vector& start, const std::string& field) {
  LinearFit<D, D> fit;
  for_each_near(body, start, [&](std::int64_t p, const Point<D>& r, double square) {
    std::array<double, D> d;
    for (int a = 0; a < D; ++a) {
      d[a] = static_cast<double>(body.stage[0].get(Field::displacement, a)[p]) +
             body.stage[0].get(Field::drift, a)[p];
    }
    fit.add(r, weight_of_value(square, linear_radius), d);
  });
  if (!fit.solve()) return std::numeric_limits<double>::quiet_NaN();
  std::array<Point<D>, D> gradient;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      gradient[i][j] = (i == j ? 1 : 0) + fit.slope(i, j) / body.lattice.spacing;
    }
  }
  return strain_value<D>(gradient, field);
}

}  // namespace

template <class T, int D>
double field_value(const Body<T, D>& body, const FieldStore<T, D>& fields, const std::string& field,
                   std::int64_t slot) {
  if (field == "pressure") return pressure<T, D>(body, fields, slot);
  if (field == "density") return density<T, D>(fields, slot) / body.mass_scaling;
  if (field.find("stress") != field.npos) {
    std::array<double, kernels::symmetric_components<D>> known;
    std::ranges::copy(stress_of<T, D>(body, fields, slot), known.begin());
    return stress_value(full_stress<D>(known, pressure<T, D>(body, fields, slot)), field);
  }
  const int axis = last_axis(field);
  if (field.starts_with("velocity")) return fields.get(Field::velocity, axis)[slot];
  return static_cast<double>(fields.get(Field::displacement, axis)[slot]) +
         fields.get(Field::drift, axis)[slot];
}

template <class T, int D>
double strain_around(const LatticeView<T, D>& around, const Cell<D>& middle, const Point<D>& x,
                     const std::string& field) {
  constexpr int reach = 2;  // [h]
  const Lattice<D>& lattice = around.body.lattice;
  Cell<D> first = middle, last = middle;
  for (int a = 0; a < D; ++a) {
    first[a] -= reach;
    last[a] += reach;
  }
  LinearFit<D, D> fit;
  for_each_cell<D>(first, last, [&](const Cell<D>& cell) {
    const std::int64_t p = around.population.layout.slot(lattice.wrapped(cell));
    if (p < 0 || around.population.kind[p] != Kind::interior) return;
    Point<D> r, d;
    double square = 0;
    for (int a = 0; a < D; ++a) {
      const double drift = around.fields.get(Field::drift, a)[p];
      r[a] = (lattice.node(a, cell[a]) + drift - x[a]) / lattice.spacing;
      d[a] = (around.fields.get(Field::displacement, a)[p] + drift) / lattice.spacing;
      square += r[a] * r[a];
    }
    fit.add(r, weight_of_value(square, reach), d);
  });
  if (!fit.solve()) return std::numeric_limits<double>::quiet_NaN();
  Eigen::Matrix<double, D, D> inverse = Eigen::Matrix<double, D, D>::Identity();
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) inverse(i, j) -= fit.slope(i, j);
  }
  const Eigen::Matrix<double, D, D> gradient = inverse.inverse();
  std::array<Point<D>, D> rows;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) rows[i][j] = gradient(i, j);
  }
  return strain_value<D>(rows, field);
}

template <class T, int D>
double material_value(const Body<T, D>& body, const Vector& start, const std::string& field) {
  if (field.starts_with("strain")) return material_strain(body, start, field);
  FieldFit<D> fit;
  for_each_near(body, start, [&](std::int64_t p, const Point<D>& r, double square) {
    const double value = field_value<T, D>(body, body.stage[0], field, p);
    fit.add(r, weight_of_value(square, linear_radius), weight_of_value(square, quadratic_radius),
            value);
  });
  return fit.value().value_or(no_value);
}

template double field_value(const Body<double, 2>&, const FieldStore<double, 2>&,
                            const std::string&, std::int64_t);
template double field_value(const Body<double, 3>&, const FieldStore<double, 3>&,
                            const std::string&, std::int64_t);
template double field_value(const Body<float, 2>&, const FieldStore<float, 2>&, const std::string&,
                            std::int64_t);
template double field_value(const Body<float, 3>&, const FieldStore<float, 3>&, const std::string&,
                            std::int64_t);
template double strain_around<double, 2>(const LatticeView<double, 2>&, const Cell<2>&,
                                         const Point<2>&, const std::string&);
template double strain_around<double, 3>(const LatticeView<double, 3>&, const Cell<3>&,
                                         const Point<3>&, const std::string&);
template double strain_around<float, 2>(const LatticeView<float, 2>&, const Cell<2>&,
                                        const Point<2>&, const std::string&);
template double strain_around<float, 3>(const LatticeView<float, 3>&, const Cell<3>&,
                                        const Point<3>&, const std::string&);
template double material_value(const Body<double, 2>&, const Vector&, const std::string&);
template double material_value(const Body<double, 3>&, const Vector&, const std::string&);
template double material_value(const Body<float, 2>&, const Vector&, const std::string&);
template double material_value(const Body<float, 3>&, const Vector&, const std::string&);

}  // namespace pliant::remeshed
