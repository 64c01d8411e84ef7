#pragma once

#include <array>
#include <cmath>

#include "kernels/remeshed/ghosts/ghost_state.hpp"

/// The traction of a wall on a body that may slide along it, and the ghost for it.
namespace pliant::kernels {

/// The shear of (RP.53) that prevents the body from sliding along the wall [Pa].
template <class T, int D>
VectorOf<T, D> holding_shear(const GhostFits<T, D>& fits, const WallSite<T, D>& wall,
                             const Impedance<T>& impedance) {
  const T away = separation_speed<T, D>(fits, wall);
  VectorOf<T, D> holding = shear<T, D>(fits.surface, wall.n);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const T slip = fits.surface.velocity(i) - wall.velocity[i] - away * wall.n[i];
    holding[i] = -holding[i] - impedance.shear_wave * slip;
  }
  return holding;
}

/// The traction of a wall on the body, (RP.73).
template <class T, int D>
struct WallTraction {
  T pressure;                 ///< n.(RP.53), negative where the wall would pull [Pa]
  VectorOf<T, D> shear = {};  ///< along the wall [Pa]
  bool slides;

  WallTraction(const GhostFits<T, D>& fits, const WallSite<T, D>& wall,
               const Impedance<T>& impedance)
      : pressure(wall_pressure<T, D>(fits, wall, wall.friction == 0, impedance)),
        slides(wall.friction == 0) {
    if (slides) return;
    shear = holding_shear<T, D>(fits, wall, impedance);
    T square = 0;
    for (const T component : shear) square += component * component;
    const T held = std::sqrt(square);
    slides = std::isfinite(wall.friction) && !(held <= wall.friction * pressure);
    if (!slides) return;
    pressure = wall_pressure<T, D>(fits, wall, true, impedance);
    const T share = held > 0 && pressure > 0 ? wall.friction * pressure / held : T(0);
    for (T& component : shear) component *= share;
  }
};

/// The traction of a wall on the body, (RP.89), (RP.73). The ghost contains all of (RP.51) and the
/// body near the wall nothing, so the surface between them has half of it.
template <class T, int D>
WallTraction<T, D> traction_on_wall(const GhostFits<T, D>& fits, const WallSite<T, D>& wall,
                                    const Impedance<T>& impedance) {
  const Impedance<T> half(impedance.pressure_wave / 2, impedance.shear_wave / 2);
  return {fits, wall, half};
}

/// The same as a force per area [Pa].
template <class T, int D>
VectorOf<T, D> wall_force_density(const GhostFits<T, D>& fits, const WallSite<T, D>& wall,
                                  const Impedance<T>& impedance) {
  const WallTraction<T, D> traction = traction_on_wall<T, D>(fits, wall, impedance);
  VectorOf<T, D> push;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) push[i] = traction.pressure * wall.n[i] + traction.shear[i];
  return push;
}

/// Whether the body slides along the wall, (RP.73).
template <class T, int D>
bool slides_along(const GhostFits<T, D>& fits, const WallSite<T, D>& wall,
                  const Impedance<T>& impedance) {
  return std::isfinite(wall.friction) && WallTraction<T, D>(fits, wall, impedance).slides;
}

/// The ghost of (RP.46) or (RP.47), depending on (RP.73).
template <class T, int D>
GhostState<T, D> friction_wall_ghost(const GhostFits<T, D>& fits, const WallSite<T, D>& wall,
                                     const Impedance<T>& impedance) {
  if (!std::isfinite(wall.friction)) return wall_ghost<T, D>(fits, wall, impedance);
  const WallTraction<T, D> traction(fits, wall, impedance);
  if (!traction.slides) return wall_ghost<T, D>(fits, wall, impedance);
  VectorOf<T, D> shear_load;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) shear_load[i] = -traction.shear[i];
  return slip_wall_ghost<T, D>(fits, wall, impedance, shear_load);
}

}  // namespace pliant::kernels
