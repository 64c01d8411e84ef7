#include "engine/total_lagrangian/stress_point.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/method/bulk_history.hpp"
#include "engine/method/hyperelastic.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/method/networks.hpp"
#include "kernels/total_lagrangian/cell_energy.hpp"
#include "kernels/total_lagrangian/hourglass.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::total_lagrangian {

namespace {

using Pack = xsimd::batch<double, xsimd::sse2>;

// Modes of a cell, [component][mode], (TL.2): sums and differences along one axis after another.
template <class T, int D>
std::array<std::array<double, (1 << D)>, D> modes(const Body<T, D>& body, const Cell<D>& cell,
                                                  double ahead) {
  std::array<std::array<double, (1 << D)>, D> mode = {};
  const auto corners = body.corners(cell);
  for (int i = 0; i < D; ++i) {
    for (int c = 0; c < (1 << D); ++c) {
      const double d = body.displacement[i][corners[c]];
      mode[i][c] = ahead == 0 ? d : d + ahead * body.velocity[i][corners[c]];
    }
    for (int axis = 1; axis < (1 << D); axis *= 2) {
      for (int c = 0; c < (1 << D); ++c) {
        if (c & axis) continue;
        const double lower = mode[i][c], upper = mode[i][c | axis];
        mode[i][c] = lower + upper;
        mode[i][c | axis] = upper - lower;
      }
    }
  }
  return mode;
}

// Volumetric energy U(J) of (TL.3).
double volumetric_energy(const kernels::Material<double>& material, double j) {
  const double modulus = 2 / material.compressibility;
  switch (material.model) {
    case kernels::Model::linear:
      return modulus * (j - 1 - std::log(j));
    case kernels::Model::linear_logarithmic:
      return modulus * (j * std::log(j) - j + 1);
    default:
      return modulus / 2 * (j - 1) * (j - 1);
  }
}

template <int D>
std::array<double, D * D> row_by_row(const StressPoint<D>& point) {
  std::array<double, D * D> f;
  for (int c = 0; c < D * D; ++c) f[c] = point.deformation_gradient[c / D][c % D];
  return f;
}

/// A cell in plain numbers: F and the hourglass modes, (TL.2) and (TL.11).
template <int D>
struct CellShape {
  Eigen::Matrix<double, D, D> f;
  std::array<std::array<double, (1 << D)>, D> mode;  ///< hourglass modes [m]
  double volume = 0;                                 ///< undeformed volume inside the body
};

template <class T, int D>
CellShape<D> cell_shape(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell,
                        double ahead) {
  using Matrix = Eigen::Matrix<double, D, D>;
  const auto mode = modes<T, D>(body, cell, ahead);
  const double h = body.lattice.spacing;
  const bool is_fitted = body.fraction[slot] != body.regular_fraction[slot];
  const auto fitted = std::lower_bound(
      body.fitted.begin(), body.fitted.end(), is_fitted ? slot : 0,
      [](const auto& fitted_cell, std::int64_t s) { return fitted_cell.slot < s; });
  const CellMoments<D> moments = body.moments(slot);
  Matrix gradient, inverse = Matrix::Identity();
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      double mean = 0;
      for (int m = 0; m < (1 << D); ++m) {
        if (m >> j & 1) mean += moments[m ^ 1 << j] * mode[i][m];
      }
      gradient(i, j) = mean * 2 / ((1 << D) * h);
    }
  }
  for (int c = 0; c < D * D && is_fitted; ++c) inverse(c / D, c % D) = fitted->inverse[c];
  gradient *= inverse;
  CellShape<D> shape;
  shape.f = Matrix::Identity() + gradient;
  shape.volume = std::pow(h, D) * (is_fitted ? fitted->volume : body.fraction[slot]);
  shape.mode = mode;
  for (int m = 1; m < (1 << D) && is_fitted; ++m) {
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) shape.mode[i][m] -= gradient(i, j) * fitted->start[j][m];
    }
  }
  return shape;
}

/// Adds the initial stress. Returns its energy per undeformed volume.
template <class T, int D>
double add_prestress(const Body<T, D>& body, std::int64_t slot, StressPoint<D>& point) {
  std::array<double, kernels::symmetric_components<D>> s0;
  for (std::size_t c = 0; c < s0.size(); ++c) s0[c] = body.initial_stress[c][slot];
  const ConstantStress<D> lasting(s0, row_by_row(point), point.volume_ratio);
  for (std::size_t c = 0; c < s0.size(); ++c) point.stress[c] += lasting.stress[c];
  point.pressure += lasting.pressure(*body.source);
  return lasting.energy;
}

/// Adds the present stress of the networks of (TL.24). Returns their energy per volume.
template <class T, int D>
double add_networks(const Body<T, D>& body, const kernels::Material<double>& material,
                    std::int64_t slot, const Eigen::Matrix3d& f, StressPoint<D>& point) {
  const NetworkStress<D> networks =
      network_stress<T, D>(material, {body.prony_shear, body.network, body.memory_age}, slot, f);
  for (std::size_t c = 0; c < point.stress.size(); ++c) point.stress[c] += networks.stress[c];
  return networks.energy;
}

/// The state of the cell of a law (TL.3) or (TL.22), as kernels take it.
template <class T, int D>
kernels::CellState<Pack, D> cell_state(const Body<T, D>& body, const CellShape<D>& shape) {
  kernels::CellState<Pack, D> state;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) state.f[D * i + j] = Pack(shape.f(i, j));
  }
  Pack mode[D][1 << D];
  for (int i = 0; i < D; ++i) std::copy(shape.mode[i].begin(), shape.mode[i].end(), mode[i]);
  std::copy_n(state.f, D * D, state.by_f);
  const kernels::HourglassWeights<Pack, D> weights(body.hourglass, body.lattice.spacing);
  state.hourglass = kernels::hourglass_squares<Pack, D>(weights, state.f, mode, state.by_f);
  state.find_cofactor();
  return state;
}

/// Sets the stress of a law (TL.3). Returns its energy per volume.
template <class T, int D>
double take_polynomial(const Body<T, D>& body, const kernels::Material<double>& material,
                       std::int64_t slot, const kernels::CellState<Pack, D>& state,
                       const CellShape<D>& shape, StressPoint<D>& point) {
  const auto stress = kernels::polynomial_stress<Pack, D>(material, state, Pack(0.0));
  const double j = point.volume_ratio;
  const BulkHistory<T> history = {body.prony, body.memory_pressure, body.volume_change,
                                  body.material.polynomial.bulk_modulus, body.memory_age};
  const RelaxedPressure relaxed = relaxed_pressure(history, slot, j - 1);
  point.pressure = relaxed.pressure -
                   kernels::volumetric_slope(material, state.volume_ratio, Pack(1 / j)).get(0);
  for (int i = 0; i < D; ++i) point.stress[kernels::symmetric_index<D>(i, i)] = -point.pressure;
  Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
  f.topLeftCorner<D, D>() = shape.f;
  add_deviator<D>(stress.shear.get(0) / j, f * f.transpose(), point.stress);
  double energy = volumetric_energy(material, j) + relaxed.energy +
                  polynomial_energy(material, stress.excess.get(0));
  if (!body.prony_shear.empty()) energy += add_networks<T, D>(body, material, slot, f, point);
  return energy;
}

}  // namespace

template <class T, int D>
Point<D> stress_point_place(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell) {
  const CellMoments<D> moments = body.moments(slot);
  Point<D> x = body.lattice.node(cell);
  for (int a = 0; a < D; ++a) x[a] += (1 + moments[1 << a]) * body.lattice.spacing / 2;
  if (!body.is_fitted(cell)) return x;
  const auto corners = body.corners(cell);
  for (int c = 0; c < (1 << D); ++c) {
    const Point<D> shift = body.shift(corners[c]);
    for (int a = 0; a < D; ++a) x[a] += mean_weight<D>(moments, c) * shift[a];
  }
  return x;
}

template <class T, int D>
StressPoint<D> stress_point(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell,
                            double ahead) {
  const CellShape<D> shape = cell_shape<T, D>(body, slot, cell, ahead);
  const auto material = kernels::with_scalar<double>(body.material);
  StressPoint<D> point;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) point.deformation_gradient[i][j] = shape.f(i, j);
  }
  const kernels::CellState<Pack, D> state = cell_state<T, D>(body, shape);
  point.volume = shape.volume;
  point.volume_ratio = state.volume_ratio.get(0);
  double energy = 0;
  if (material.law == kernels::ElasticLaw::reduced_polynomial) {
    energy = take_polynomial<T, D>(body, material.polynomial, slot, state, shape, point);
  } else {
    const ElasticStress<D> elastic = elastic_stress<D>(material, row_by_row(point));
    point.pressure = elastic.pressure;
    point.stress = elastic.stress;
    energy = elastic_energy<D>(material, row_by_row(point)) +
             material.shear_modulus / 2 * state.hourglass.get(0);
  }
  if (body.is_prestressed()) energy += add_prestress(body, slot, point);
  point.energy = shape.volume * energy;
  return point;
}

template Point<2> stress_point_place<double, 2>(const Body<double, 2>&, std::int64_t,
                                                const Cell<2>&);
template Point<3> stress_point_place<double, 3>(const Body<double, 3>&, std::int64_t,
                                                const Cell<3>&);
template Point<2> stress_point_place<float, 2>(const Body<float, 2>&, std::int64_t, const Cell<2>&);
template Point<3> stress_point_place<float, 3>(const Body<float, 3>&, std::int64_t, const Cell<3>&);
template StressPoint<2> stress_point<double, 2>(const Body<double, 2>&, std::int64_t,
                                                const Cell<2>&, double);
template StressPoint<3> stress_point<double, 3>(const Body<double, 3>&, std::int64_t,
                                                const Cell<3>&, double);
template StressPoint<2> stress_point<float, 2>(const Body<float, 2>&, std::int64_t, const Cell<2>&,
                                               double);
template StressPoint<3> stress_point<float, 3>(const Body<float, 3>&, std::int64_t, const Cell<3>&,
                                               double);

}  // namespace pliant::total_lagrangian
