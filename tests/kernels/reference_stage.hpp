#pragma once

#include <Eigen/Dense>

#include "tests/kernels/body.hpp"

/// An independent implementation of a stage for comparison, particle by particle with small
/// matrices.
namespace pliant::kernels::test {

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;
template <int D>
using Column = Eigen::Matrix<double, D, 1>;

inline double reference_weight(Kernel kernel, double s) {
  const auto cube = [](double x) { return x > 0 ? x * x * x : 0; };
  switch (kernel) {
    case Kernel::quartic_spline:
      return s == 0 ? 1.25 : (cube(2.5 - s) - 5 * cube(1.5 - s) + 10 * cube(0.5 - s)) / (6 * s);
    case Kernel::quartic_spline_fit: {
      const double t = std::max(0., 1 - s * s / 6.25);
      return t * t * t * (0.76443 - 2.31468 * t + 2.5554 * t * t);
    }
    case Kernel::compact:
      return s < 1.75 ? std::pow(1 - s * s / (1.75 * 1.75), 4) : 0;
    case Kernel::fourth_order: {
      const double t = std::max(0., 1 - s * s / 6.25);
      return t * t *
             (0.6355763142948405 - 6.642571385553331 * t + 21.979141703042178 * t * t -
              30.394221495264024 * t * t * t + 15.422074863480338 * t * t * t * t);
    }
  }
  return 0;
}

template <class T, int D>
Matrix<D> symmetric_at(const Field<T>* fields, std::int64_t slot) {
  Matrix<D> m;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) m(i, j) = fields[symmetric_index<D>(i, j)][slot];
  }
  return m;
}

template <class T, int D>
Column<D> vector_at(const std::array<Field<T>, D>& fields, std::int64_t slot) {
  Column<D> v;
  for (int i = 0; i < D; ++i) v[i] = fields[i][slot];
  return v;
}

template <int D>
struct Rates {
  Column<D> drift, velocity;
  double volume;
  Matrix<D> material;
  double strain_rate;
};

/// The slot k steps along an axis from slot p.
template <int D>
std::int64_t slot_along(const Segment<D>& segment, std::int64_t p, int axis, int k) {
  const int dy = axis == 1 ? k : 0, dz = axis == 2 ? k : 0;
  return p + segment.neighbour_row[row_index<D>(dy, dz)] + (axis == 0 ? k : 0);
}

/// delta^4 f summed over the lattice lines through slot p: fluxes of third differences between
/// interior neighbours.
template <class T, int D>
double fourth_difference_at(const Field<T>& f, const Patch<T, D>& patch, const Segment<D>& segment,
                            std::int64_t p) {
  double sum = 0;
  for (int axis = 0; axis < D; ++axis) {
    const auto along = [&](int k) { return slot_along<D>(segment, p, axis, k); };
    const auto flux = [&](int k) {  // from the neighbour at k to the one at k + 1
      if (patch.interior[along(k)] == 0 || patch.interior[along(k + 1)] == 0) return 0.;
      return double(f[along(k + 2)]) - 3. * f[along(k + 1)] + 3. * f[along(k)] - f[along(k - 1)];
    };
    sum += flux(0) - flux(-1);
  }
  return sum;
}

/// -delta^6 f/4 summed over the lattice lines through slot p: fluxes of fifth differences between
/// interior neighbours with two more on each side, of third differences between others.
template <class T, int D>
double sixth_difference_at(const Field<T>& f, const Patch<T, D>& patch, const Segment<D>& segment,
                           std::int64_t p) {
  constexpr double third[] = {0, -1, 3, -3, 1, 0}, fifth[] = {-1, 5, -10, 10, -5, 1};
  double sum = 0;
  for (int axis = 0; axis < D; ++axis) {
    const auto along = [&](int k) { return slot_along<D>(segment, p, axis, k); };
    const auto flux = [&](int k) {  // from the neighbour at k to the one at k + 1
      if (patch.interior[along(k)] == 0 || patch.interior[along(k + 1)] == 0) return 0.;
      bool is_wide = true;
      double of_third = 0, of_fifth = 0;
      for (int j = 0; j < 6; ++j) {
        is_wide = is_wide && patch.interior[along(k - 2 + j)] != 0;
        of_third += third[j] * f[along(k - 2 + j)];
        of_fifth += fifth[j] * f[along(k - 2 + j)];
      }
      return is_wide ? -of_fifth / 4 : of_third;
    };
    sum += flux(0) - flux(-1);
  }
  return sum;
}

/// Half the derivative with respect to f_p of the sum of squared second differences of f between
/// interior slots on the lattice lines, by differences of the sum itself.
template <class T, int D>
double bending_force_at(const Field<T>& f, const Patch<T, D>& patch, const Segment<D>& segment,
                        std::int64_t p) {
  double slope = 0;
  for (int axis = 0; axis < D; ++axis) {
    const auto along = [&](int k) { return slot_along<D>(segment, p, axis, k); };
    const auto squares = [&](double moved) {
      double sum = 0;
      for (int k = -1; k <= 1; ++k) {
        double second = 0;
        bool inside = true;
        for (int j = -1; j <= 1; ++j) {
          inside = inside && patch.interior[along(k + j)] != 0;
          second += (j == 0 ? -2 : 1) * (f[along(k + j)] + (k + j == 0 ? moved : 0.));
        }
        if (inside) sum += second * second;
      }
      return sum;
    };
    slope += (squares(0.5) - squares(-0.5)) / 2;  // exact for squares
  }
  return slope;
}

/// The strain rate that gives a stress rate in Hooke's law, found by solving the equations.
template <class T, int D>
Matrix<D> hooke_inverse(const Material<T>& material, const Matrix<D>& stress) {
  const double lame = material.bulk_modulus - 2. / 3 * material.shear_modulus;
  const Matrix<D> normal_stiffness =
      Matrix<D>::Constant(lame) + 2 * double(material.shear_modulus) * Matrix<D>::Identity();
  const Column<D> stretching = normal_stiffness.inverse() * stress.diagonal();
  Matrix<D> strain = stress / (2 * double(material.shear_modulus));
  strain.diagonal() = stretching;
  return strain;
}

/// Rates of an interior particle of a body in state `q`: (RP.13) by (RP.20) or (RP.19), (RP.3) or
/// (RP.8), and (RP.23).
template <class T, int D>
Rates<D> reference_rates(const Body<T, D>& body, const State<T, D>& q, const Segment<D>& segment,
                         std::int64_t p) {
  const double h = body.patch.spacing;
  const int reach = stencil_reach(body.kernel);
  Matrix<D> moment = Matrix<D>::Zero(), velocity_sum = Matrix<D>::Zero();
  std::array<Matrix<D>, D> stress_sum;
  stress_sum.fill(Matrix<D>::Zero());
  const Matrix<D> sigma_p = symmetric_at<T, D>(q.stress.data(), p);
  for (int dz = D == 3 ? -reach : 0; dz <= (D == 3 ? reach : 0); ++dz) {
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const int cells[3] = {dx, dy, dz};
        const std::int64_t n = p + segment.neighbour_row[row_index<D>(dy, dz)] + dx;
        Column<D> d = vector_at<T, D>(q.drift, n) - vector_at<T, D>(q.drift, p);
        for (int i = 0; i < D; ++i) d[i] += cells[i] * h;
        double w = reference_weight(body.kernel, d.norm() / h);
        if (body.gradient_kind == Gradient::normalised) w *= q.volume[n];
        moment += w * d * d.transpose();
        velocity_sum +=
            w * (vector_at<T, D>(q.velocity, n) - vector_at<T, D>(q.velocity, p)) * d.transpose();
        const Matrix<D> difference = symmetric_at<T, D>(q.stress.data(), n) - sigma_p;
        for (int i = 0; i < D; ++i)
          stress_sum[i] += w * difference.row(i).transpose() * d.transpose();
      }
    }
  }
  if (body.gradient_kind == Gradient::normalised) moment = moment.diagonal().asDiagonal();
  const Matrix<D> inverse = moment.inverse();
  Matrix<D> relaxation;  // (RP.23)
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      const Field<T>& stress = q.stress[symmetric_index<D>(i, j)];
      relaxation(i, j) =
          -body.stress_dissipation * fourth_difference_at(stress, body.patch, segment, p);
    }
  }
  if (D == 3 || !body.relaxes_shear) {
    relaxation = (relaxation.trace() / D * Matrix<D>::Identity()).eval();
  }
  const Matrix<D> gradient =
      velocity_sum * inverse + hooke_inverse<T, D>(body.material, relaxation);
  Rates<D> rates;
  rates.drift = vector_at<T, D>(q.velocity, p);
  for (int i = 0; i < D; ++i) {
    const Matrix<D> gradient_of_row = stress_sum[i] * inverse;  // (j, k): d sigma_ij / dx_k
    const double difference = D == 2 ? fourth_difference_at(q.velocity[i], body.patch, segment, p)
                                     : sixth_difference_at(q.velocity[i], body.patch, segment, p);
    rates.velocity[i] = gradient_of_row.trace() * q.volume[p] / body.mass[p] -
                        body.velocity_dissipation *
                            (difference + body.restoring_rate *
                                              bending_force_at(q.drift[i], body.patch, segment, p));
  }
  rates.volume = q.volume[p] * gradient.trace();
  const Matrix<D> strain = (gradient + gradient.transpose()) / 2;
  const Matrix<D> spin = (gradient - gradient.transpose()) / 2;
  rates.strain_rate = strain.norm();
  if (carries_deformation(body.material.model)) {
    Matrix<D> f;
    for (int c = 0; c < D * D; ++c) f(c / D, c % D) = q.material[c][p];
    rates.material = gradient * f;
  } else {
    const Matrix<D> s = symmetric_at<T, D>(q.material.data(), p);
    rates.material =
        2 * body.material.shear_modulus * (strain - gradient.trace() / 3 * Matrix<D>::Identity()) +
        spin * s - s * spin;
  }
  return rates;
}

/// sigma of (RP.9), (PB.6) or (PB.7) in three dimensions.
template <class T, int D>
Eigen::Matrix3d reference_cauchy_stress(const Body<T, D>& body, const State<T, D>& q,
                                        std::int64_t p) {
  const Material<T>& m = body.material;
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d f = one;
  for (int c = 0; c < D * D; ++c) f(c / D, c % D) = q.material[c][p];
  const double j = f.determinant(), mu = m.shear_modulus, lambda = m.bulk_modulus - 2. / 3 * mu;
  if (m.model == Model::neo_hookean) {
    return mu / j * (f * f.transpose() - one) + lambda * (j - 1) * one;
  }
  if (m.model == Model::st_venant_kirchhoff) {
    const Eigen::Matrix3d e = (f.transpose() * f - one) / 2;
    return f * (lambda * e.trace() * one + 2 * mu * e) * f.transpose() / j;
  }
  const Eigen::Matrix3d b = std::pow(j, -2. / 3) * f * f.transpose();
  double slope = 0;
  for (int n = 1; n <= m.order; ++n) {
    slope += n * m.coefficient[n - 1] * std::pow(b.trace() - 3, n - 1);
  }
  return 2 / j * slope * (b - b.trace() / 3 * one) + 2 / m.compressibility * (j - 1) * one;
}

/// sigma of (RP.2).
template <class T, int D>
Matrix<D> reference_stress(const Body<T, D>& body, const State<T, D>& q, std::int64_t p) {
  const Material<T>& m = body.material;
  if (carries_deformation(m.model)) {
    return reference_cauchy_stress(body, q, p).template topLeftCorner<D, D>();
  }
  const double ratio = body.mass[p] / q.volume[p] / m.density;
  const double pressure = m.bulk_modulus * (m.model == Model::linear ? ratio - 1 : std::log(ratio));
  return symmetric_at<T, D>(q.material.data(), p) - pressure * Matrix<D>::Identity();
}

}  // namespace pliant::kernels::test
