#pragma once

#include <limits>

#include "kernels/pack.hpp"

// Roots and the logarithm from integer starting values and polynomials.
//
// Square root and division are the slowest instructions, and xsimd's functions use the fused
// multiply-add on AVX2 but not on AVX-512. These functions use additions, multiplications, and
// `fused`, so that AVX2 and AVX-512 agree bitwise. Starting values scale the bits of a
// floating-point number as if they were its logarithm.
namespace pliant::kernels {

template <class T>
struct Bits;

template <>
struct Bits<double> {
  using Integer = std::uint64_t;
  static constexpr int mantissa = 52;
  static constexpr Integer one = 0x3ff0000000000000;
  static constexpr Integer root_half = 0x3fe6a09e667f3bcd;  ///< of sqrt(1/2)
  static constexpr Integer square_root_start =
      0x5fe6eb50c7b537a9;  ///< 3/2 of `one`, minus the mean error
  static constexpr Integer cube_root_start = 0x553ef0ff289dd;  ///< 4/3 of `one`, likewise, >> 12
};

template <>
struct Bits<float> {
  using Integer = std::uint32_t;
  static constexpr int mantissa = 23;
  static constexpr Integer one = 0x3f800000;
  static constexpr Integer root_half = 0x3f3504f3;
  static constexpr Integer square_root_start = 0x5f375a86;
  static constexpr Integer cube_root_start = 0x2a517d;
};

template <class P>
using IntegerPack = xsimd::batch<typename Bits<Scalar<P>>::Integer, typename P::arch_type>;

/// 1/sqrt(x) for x >= 0 to one or two units in the last place; large and finite at 0.
template <class P>
inline P inverse_square_root(const P& x) {
  using T = Scalar<P>;
  using I = IntegerPack<P>;
  P y = xsimd::bitwise_cast<P>(I(Bits<T>::square_root_start) - (xsimd::bitwise_cast<I>(x) >> 1));
  // y <- y (1 - e)^(-1/2) with e = 1 - x y^2, as far as e^3: 0.07 -> 7e-6 -> rounding.
  for (int step = 0; step < 2; ++step) {
    const P e = fused_minus(x * y, y, P(T(1)));
    const P series = fused(fused(P(T(0.3125)), e, P(T(0.375))), e, P(T(0.5)));
    y = fused(y * e, series, y);
  }
  return y;
}

/// x^(-1/3) for x > 0 to a few units in the last place; NaN otherwise.
template <class P>
inline P inverse_cube_root(const P& x) {
  using T = Scalar<P>;
  using I = IntegerPack<P>;
  constexpr int sign_and_exponent = 8 * sizeof(T) - Bits<T>::mantissa;
  const P unit(T(typename Bits<T>::Integer(1) << Bits<T>::mantissa));
  // The upper bits of x as a number, times -1/3, and back: adding 2^mantissa puts an integer into
  // the mantissa, and shifting the exponent out brings it to its place.
  const I upper = (xsimd::bitwise_cast<I>(x) >> sign_and_exponent) | xsimd::bitwise_cast<I>(unit);
  const P third = (xsimd::bitwise_cast<P>(upper) - unit) * P(T(1) / T(3));
  const P start = (P(T(Bits<T>::cube_root_start)) - third) + unit;
  P y = xsimd::bitwise_cast<P>(xsimd::bitwise_cast<I>(start) << sign_and_exponent);
  // y <- y (1 - e)^(-1/3) with e = 1 - x y^3, as far as e^3.
  for (int step = 0; step < 2; ++step) {
    const P e = fused_minus(x * y, y * y, P(T(1)));
    const P series = fused(fused(P(T(14. / 81)), e, P(T(2. / 9))), e, P(T(1. / 3)));
    y = fused(y * e, series, y);
  }
  return xsimd::select(x > P(T(0)), y, P(std::numeric_limits<T>::quiet_NaN()));
}

/// ln x for normal x > 0 to about one unit in the last place (after fdlibm's log); NaN otherwise.
template <class P>
inline P logarithm(const P& x) {
  using T = Scalar<P>;
  using I = IntegerPack<P>;
  constexpr int mantissa = Bits<T>::mantissa;
  const P unit(T(typename Bits<T>::Integer(1) << mantissa));
  // x = 2^e m with m in [sqrt(1/2), sqrt(2)); the biased e becomes a number through the mantissa.
  const I bits = xsimd::bitwise_cast<I>(x);
  const I biased = (bits + I(Bits<T>::one - Bits<T>::root_half)) >> mantissa;
  const I bias(Bits<T>::one >> mantissa);
  const P e = xsimd::bitwise_cast<P>(biased | xsimd::bitwise_cast<I>(unit)) -
              (unit + P(T(Bits<T>::one >> mantissa)));
  const P m = xsimd::bitwise_cast<P>(bits - ((biased - bias) << mantissa));
  // ln m = 2 artanh s with s = f/(2 + f), f = m - 1.
  const P f = m - P(T(1));
  const P s = f / (f + P(T(2)));
  const P z = s * s;
  P series(T(0.1479819860511658591));
  series = fused(series, z, P(T(0.1531383769920937332)));
  series = fused(series, z, P(T(0.1818357216161805012)));
  series = fused(series, z, P(T(0.2222219843214978396)));
  series = fused(series, z, P(T(0.2857142874366239149)));
  series = fused(series, z, P(T(0.3999999999940941908)));
  series = fused(series, z, P(T(0.6666666666666735130)));
  const P half_square = P(T(0.5)) * f * f;
  const P correction = half_square - s * fused(series, z, half_square);
  constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
  const P value = fused(e, P(T(ln2_high)), f - (correction - e * P(T(ln2_low))));
  return xsimd::select(x > P(T(0)), value, P(std::numeric_limits<T>::quiet_NaN()));
}

}  // namespace pliant::kernels
