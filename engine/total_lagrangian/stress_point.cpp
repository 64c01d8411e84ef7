#include "engine/total_lagrangian/stress_point.hpp"

#include <cmath>

#include "kernels/energy.hpp"
#include "kernels/law.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::total_lagrangian {

namespace {

// [component][mode], (TL.2).
template <class T, int D>
std::array<std::array<double, (1 << D)>, D> modes(const Body<T, D>& body, const Cell<D>& cell) {
  std::array<std::array<double, (1 << D)>, D> mode = {};
  const auto corners = body.corners(cell);
  for (int c = 0; c < (1 << D); ++c) {
    for (int m = 0; m < (1 << D); ++m) {
      int sign = 1;
      for (int a = 0; a < D; ++a) {
        if (m >> a & 1) sign *= c >> a & 1 ? 1 : -1;
      }
      for (int i = 0; i < D; ++i) mode[i][m] += sign * body.displacement[i][corners[c]];
    }
  }
  return mode;
}

}  // namespace

template <class T, int D>
StressPoint<D> stress_point(const Body<T, D>& body, std::int64_t slot, const Cell<D>& cell,
                            double hourglass) {
  using Pack = xsimd::batch<double, xsimd::sse2>;
  using Law = kernels::Law<kernels::Model::reduced_polynomial, Pack, D>;
  const auto mode = modes<T, D>(body, cell);
  const double h = body.lattice.spacing;
  const auto material = kernels::with_scalar<double>(body.material);
  StressPoint<D> point;
  std::array<double, D * D> f;
  Pack packed[D * D];
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      f[D * i + j] = (i == j ? 1 : 0) + mode[i][1 << j] * 2 / ((1 << D) * h);
      packed[D * i + j] = Pack(f[D * i + j]);
      point.deformation_gradient[i][j] = f[D * i + j];
    }
  }
  Pack sigma[Law::symmetric];
  Law::stress(material, packed, Pack(1.0), sigma);
  for (int c = 0; c < Law::symmetric; ++c) point.stress[c] = sigma[c].get(0);
  point.pressure = Law::pressure(material, packed, Pack(1.0)).get(0);
  point.volume_ratio = kernels::determinant(packed).get(0);

  const Pack excess = kernels::isochoric_strain<Pack, D>(packed).excess;
  const double modulus = 2 * kernels::half_tangent_modulus(material, excess).get(0);
  double squares = 0;
  for (int i = 0; i < D; ++i) {
    for (int m = 1; m < (1 << D); ++m) {
      if (m & (m - 1)) squares += mode[i][m] * mode[i][m];
    }
  }
  const double volume = body.fraction[slot] * std::pow(h, D);
  const double resistance = hourglass * modulus * volume * 8 / (3.0 * (1 << 2 * D) * h * h);
  // The energy of (RP.63) is per current volume.
  point.energy =
      volume * point.volume_ratio * kernels::polynomial_energy<double, D>(material, f.data()) +
      resistance * squares / 2;
  return point;
}

template StressPoint<2> stress_point<double, 2>(const Body<double, 2>&, std::int64_t,
                                                const Cell<2>&, double);
template StressPoint<3> stress_point<double, 3>(const Body<double, 3>&, std::int64_t,
                                                const Cell<3>&, double);
template StressPoint<2> stress_point<float, 2>(const Body<float, 2>&, std::int64_t, const Cell<2>&,
                                               double);
template StressPoint<3> stress_point<float, 3>(const Body<float, 3>&, std::int64_t, const Cell<3>&,
                                               double);

}  // namespace pliant::total_lagrangian
