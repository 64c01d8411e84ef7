#pragma once

#include "kernels/remeshed/ghosts/ghost_state.hpp"

/// Tractions between two bodies at a point of their common surface.
namespace pliant::kernels {

/// The kind of an interface, in the words of case files.
enum class InterfaceKind { frictionless, no_slip, tied, coulomb };

/// (RP.75): limits a no-slip shear to at most `most` [Pa], in the same direction.
template <class T, int D>
void limit_shear(T most, VectorOf<T, D>& shear) {
  T square = 0;
  for (const T component : shear) square += component * component;
  const T held = std::sqrt(square);
  if (held <= most) return;
  for (T& component : shear) component *= most / held;
}

/// One side of an interface: the linear fit of a body at the point.
template <class T, int D>
struct InterfaceSide {
  RecordSum<T, D> surface;
  Impedance<T> impedance;
};

/// Whether Coulomb's law limits the shear of a traction.
template <class T, int D>
bool slides(const SurfaceLoad<T, D>& load, double friction) {
  constexpr double rounding = 1e-5;
  double square = 0;
  for (const T component : load.shear) square += static_cast<double>(component) * component;
  const double most = -friction * load.normal;
  return load.normal < 0 && square >= (1 - rounding) * most * most;
}

/// Velocity of the other body relative to `own` along their common surface.
template <class T, int D>
VectorOf<T, D> slip_velocity(const RecordSum<T, D>& own, const RecordSum<T, D>& other,
                             const VectorOf<T, D>& n) {
  VectorOf<T, D> slip;
  T opening = 0;
  for (int i = 0; i < D; ++i) {
    slip[i] = other.velocity(i) - own.velocity(i);
    opening += slip[i] * n[i];
  }
  for (int i = 0; i < D; ++i) slip[i] -= opening * n[i];
  return slip;
}

/// (RP.56): the traction on a plane with the normal n, out of `own`. `closing` is the velocity
/// [m/s] at which the gap between the surfaces is to vanish, negative where they overlap. Surfaces
/// that do not touch, but did before, push each other as long as their stress shows it. `friction`
/// is the coefficient of Coulomb's law, used by that kind only. `returning` is the velocity [m/s]
/// at which what was tied and has parted is to return.
template <class T, int D>
SurfaceLoad<T, D> interface_traction(const InterfaceSide<T, D>& own,
                                     const InterfaceSide<T, D>& other, const VectorOf<T, D>& n,
                                     T closing, InterfaceKind kind, T friction = 0,
                                     bool touches = true, const VectorOf<T, D>& returning = {}) {
  VectorOf<T, D> s_n, jump;
  const T own_nn = traction<T, D>(own.surface, n, s_n);
  const T other_nn = traction<T, D>(other.surface, n, s_n);
  SurfaceLoad<T, D> load{n, 0, {}};
  T opening = 0;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    jump[i] = other.surface.velocity(i) - own.surface.velocity(i) + returning[i];
    opening += jump[i] * n[i];
  }
  const auto resolve = [](T z, T z_other, T s, T s_other, T u) {
    return (z_other * s + z * s_other + z * z_other * u) / (z + z_other);
  };
  const auto normal = [&](T speed) {
    return resolve(own.impedance.pressure_wave, other.impedance.pressure_wave, own_nn, other_nn,
                   speed);
  };
  load.normal = normal(opening + closing);
  const bool pushes = load.normal < 0 && (touches || normal(closing) < 0);
  if (kind != InterfaceKind::tied && !pushes) {
    load.normal = 0;
    return load;
  }
  if (kind == InterfaceKind::frictionless) return load;
  const VectorOf<T, D> own_tau = shear<T, D>(own.surface, n);
  const VectorOf<T, D> other_tau = shear<T, D>(other.surface, n);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    load.shear[i] = resolve(own.impedance.shear_wave, other.impedance.shear_wave, own_tau[i],
                            other_tau[i], jump[i] - opening * n[i]);
  }
  if (kind == InterfaceKind::coulomb) limit_shear<T, D>(-friction * load.normal, load.shear);
  return load;
}

}  // namespace pliant::kernels
