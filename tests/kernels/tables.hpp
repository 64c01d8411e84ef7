#pragma once

#include <gtest/gtest.h>

#include <limits>

#include "kernels/remeshed/table.hpp"

namespace pliant::kernels::test {

/// Scalar type and dimension of a typed test.
template <class T, int D>
struct Dimension {
  using Scalar = T;
  static constexpr int dimension = D;
};

using Dimensions = testing::Types<Dimension<double, 2>, Dimension<double, 3>, Dimension<float, 2>,
                                  Dimension<float, 3>>;

template <class T, int D>
const RemeshedTable<T, D>& baseline_table() {
  return RemeshedTable<T, D>::of(Isa::sse2);
}

/// Tolerance for linear fields: 1e-12 in double, the same number of units in float.
template <class T>
inline constexpr double exact = 4500 * std::numeric_limits<T>::epsilon();

}  // namespace pliant::kernels::test
