#include "engine/remeshed/surface_fits.hpp"

#include <Eigen/Dense>

namespace pliant::remeshed {

namespace {

// Pivots of a normal matrix, relative to its largest, below which a fit counts as singular.
constexpr double smallest_pivot = 2e-3;

/// Solves M x = e where M = sum_i w_i q_i q_i^T; false when M is (nearly) singular.
template <int N, class Basis, int D>
bool solve_fit(const FitParticles<D>& particles, const Basis& basis,
               const Eigen::Matrix<double, N, 1>& at, Eigen::Matrix<double, N, 1>& solution) {
  Eigen::Matrix<double, N, N> normal = Eigen::Matrix<double, N, N>::Zero();
  for (const FitParticle<D>& i : particles) {
    const Eigen::Matrix<double, N, 1> q = basis(i);
    normal += i.weight * q * q.transpose();
  }
  const Eigen::LDLT<Eigen::Matrix<double, N, N>> factor(normal);
  const auto pivots = factor.vectorD();
  if (!(pivots.minCoeff() > smallest_pivot * pivots.maxCoeff())) return false;
  solution = factor.solve(at);
  return true;
}

/// {phi, phi t[, phi t2], phi^2} without its last term unless N = D + 1.
template <int N, int D>
Eigen::Matrix<double, N, 1> constrained_basis(double distance, const Position<D>& position,
                                              const Position<D>& normal) {
  Eigen::Matrix<double, N, 1> q;
  q[0] = distance;
  if constexpr (D == 2) {
    q[1] = distance * (-normal[1] * position[0] + normal[0] * position[1]);
  } else {
    const Position<D> t1 = normal.unitOrthogonal(), t2 = normal.cross(t1);
    q[1] = distance * t1.dot(position);
    q[2] = distance * t2.dot(position);
  }
  if constexpr (N > D) q[D] = distance * distance;
  return q;
}

/// Coefficients of (RP.32) at the ghost and at the foot point, in {1, x, y[, z]} or {1, n.x}.
template <int N, int D, class Basis>
bool fit_linear(const FitParticles<D>& particles, const Basis& basis, const Position<D>& ghost,
                std::vector<double>& c, std::vector<double>& a) {
  const auto of_neighbour = [&](const FitParticle<D>& i) { return basis(i.position); };
  Eigen::Matrix<double, N, 1> at_ghost, at_foot;
  if (!solve_fit<N>(particles, of_neighbour, basis(ghost), at_ghost) ||
      !solve_fit<N>(particles, of_neighbour, basis(Position<D>::Zero()), at_foot)) {
    return false;
  }
  for (const FitParticle<D>& i : particles) {
    c.push_back(i.weight * basis(i.position).dot(at_ghost));
    a.push_back(i.weight * basis(i.position).dot(at_foot));
  }
  return true;
}

template <int N, int D>
bool fit_constrained_in(const FitParticles<D>& particles, const FitSite<D>& site,
                        std::vector<double>& b) {
  const auto basis = [&](const FitParticle<D>& i) {
    return constrained_basis<N, D>(i.surface_distance, i.position, site.normal);
  };
  Eigen::Matrix<double, N, 1> x;
  const auto at = constrained_basis<N, D>(site.surface_distance, site.ghost, site.normal);
  if (!solve_fit<N>(particles, basis, at, x)) return false;
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
