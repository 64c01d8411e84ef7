#pragma once

/// Tensor-product cubic interpolation between the 4^D nodes around a cell: in each direction the
/// cubic through the nodes -1, 0, 1, 2. `P` is a number or a register of numbers.
namespace pliant::kernels {

/// Weights of the four nodes at 0 <= s < 1, and their derivatives.
template <class P>
struct CubicWeights {
  P value[4], slope[4];

  CubicWeights() = default;
  explicit CubicWeights(const P& s) {
    const P one(1), two(2), three(3), four(4), half(0.5), sixth(1.0 / 6);
    const P below = s - one, above = s + one, far = s - two, square = three * s * s;
    value[0] = -sixth * s * below * far;
    value[1] = half * above * below * far;
    value[2] = -half * above * s * far;
    value[3] = sixth * above * s * below;
    slope[0] = -sixth * (square - three * two * s + two);
    slope[1] = half * (square - four * s - one);
    slope[2] = -half * (square - two * s - two);
    slope[3] = sixth * (square - one);
  }
};

/// Value and gradient, lengths in cells; `node(n)` is the value at a node, x fastest.
template <class P, class Node>
inline void interpolate(const CubicWeights<P> (&weight)[2], const Node& node, P& value,
                        P (&gradient)[2]) {
  value = gradient[0] = gradient[1] = P(0);
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i) {
    P f(0), df(0);
#pragma GCC unroll 4
    for (int j = 0; j < 4; ++j) {
      const P at = node(4 * j + i);
      f += weight[1].value[j] * at;
      df += weight[1].slope[j] * at;
    }
    value += weight[0].value[i] * f;
    gradient[0] += weight[0].slope[i] * f;
    gradient[1] += weight[0].value[i] * df;
  }
}

template <class P, class Node>
inline void interpolate(const CubicWeights<P> (&weight)[3], const Node& node, P& value,
                        P (&gradient)[3]) {
  value = gradient[0] = gradient[1] = gradient[2] = P(0);
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i) {
    P f(0), df_dy(0), df_dz(0);
#pragma GCC unroll 4
    for (int j = 0; j < 4; ++j) {
      P along(0), slope(0);
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) {
        const P at = node(16 * k + 4 * j + i);
        along += weight[2].value[k] * at;
        slope += weight[2].slope[k] * at;
      }
      f += weight[1].value[j] * along;
      df_dy += weight[1].slope[j] * along;
      df_dz += weight[1].value[j] * slope;
    }
    value += weight[0].value[i] * f;
    gradient[0] += weight[0].slope[i] * f;
    gradient[1] += weight[0].value[i] * df_dy;
    gradient[2] += weight[0].value[i] * df_dz;
  }
}

}  // namespace pliant::kernels
