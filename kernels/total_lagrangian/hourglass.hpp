#pragma once

#include "kernels/pack.hpp"
#include "kernels/total_lagrangian/arguments.hpp"

/// The energy of hourglass modes and its derivatives, (TL.6) and (TL.17).
///
/// In 3D a cell has nine modes with two directions: points move along a, by the product of the
/// coordinates in the two directions other than c. If a and c differ, the mode bends the cell:
/// fibres along a are longer on one side. If they are equal, it twists the cell.
///
///     bends    u_x = x y and u_z = z y, x z and y z, y x and z x
///     twists   u_x = y z, u_y = x z, u_z = x y
///
/// Both bending modes of a pair lengthen fibres across the same plane. In the frame of the
/// material, where C = F^T A with the modes A_c, they are C_ac and C_ca.
namespace pliant::kernels {

/// c_b h^2 of (TL.6), by the number of directions.
template <int D>
inline constexpr double mode_weights[] = {0, 0, 8. / 3 / (1 << 2 * D), 4. / 3 / (1 << 2 * D)};

/// The mode with the two directions other than `c`, in 3D.
inline constexpr int mode_across[] = {6, 5, 3};

/// Coefficients of the energy [1/m^2].
template <class P, int D>
struct HourglassWeights {
  using T = Scalar<P>;
  T two, three;  ///< kappa c_b of modes with two and with three directions
  T bending, saddle;

  HourglassWeights(const HourglassStiffness<T>& stiffness, T spacing) {
    const T c2 = T(mode_weights<D>[2]) / (spacing * spacing);
    two = c2 * stiffness.modes;
    three = T(mode_weights<D>[3]) / (spacing * spacing) * stiffness.triple;
    bending = c2 * stiffness.bending;
    saddle = c2 * stiffness.saddle;
  }
};

/// Half the derivative of those terms of (TL.17) that depend on C, with respect to C_ac for a != c.
template <class P>
struct BendingForces {
  P value[3][3];

  BendingForces(const HourglassWeights<P, 3>& weights, const P (&f)[9], const P (&mode)[3][8]) {
    const P bending(weights.bending), saddle(weights.saddle);
#pragma GCC unroll 3
    for (int c = 0; c < 3; ++c) {
#pragma GCC unroll 3
      for (int a = 0; a < c; ++a) {
        const P one = along(f, mode, a, c), other = along(f, mode, c, a);
        const P both = saddle * (one + other);
        value[a][c] = fused(bending, one, both);
        value[c][a] = fused(bending, other, both);
      }
    }
  }

 private:
  // C_ac
  static P along(const P (&f)[9], const P (&mode)[3][8], int a, int c) {
    P sum = f[a] * mode[0][mode_across[c]];
    sum = fused(f[3 + a], mode[1][mode_across[c]], sum);
    return fused(f[6 + a], mode[2][mode_across[c]], sum);
  }
};

/// Q of (TL.6) from F and the modes [component][mode]. Replaces the modes by half the derivatives
/// with respect to them, and adds half the derivative with respect to F to `by_f`.
template <class P, int D>
inline P hourglass_squares(const HourglassWeights<P, D>& weights, const P (&f)[D * D],
                           P (&mode)[D][1 << D], P (&by_f)[D * D]) {
  P sum(Scalar<P>(0));
  if constexpr (D == 2) {
    const P weight(weights.two);
    for (P(&of_component)[1 << D] : mode) {
      const P slope = weight * of_component[3];
      sum = fused(slope, of_component[3], sum);
      of_component[3] = slope;
    }
  } else {
    const BendingForces<P> bending(weights, f, mode);
    const P two(weights.two), three(weights.three);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      P slope[3];
#pragma GCC unroll 3
      for (int c = 0; c < 3; ++c) {
        slope[c] = two * mode[i][mode_across[c]];
#pragma GCC unroll 3
        for (int a = 0; a < 3; ++a) {
          if (a == c) continue;
          const P& force = bending.value[a][c];
          slope[c] = fused(f[3 * i + a], force, slope[c]);
          by_f[3 * i + a] = fused(mode[i][mode_across[c]], force, by_f[3 * i + a]);
        }
      }
#pragma GCC unroll 3
      for (int c = 0; c < 3; ++c) {
        sum = fused(slope[c], mode[i][mode_across[c]], sum);
        mode[i][mode_across[c]] = slope[c];
      }
      const P slope_of_all = three * mode[i][7];
      sum = fused(slope_of_all, mode[i][7], sum);
      mode[i][7] = slope_of_all;
    }
  }
  return sum;
}

}  // namespace pliant::kernels
