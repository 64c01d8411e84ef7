#include "engine/remeshed/surface_fits.hpp"

#include <Eigen/Dense>
#include <array>

#include "kernels/table.hpp"

namespace pliant::remeshed {

namespace {

/// Solves M x = e for each column e of `at` where M = sum_i w_i q_i q_i^T; false when M is (nearly)
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

/// {phi, phi t[, phi t2], phi^2} without its last term unless N = D + 1.
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

 private:
  std::array<Position<D>, D - 1> tangent_;
};

/// Coefficients of (RP.32) at the ghost and at the foot point, in {1, x, y[, z]} or {1, n.x}.
template <int N, int D, class Basis>
bool fit_linear(const FitParticles<D>& particles, const Basis& basis, const Position<D>& ghost,
                std::vector<double>& c, std::vector<double>& a) {
  const auto of_neighbour = [&](const FitParticle<D>& i) { return basis(i.position); };
  Eigen::Matrix<double, N, 2> at, x;
  at << basis(ghost), basis(Position<D>::Zero());
  if (!solve_fit<N, 2>(particles, of_neighbour, at, x)) return false;
  for (const FitParticle<D>& i : particles) {
    const Eigen::Matrix<double, N, 1> q = basis(i.position);
    c.push_back(i.weight * q.dot(x.col(0)));
    a.push_back(i.weight * q.dot(x.col(1)));
  }
  return true;
}

template <int N, int D>
bool fit_constrained_in(const FitParticles<D>& particles, const FitSite<D>& site,
                        std::vector<double>& b) {
  const ConstrainedBasis<N, D> terms(site.normal);
  const auto basis = [&](const FitParticle<D>& i) { return terms(i.surface_distance, i.position); };
  Eigen::Matrix<double, N, 1> x;
  const Eigen::Matrix<double, N, 1> at = terms(site.surface_distance, site.ghost);
  if (!solve_fit<N, 1>(particles, basis, at, x)) return false;
  for (const FitParticle<D>& i : particles) b.push_back(i.weight * basis(i).dot(x));
  return true;
}

}  // namespace

template <int D>
bool fit_in_all_directions(const FitParticles<D>& particles, const FitSite<D>& site,
                           std::vector<double>& c, std::vector<double>& a) {
  const auto basis = [](const Position<D>& x) {
    Eigen::Matrix<double, D + 1, 1> q;
    q << 1, x;
    return q;
  };
  return fit_linear<D + 1, D>(particles, basis, site.ghost, c, a);
}

template <int D>
bool fit_along_normal(const FitParticles<D>& particles, const FitSite<D>& site,
                      std::vector<double>& c, std::vector<double>& a) {
  const auto basis = [&](const Position<D>& x) { return Eigen::Vector2d(1, site.normal.dot(x)); };
  return fit_linear<2, D>(particles, basis, site.ghost, c, a);
}

template <int D>
bool fit_constrained(const FitParticles<D>& particles, const FitSite<D>& site, bool curved,
                     std::vector<double>& b) {
  return (curved && fit_constrained_in<D + 1>(particles, site, b)) ||
         fit_constrained_in<D>(particles, site, b);
}

template <int D>
bool fit_proportional(const FitParticles<D>& particles, const FitSite<D>& site,
                      std::vector<double>& b) {
  double square = 0;
  for (const FitParticle<D>& i : particles) {
    square += i.weight * i.surface_distance * i.surface_distance;
  }
  if (!(square > 1e-3)) return false;
  for (const FitParticle<D>& i : particles) {
    b.push_back(i.weight * i.surface_distance * site.surface_distance / square);
  }
  return true;
}

template bool fit_in_all_directions<2>(const FitParticles<2>&, const FitSite<2>&,
                                       std::vector<double>&, std::vector<double>&);
template bool fit_along_normal<2>(const FitParticles<2>&, const FitSite<2>&, std::vector<double>&,
                                  std::vector<double>&);
template bool fit_constrained<2>(const FitParticles<2>&, const FitSite<2>&, bool,
                                 std::vector<double>&);
template bool fit_proportional<2>(const FitParticles<2>&, const FitSite<2>&, std::vector<double>&);
template bool fit_in_all_directions<3>(const FitParticles<3>&, const FitSite<3>&,
                                       std::vector<double>&, std::vector<double>&);
template bool fit_along_normal<3>(const FitParticles<3>&, const FitSite<3>&, std::vector<double>&,
                                  std::vector<double>&);
template bool fit_constrained<3>(const FitParticles<3>&, const FitSite<3>&, bool,
                                 std::vector<double>&);
template bool fit_proportional<3>(const FitParticles<3>&, const FitSite<3>&, std::vector<double>&);

}  // namespace pliant::remeshed
