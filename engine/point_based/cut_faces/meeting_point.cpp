#include "engine/point_based/cut_faces/meeting_point.hpp"

#include "engine/method/decompositions.hpp"

namespace pliant::point_based {

namespace {

constexpr double least_eigenvalue_share = 0.01;  // cuts at less than 11 degrees count as one

/// Projects out the directions `held`.
template <int D>
Eigen::Matrix<double, D, D> free_directions(std::span<const Column<D>> held) {
  Eigen::Matrix<double, D, D> free = Eigen::Matrix<double, D, D>::Identity();
  for (const Column<D>& normal : held) {
    const Column<D> rest = free * normal;
    if (rest.squaredNorm() <= least_eigenvalue_share * normal.squaredNorm()) continue;
    free -= rest * rest.transpose() / rest.squaredNorm();
  }
  return free;
}

}  // namespace

template <int D>
Column<D> meeting_point(std::span<const typename CutPieces<D>::Crossed> crossings,
                        std::span<const Column<D>> held, double reach) {
  const Eigen::Matrix<double, D, D> free = free_directions<D>(held);
  Column<D> mean = Column<D>::Zero(), right = Column<D>::Zero();
  Eigen::Matrix<double, D, D> normals = Eigen::Matrix<double, D, D>::Zero();
  for (const auto& crossed : crossings) {
    mean += column<D>(crossed.place) / static_cast<double>(crossings.size());
  }
  for (const auto& crossed : crossings) {
    const Column<D> along = column<D>(crossed.normal), normal = free * along;
    normals += normal * normal.transpose();
    right += normal * along.dot(column<D>(crossed.place) - mean);
  }
  const Eigensystem<D> axes = eigensystem<D>(normals);
  const double least = least_eigenvalue_share * static_cast<double>(crossings.size());
  Column<D> moved = Column<D>::Zero();
  for (int a = 0; a < D; ++a) {
    if (axes.values[a] <= least) continue;
    const Column<D> axis = axes.vectors.col(a);
    moved += axis.dot(right) / axes.values[a] * axis;
  }
  return moved.norm() > reach ? mean : Column<D>(mean + moved);
}

template Column<2> meeting_point<2>(std::span<const CutPieces<2>::Crossed>,
                                    std::span<const Column<2>>, double);
template Column<3> meeting_point<3>(std::span<const CutPieces<3>::Crossed>,
                                    std::span<const Column<3>>, double);

}  // namespace pliant::point_based
