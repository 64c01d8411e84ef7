#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "kernels/table.hpp"

namespace pliant::kernels::test {

/// Scalar type and dimension of a typed test.
template <class T, int D>
struct Dimension {
  using Scalar = T;
  static constexpr int dimension = D;
};

using Dimensions = testing::Types<Dimension<double, 2>, Dimension<double, 3>, Dimension<float, 2>>;

/// Tables that the library does not hold, compiled as it compiles its own. Records of float are
/// shorter than a register of AVX-512.
extern const Table<float, 2> sse2_table_float, avx2_table_float;

/// Kernels of any scalar type and dimension.
template <class T, int D>
const Table<T, D>& table_of(Isa isa) {
  if constexpr (std::is_same_v<T, float>) {
    return isa == Isa::sse2 ? sse2_table_float : avx2_table_float;
  } else {
    return table<T, D>(isa);
  }
}

template <class T, int D>
const Table<T, D>& baseline_table() {
  return table_of<T, D>(Isa::sse2);
}

/// What linear fields may lose: 1e-12 in double, the same number of units in float.
template <class T>
inline constexpr double exact = 4500 * std::numeric_limits<T>::epsilon();

}  // namespace pliant::kernels::test
