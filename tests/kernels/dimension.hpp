#pragma once

#include <gtest/gtest.h>

#include "kernels/instantiate.hpp"

namespace pliant::kernels::test {

/// Scalar type and dimension of a typed test.
template <class T, int D>
struct Dimension {
  using Scalar = T;
  static constexpr int dimension = D;
};

/// The library holds <double, 2> only; tests run the same templates for the others too.
using Dimensions = testing::Types<Dimension<double, 2>, Dimension<double, 3>, Dimension<float, 2>>;

template <class T, int D>
const Table<T, D>& baseline_table() {
  static constexpr Table<T, D> table = make_table<xsimd::batch<T, xsimd::sse2>, D>(Isa::sse2);
  return table;
}

/// What linear fields may lose: 1e-12 in double, the same number of units in float.
template <class T>
inline constexpr double exact = 4500 * std::numeric_limits<T>::epsilon();

}  // namespace pliant::kernels::test
