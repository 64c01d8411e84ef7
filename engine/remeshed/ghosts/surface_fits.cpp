#include "engine/remeshed/ghosts/surface_fits.hpp"

#include <Eigen/Dense>
#include <array>

#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

namespace {

/// Solves M x = e for each column e of `at`, with M = sum_i w_i q_i q_i^T; false if M is almost
/// singular.
template <int N, int K, class Basis, int D>
bool solve_fit(const FitParticles<D>& particles, const Basis& basis,
               const Eigen::Matrix<double, N, K>& at, Eigen::Matrix<double, N, K>& solution) {
  std::array<double, N*(N + 1) / 2> sum = {};
  for (const FitParticle<D>& i : particles) {
    const Eigen::Matrix<double, N, 1> q = basis(i);
    for (int row = 0, entry = 0; row < N; ++row) {
      const double weighted = i.weight * q[row];
      for (int column = 0; column <= row; ++column) sum[entry++] += weighted * q[column];
    }
  }
  Eigen::Matrix<double, N, N> normal;
  for (int row = 0, entry = 0; row < N; ++row) {
    for (int column = 0; column <= row; ++column) {
      normal(row, column) = normal(column, row) = sum[entry++];
    }
  }
  const Eigen::LDLT<Eigen::Matrix<double, N, N>> factor(normal);
  const auto pivots = factor.vectorD();
  if (!(pivots.minCoeff() > kernels::smallest_pivot * pivots.maxCoeff())) return false;
  solution = factor.solve(at);
  return true;
}

/// {phi, phi t[, phi t2], phi^2}; the last term only if N = D + 1.
template <int N, int D>
class ConstrainedBasis {
 public:
  explicit ConstrainedBasis(const Position<D>& normal) {
    if constexpr (D == 2) {
      tangent_[0] = {-normal[1], normal[0]};
    } else {
      tangent_[0] = normal.unitOrthogonal();
      tangent_[1] = normal.cross(tangent_[0]);
    }
  }

  Eigen::Matrix<double, N, 1> operator()(double distance, const Position<D>& position) const {
    Eigen::Matrix<double, N, 1> q;
    q[0] = distance;
    for (int k = 1; k < D; ++k) q[k] = distance * tangent_[k - 1].dot(position);
    if constexpr (N > D) q[D] = distance * distance;
    return q;
  }

  /// The gradient of the terms along the surface, divided by phi.
  Position<D> along(const Eigen::Matrix<double, N, 1>& x) const {
    Position<D> sum = Position<D>::Zero();
    for (int k = 1; k < D; ++k) sum += x[k] * tangent_[k - 1];
    return sum;
  }

 private:
  std::array<Position<D>, D - 1> tangent_;
};

/// (RP.43) at the ghost and at the foot point, in {1, x, y[, z]} or {1, n.x}.
template <int N, int D, class Basis>
bool solve_linear(const FitParticles<D>& particles, const Basis& basis, const Position<D>& ghost,
                  Eigen::Matrix<double, N, 2>& x) {
  const auto of_neighbour = [&](const FitParticle<D>& i) { return basis(i.position); };
  Eigen::Matrix<double, N, 2> at;
  at << basis(ghost), basis(Position<D>::Zero());
  return solve_fit<N, 2>(particles, of_neighbour, at, x);
}

template <class T, std::size_t N>
void put(double constant, const auto& slope, std::array<T, N>& terms) {
  terms[0] = static_cast<T>(constant);
  for (int a = 0; a < slope.size(); ++a) terms[a + 1] = static_cast<T>(slope[a]);
}

template <int N, class T, int D>
bool fit_constrained_in(const FitParticles<D>& particles, const FitSite<D>& site,
                        kernels::FitTerms<T, D>& terms) {
  const ConstrainedBasis<N, D> in(site.normal);
  const auto basis = [&](const FitParticle<D>& i) { return in(i.surface_distance, i.position); };
  Eigen::Matrix<double, N, 1> x;
  const Eigen::Matrix<double, N, 1> at = in(site.surface_distance, site.ghost);
  if (!solve_fit<N, 1>(particles, basis, at, x)) return false;
  put(x[0], in.along(x), terms.constrained);
  terms.constrained[D + 1] = N > D ? static_cast<T>(x[N - 1]) : T(0);
  return true;
}

}  // namespace

template <class T, int D>
bool fit_in_all_directions(const FitParticles<D>& particles, const FitSite<D>& site,
                           kernels::FitTerms<T, D>& terms) {
  const auto basis = [](const Position<D>& x) {
    Eigen::Matrix<double, D + 1, 1> q;
    q << 1, x;
    return q;
  };
  Eigen::Matrix<double, D + 1, 2> x;
  if (!solve_linear<D + 1, D>(particles, basis, site.ghost, x)) return false;
  put(x(0, 0), x.col(0).template tail<D>(), terms.linear);
  put(x(0, 1), x.col(1).template tail<D>(), terms.surface);
  return true;
}

template <class T, int D>
bool fit_along_normal(const FitParticles<D>& particles, const FitSite<D>& site,
                      kernels::FitTerms<T, D>& terms) {
  const auto basis = [&](const Position<D>& x) { return Eigen::Vector2d(1, site.normal.dot(x)); };
  Eigen::Matrix<double, 2, 2> x;
  if (!solve_linear<2, D>(particles, basis, site.ghost, x)) return false;
  put(x(0, 0), Position<D>(x(1, 0) * site.normal), terms.linear);
  put(x(0, 1), Position<D>(x(1, 1) * site.normal), terms.surface);
  return true;
}

template <class T, int D>
bool fit_constrained(const FitParticles<D>& particles, const FitSite<D>& site, double curved,
                     kernels::FitTerms<T, D>& terms) {
  const bool is_curved = curved > 0 && fit_constrained_in<D + 1>(particles, site, terms);
  if (is_curved && curved == 1) return true;
  const std::array<T, D + 2> with = terms.constrained;
  const bool is_plain = fit_constrained_in<D>(particles, site, terms);
  if (!is_curved) return is_plain;
  for (std::size_t i = 0; i < with.size(); ++i) {
    T& mean = terms.constrained[i];
    mean = is_plain ? mean + static_cast<T>(curved) * (with[i] - mean) : with[i];
  }
  return true;
}

template <class T, int D>
bool fit_proportional(const FitParticles<D>& particles, const FitSite<D>& site,
                      kernels::FitTerms<T, D>& terms) {
  double square = 0;
  for (const FitParticle<D>& i : particles) {
    square += i.weight * i.surface_distance * i.surface_distance;
  }
  if (!(square > 1e-3)) return false;
  put(site.surface_distance / square, Position<D>(Position<D>::Zero()), terms.constrained);
  return true;
}

template bool fit_in_all_directions<double, 2>(const FitParticles<2>&, const FitSite<2>&,
                                               kernels::FitTerms<double, 2>&);
template bool fit_along_normal<double, 2>(const FitParticles<2>&, const FitSite<2>&,
                                          kernels::FitTerms<double, 2>&);
template bool fit_constrained<double, 2>(const FitParticles<2>&, const FitSite<2>&, double,
                                         kernels::FitTerms<double, 2>&);
template bool fit_proportional<double, 2>(const FitParticles<2>&, const FitSite<2>&,
                                          kernels::FitTerms<double, 2>&);
template bool fit_in_all_directions<double, 3>(const FitParticles<3>&, const FitSite<3>&,
                                               kernels::FitTerms<double, 3>&);
template bool fit_along_normal<double, 3>(const FitParticles<3>&, const FitSite<3>&,
                                          kernels::FitTerms<double, 3>&);
template bool fit_constrained<double, 3>(const FitParticles<3>&, const FitSite<3>&, double,
                                         kernels::FitTerms<double, 3>&);
template bool fit_proportional<double, 3>(const FitParticles<3>&, const FitSite<3>&,
                                          kernels::FitTerms<double, 3>&);
template bool fit_in_all_directions<float, 2>(const FitParticles<2>&, const FitSite<2>&,
                                              kernels::FitTerms<float, 2>&);
template bool fit_along_normal<float, 2>(const FitParticles<2>&, const FitSite<2>&,
                                         kernels::FitTerms<float, 2>&);
template bool fit_constrained<float, 2>(const FitParticles<2>&, const FitSite<2>&, double,
                                        kernels::FitTerms<float, 2>&);
template bool fit_proportional<float, 2>(const FitParticles<2>&, const FitSite<2>&,
                                         kernels::FitTerms<float, 2>&);
template bool fit_in_all_directions<float, 3>(const FitParticles<3>&, const FitSite<3>&,
                                              kernels::FitTerms<float, 3>&);
template bool fit_along_normal<float, 3>(const FitParticles<3>&, const FitSite<3>&,
                                         kernels::FitTerms<float, 3>&);
template bool fit_constrained<float, 3>(const FitParticles<3>&, const FitSite<3>&, double,
                                        kernels::FitTerms<float, 3>&);
template bool fit_proportional<float, 3>(const FitParticles<3>&, const FitSite<3>&,
                                         kernels::FitTerms<float, 3>&);

}  // namespace pliant::remeshed
