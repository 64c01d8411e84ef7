#include "engine/remeshed/observe/material_displacement.hpp"

#include <Eigen/Dense>
#include <limits>

namespace pliant::remeshed {

template <class T, int D>
Vector material_displacement(const Body<T, D>& body, const Vector& start) {
  const FieldStore<T, D>& f = body.stage[0];
  const Layout<D>& layout = body.population.layout;
  const double h = body.lattice.spacing;
  // d + xi is the displacement; node - d is where the particle started.
  const auto from_start = [&](std::int64_t p, const Cell<D>& cell) {
    Eigen::Matrix<double, D, 1> r;
    for (int a = 0; a < D; ++a) {
      r[a] = (body.lattice.node(a, cell[a]) - f.get(Field::displacement, a)[p] - start[a]) / h;
    }
    return r;
  };
  constexpr double radius = 2.6;
  Eigen::Matrix<double, D + 1, D + 1> normal = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  Eigen::Matrix<double, D + 1, D> right = Eigen::Matrix<double, D + 1, D>::Zero();
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (body.population.kind[p] != Kind::interior) return;
      const auto r = from_start(p, cell);
      const double fraction = r.squaredNorm() / (radius * radius);
      if (fraction >= 1) return;
      Eigen::Matrix<double, D + 1, 1> q;
      q << 1, r;
      normal += (1 - fraction) * (1 - fraction) * q * q.transpose();
      for (int a = 0; a < D; ++a) {
        const double d = f.get(Field::displacement, a)[p] + f.get(Field::drift, a)[p];
        right.col(a) += (1 - fraction) * (1 - fraction) * d * q;
      }
    });
  }
  const auto factors = normal.ldlt();
  const auto pivots = factors.vectorD();
  constexpr double singular = 1e-9;
  if (!(pivots.minCoeff() > singular * pivots.maxCoeff())) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    return {nothing, nothing, nothing};
  }
  const auto fit = factors.solve(right).eval();
  Vector displacement = {};
  for (int a = 0; a < D; ++a) displacement[a] = fit(0, a);
  return displacement;
}

template Vector material_displacement<double, 2>(const Body<double, 2>&, const Vector&);
template Vector material_displacement<double, 3>(const Body<double, 3>&, const Vector&);
template Vector material_displacement<float, 2>(const Body<float, 2>&, const Vector&);
template Vector material_displacement<float, 3>(const Body<float, 3>&, const Vector&);

}  // namespace pliant::remeshed
