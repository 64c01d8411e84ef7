#pragma once

#include "kernels/pack.hpp"
#include "kernels/total_lagrangian/arguments.hpp"

/// The energy of hourglass modes, (TL.6) and (TL.17), and its derivatives.
///
/// In 3D a cell has nine modes of two directions, each one direction in which points move, a, and
/// two across which they do, m. Six of them bend the cell, where a is one of m: fibres along a are
/// longer on one side, g, the other of m. Three of them twist it, where a is the third direction.
///
///     bend            pairs with          twist           pairs with
///     u_x = y x       u_z = y z           u_x = y z       u_y = x z, u_z = x y
namespace pliant::kernels {

/// c_b h^2 of (TL.6) by the number of directions.
template <int D>
inline constexpr double mode_weights[] = {0, 0, 8. / 3 / (1 << 2 * D), 4. / 3 / (1 << 2 * D)};

/// What hourglass modes add to the mean of I1 over a cell, and what its derivatives need.
template <class P, int D>
class Hourglass {
 public:
  using T = Scalar<P>;

  Hourglass(const HourglassStiffness<T>& stiffness, T spacing) {
    for (int n = 0; n <= D; ++n) {
      weight_[n] = stiffness.modes * T(mode_weights<D>[n]) / (spacing * spacing);
    }
    bending_ = stiffness.bending * T(mode_weights<D>[2]) / (spacing * spacing);
    twisting_ = stiffness.twisting * T(mode_weights<D>[2]) / (spacing * spacing);
  }

  /// Q of (TL.6) from F and the modes [component][mode].
  P squares(const P (&f)[D * D], const P (&mode)[D][1 << D]) {
    P sum(T(0));
#pragma GCC unroll 3
    for (int n = 2; n <= D; ++n) {
      P of_n(T(0));
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
#pragma GCC unroll 8
        for (int m = 1; m < (1 << D); ++m) {
          if (directions_of[m] == n) of_n = fused(mode[i][m], mode[i][m], of_n);
        }
      }
      sum = fused(P(weight_[n]), of_n, sum);
    }
    if constexpr (D == 3) sum = sum + couple(f, mode);
    return sum;
  }

  /// Half the derivative of Q by component `i` of mode `m`.
  P slope(const P (&f)[D * D], const P (&mode)[D][1 << D], int i, int m) const {
    P slope = P(weight_[directions_of[m]]) * mode[i][m];
    if constexpr (D == 3) {
      if (directions_of[m] == 2) {
#pragma GCC unroll 3
        for (int a = 0; a < D; ++a) slope = fused(f[D * i + a], coupling(a, m), slope);
      }
    }
    return slope;
  }

  /// Adds its derivative by F at given modes, times `factor`/2.
  void add_stress(const P& factor, const P (&mode)[D][1 << D], P (&piola)[D * D]) const {
    if constexpr (D == 3) {
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
        for (int a = 0; a < D; ++a) {
          P sum = coupling(a, 3) * mode[i][3];
          sum = fused(coupling(a, 5), mode[i][5], sum);
          sum = fused(coupling(a, 6), mode[i][6], sum);
          piola[D * i + a] = fused(factor, sum, piola[D * i + a]);
        }
      }
    }
  }

 private:
  static constexpr int all = (1 << D) - 1;
  static constexpr int axis_of[] = {0, 0, 1, 1, 2};  // by the bit of a direction

  // By the mode of two directions `m`, half the derivative of the coupled terms by (F^T q_m)_a.
  const P& coupling(int a, int m) const {
    return m >> a & 1 ? bend_[axis_of[m ^ 1 << a]] : twist_[a];
  }

  // (TL.17)
  P couple(const P (&f)[D * D], const P (&mode)[D][1 << D]) {
    P twist[D], all_twist(T(0)), sum(T(0));
#pragma GCC unroll 3
    for (int g = 0; g < D; ++g) {
      P bend(T(0));
      twist[g] = P(T(0));
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
        for (int a = 0; a < D; ++a) {
          if (a != g) bend = fused(f[D * i + a], mode[i][1 << a | 1 << g], bend);
        }
        twist[g] = fused(f[D * i + g], mode[i][all ^ 1 << g], twist[g]);
      }
      all_twist = all_twist + twist[g];
      bend_[g] = P(bending_) * bend;
      sum = fused(bend_[g], bend, sum);
    }
#pragma GCC unroll 3
    for (int g = 0; g < D; ++g) {
      twist_[g] = P(twisting_ / 2) * (all_twist - twist[g]);
      sum = fused(twist_[g], twist[g], sum);
    }
    return sum;
  }

  T weight_[D + 1];  // kappa c_b by the number of directions of b [1/m^2]
  T bending_, twisting_;
  P bend_[D], twist_[D];  // by the direction across which a bend changes, and that of a twist
};

}  // namespace pliant::kernels
