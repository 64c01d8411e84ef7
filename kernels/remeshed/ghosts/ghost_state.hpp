#pragma once

#include <array>
#include <cmath>

#include "kernels/layout.hpp"
#include "kernels/remeshed/ghosts/arguments.hpp"

/// Velocity and stress of a ghost from the sums over its neighbours' records (see GhostSums). `T`
/// is a number, or at free surfaces a register of numbers.
///
/// With P = I - n n, a stress splits into its tangential block P s P, its normal part (n.s n) n n,
/// and its shear n tau + tau n, tau = P s n. A boundary condition takes each part either from the
/// unconstrained fit or from the fit that vanishes on the surface.
namespace pliant::kernels {

template <class T, int D>
using VectorOf = std::array<T, D>;
template <class T, int D>
using SymmetricOf = std::array<T, symmetric_components<D>>;

template <class T, int D>
struct GhostState {
  VectorOf<T, D> velocity;
  SymmetricOf<T, D> stress;
};

/// Views of one sum of records.
template <class T, int D>
struct RecordSum {
  using Place = RecordPlace<D>;
  const T* values;
  T velocity(int i) const { return values[Place::velocity + i]; }
  T stress(int i, int j) const { return values[Place::stress + symmetric_index<D>(i, j)]; }
  T level_set_gradient(int i) const { return values[Place::slope + i]; }
  T pressure() const { return values[Place::pressure]; }
};

/// 1/sqrt(x), and 0 for x close to 0; for registers see free_surface_ghosts.hpp.
template <class T>
struct InverseRoot {
  static T of(T square) { return square > T(1e-12) ? 1 / std::sqrt(square) : T(0); }
};

/// (RP.48); zero where the gradients cancel.
template <class T, int D>
VectorOf<T, D> unit_normal(const RecordSum<T, D>& sum) {
  T square = 0;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) square += sum.level_set_gradient(i) * sum.level_set_gradient(i);
  const T scale = InverseRoot<T>::of(square);
  VectorOf<T, D> n;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) n[i] = scale * sum.level_set_gradient(i);
  return n;
}

/// Computes s n and returns n.s n.
template <class T, int D>
T traction(const RecordSum<T, D>& sum, const VectorOf<T, D>& n, VectorOf<T, D>& s_n) {
  T s_nn = 0;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    s_n[i] = 0;
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) s_n[i] += sum.stress(i, j) * n[j];
    s_nn += n[i] * s_n[i];
  }
  return s_nn;
}

/// The stress of `sum` with its traction on the plane of normal n replaced by s_nn n + tau.
template <class T, int D>
SymmetricOf<T, D> with_traction(const RecordSum<T, D>& sum, const VectorOf<T, D>& n, T s_nn,
                                const VectorOf<T, D>& tau) {
  VectorOf<T, D> old;
  const T old_nn = traction<T, D>(sum, n, old);
  SymmetricOf<T, D> stress;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      const T tangential = sum.stress(i, j) - n[i] * old[j] - old[i] * n[j] + old_nn * n[i] * n[j];
      stress[symmetric_index<D>(i, j)] =
          tangential + s_nn * n[i] * n[j] + n[i] * tau[j] + tau[i] * n[j];
    }
  }
  return stress;
}

/// P s n.
template <class T, int D>
VectorOf<T, D> shear(const RecordSum<T, D>& sum, const VectorOf<T, D>& n) {
  VectorOf<T, D> tau;
  const T s_nn = traction<T, D>(sum, n, tau);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) tau[i] -= s_nn * n[i];
  return tau;
}

/// rho c of plane waves in a material at rest [Pa s/m].
template <class T>
struct Impedance {
  T pressure_wave, shear_wave;
  explicit Impedance(const Material<T>& m)
      : pressure_wave(std::sqrt(m.density * (m.bulk_modulus + m.shear_modulus * T(4) / T(3)))),
        shear_wave(std::sqrt(m.density * m.shear_modulus)) {}
  Impedance(const T& pressure, const T& shear) : pressure_wave(pressure), shear_wave(shear) {}
};

/// The three sums over a ghost's neighbours, with c, b and a of (RP.43) and (RP.44).
template <class T, int D>
struct GhostFits {
  RecordSum<T, D> linear, constrained, surface;
  T constrained_sum;  ///< sum_i b_gi
  T surface_sum;      ///< sum_i a_gi
};

/// Traction on a surface: its part along the normal n, and the rest.
template <class T, int D>
struct SurfaceLoad {
  VectorOf<T, D> n;
  T normal;
  VectorOf<T, D> shear;
};

/// The ghost of a surface under `load` in (RP.45), (RP.113), and `at_foot` in (RP.50); both have
/// the same normal.
template <class T, int D>
GhostState<T, D> loaded_surface_ghost(const GhostFits<T, D>& fits, const SurfaceLoad<T, D>& load,
                                      const SurfaceLoad<T, D>& at_foot,
                                      const Impedance<T>& impedance) {
  const VectorOf<T, D>& n = load.n;
  const T of_load = 1 - fits.constrained_sum;
  VectorOf<T, D> s_n;
  const T s_nn = traction<T, D>(fits.constrained, n, s_n) + load.normal * of_load;
  const T excess = traction<T, D>(fits.surface, n, s_n) - at_foot.normal * fits.surface_sum;
  VectorOf<T, D> tau = shear<T, D>(fits.constrained, n);
  VectorOf<T, D> excess_tau = shear<T, D>(fits.surface, n);
  GhostState<T, D> ghost;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    tau[i] += load.shear[i] * of_load;
    excess_tau[i] -= at_foot.shear[i] * fits.surface_sum;
    ghost.velocity[i] = fits.linear.velocity(i) - excess / impedance.pressure_wave * n[i] -
                        excess_tau[i] / impedance.shear_wave;
  }
  ghost.stress = with_traction<T, D>(fits.linear, n, s_nn, tau);
  return ghost;
}

/// The same for a free surface under `pressure`.
template <class T, int D>
GhostState<T, D> free_surface_ghost(const GhostFits<T, D>& fits, T pressure,
                                    const Impedance<T>& impedance) {
  SurfaceLoad<T, D> load{unit_normal<T, D>(fits.linear), -pressure, {}};
  load.shear.fill(T(0));
  return loaded_surface_ghost<T, D>(fits, load, load, impedance);
}

/// (RP.49): P Sbar P - p I with the ambient pressure `pressure`.
template <class T, int D>
GhostState<T, D> averaged_surface_ghost(RecordSum<T, D> mean, T pressure) {
  const VectorOf<T, D> n = unit_normal<T, D>(mean);
  std::array<T, record_width<D>> deviatoric;
  for (int k = 0; k < record_width<D>; ++k) deviatoric[k] = mean.values[k];
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i)
    deviatoric[RecordPlace<D>::stress + symmetric_index<D>(i, i)] += mean.pressure();
  GhostState<T, D> ghost;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) ghost.velocity[i] = mean.velocity(i);
  ghost.stress = with_traction<T, D>(RecordSum<T, D>{deviatoric.data()}, n, T(0), VectorOf<T, D>{});
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) ghost.stress[symmetric_index<D>(i, i)] -= pressure;
  return ghost;
}

/// The same for the wall of (RP.49).
template <class T, int D>
GhostState<T, D> averaged_wall_ghost(RecordSum<T, D> mean, const VectorOf<T, D>& wall_velocity) {
  GhostState<T, D> ghost;
  ghost.velocity = wall_velocity;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) ghost.stress[symmetric_index<D>(i, j)] = mean.stress(i, j);
  }
  return ghost;
}

/// The wall at one of its ghosts.
template <class T, int D>
struct WallSite {
  VectorOf<T, D> velocity;  ///< of the wall at the foot point [m/s]
  VectorOf<T, D> beyond;  ///< u_w of (RP.46), (RP.114) [m/s]; `velocity` if the wall does not turn
  VectorOf<T, D> n;       ///< its unit normal, into the body
  T friction;             ///< coefficient of Coulomb's law; 0: slip, infinity: no-slip
  T rise = 0;             ///< sigma_nn of the ghost minus that at a slip wall, (RP.79) [Pa]
};

/// w.n, the speed at which the body leaves the wall.
template <class T, int D>
T separation_speed(const GhostFits<T, D>& fits, const WallSite<T, D>& wall) {
  T speed = 0;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) speed += wall.n[i] * (fits.surface.velocity(i) - wall.velocity[i]);
  return speed;
}

/// u_g of (RP.46).
template <class T, int D>
VectorOf<T, D> wall_ghost_velocity(const GhostFits<T, D>& fits, const VectorOf<T, D>& wall) {
  VectorOf<T, D> u;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    u[i] = fits.constrained.velocity(i) + wall[i] * (1 - fits.constrained_sum);
  }
  return u;
}

/// The ghost of a no-slip wall, (RP.46), (RP.51).
template <class T, int D>
GhostState<T, D> wall_ghost(const GhostFits<T, D>& fits, const WallSite<T, D>& wall,
                            const Impedance<T>& impedance) {
  const VectorOf<T, D>& n = wall.n;
  const T away = separation_speed<T, D>(fits, wall);
  GhostState<T, D> ghost;
  ghost.velocity = wall_ghost_velocity<T, D>(fits, wall.beyond);
  VectorOf<T, D> slip;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    slip[i] = fits.surface.velocity(i) - wall.velocity[i] - away * n[i];
  }
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      ghost.stress[symmetric_index<D>(i, j)] =
          fits.linear.stress(i, j) + impedance.pressure_wave * away * n[i] * n[j] +
          impedance.shear_wave * (n[i] * slip[j] + slip[i] * n[j]);
    }
  }
  return ghost;
}

/// The ghost of a slip wall, (RP.47), (RP.50), (RP.51); `shear_load` is sigma_nt on the wall, from
/// friction.
template <class T, int D>
GhostState<T, D> slip_wall_ghost(const GhostFits<T, D>& fits, const WallSite<T, D>& wall,
                                 const Impedance<T>& impedance,
                                 const VectorOf<T, D>& shear_load = {}) {
  const VectorOf<T, D>& n = wall.n;
  const RecordSum<T, D>& at_wall = fits.surface;
  T jump = 0;  // of the normal velocity, from the wall to the ghost
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const T constrained =
        fits.constrained.velocity(i) + wall.beyond[i] * (1 - fits.constrained_sum);
    jump += n[i] * (constrained - at_wall.velocity(i));
  }
  const VectorOf<T, D> tau = shear<T, D>(at_wall, n);
  VectorOf<T, D> ghost_tau = shear<T, D>(fits.constrained, n);
  GhostState<T, D> ghost;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    ghost.velocity[i] =
        at_wall.velocity(i) + jump * n[i] + (tau[i] - shear_load[i]) / impedance.shear_wave;
    ghost_tau[i] += shear_load[i] * (1 - fits.constrained_sum);
  }
  VectorOf<T, D> s_n;
  const T s_nn = traction<T, D>(at_wall, n, s_n) + wall.rise +
                 impedance.pressure_wave * separation_speed<T, D>(fits, wall);
  ghost.stress = with_traction<T, D>(at_wall, n, s_nn, ghost_tau);
  return ghost;
}

/// n.(RP.53): pressure of a wall on the body, negative where it pulls [Pa].
template <class T, int D>
T wall_pressure(const GhostFits<T, D>& fits, const WallSite<T, D>& wall, bool slips,
                const Impedance<T>& impedance) {
  VectorOf<T, D> s_n;
  T s_nn = traction<T, D>(fits.surface, wall.n, s_n);
  // The mean of the ghost and of the body at the mirrored place, 2 f(x_f) - f(x_g).
  if (slips) s_nn += (s_nn + wall.rise - traction<T, D>(fits.linear, wall.n, s_n)) / 2;
  return -(s_nn + impedance.pressure_wave * separation_speed<T, D>(fits, wall));
}

}  // namespace pliant::kernels
