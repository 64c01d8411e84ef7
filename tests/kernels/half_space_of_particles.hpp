#pragma once

#include <array>
#include <cmath>
#include <random>

#include "kernels/remeshed/table.hpp"
#include "tests/kernels/field.hpp"

namespace pliant::kernels::test {

/// Random particles in bodies with plane surfaces, one body for each lane of a pack, and a ghost
/// above each.
template <class T, int D>
struct HalfSpaceOfParticles {
  static constexpr int length = 45, pack = slots_per_pack;
  static constexpr double radius = 2.6;

  HalfSpaceOfParticles() {
    distance.resize(length * pack);
    for (auto* list : {&ghost_distance, &curved, &constrained_sum, &fitted}) list->resize(pack);
    for (auto& list : linear) list.resize(pack);
    for (auto& list : surface) list.resize(pack);
    for (auto& list : constrained) list.resize(pack);
    for (int a = 0; a < D; ++a) {
      position[a].resize(length * pack);
      ghost[a].resize(pack);
      normal[a].resize(pack);
    }
    for (int l = 0; l < pack; ++l) fill(l);
  }

  /// Place of particle k of a lane.
  std::array<double, D> place(int k, int lane) const {
    std::array<double, D> x;
    for (int a = 0; a < D; ++a) x[a] = position[a][k * pack + lane];
    return x;
  }

  SurfaceFits<T, D> arguments() {
    SurfaceFits<T, D> work = {};
    work.length = length;
    work.radius = T(radius);
    for (int a = 0; a < D; ++a) {
      work.position[a] = position[a].data();
      work.ghost[a] = ghost[a].data();
      work.normal[a] = normal[a].data();
    }
    work.distance = distance.data();
    work.ghost_distance = ghost_distance.data();
    work.curved = curved.data();
    work.fitted = fitted.data();
    work.constrained_sum = constrained_sum.data();
    for (std::size_t i = 0; i < linear.size(); ++i) {
      work.linear[i] = linear[i].data();
      work.surface[i] = surface[i].data();
    }
    for (std::size_t i = 0; i < constrained.size(); ++i)
      work.constrained[i] = constrained[i].data();
    return work;
  }

  /// The terms that were fitted in a lane.
  FitTerms<double, D> terms(int lane) const {
    FitTerms<double, D> fit;
    fit.steepness = 1 / (radius * radius);
    for (std::size_t i = 0; i < linear.size(); ++i) {
      fit.linear[i] = linear[i][lane];
      fit.surface[i] = surface[i][lane];
    }
    for (std::size_t i = 0; i < constrained.size(); ++i) {
      fit.constrained[i] = constrained[i][lane];
    }
    return fit;
  }

  std::array<Field<T>, D> position, ghost, normal;
  Field<T> distance, ghost_distance, curved, constrained_sum, fitted;
  std::array<Field<T>, D + 1> linear, surface;
  std::array<Field<T>, D + 2> constrained;

 private:
  std::mt19937 random{3};

  void fill(int lane) {
    std::uniform_real_distribution<double> value(-1, 1);
    double n[D], square = 0;
    for (double& x : n) {
      x = value(random);
      square += x * x;
    }
    for (int a = 0; a < D; ++a) {
      n[a] /= std::sqrt(square);
      normal[a][lane] = static_cast<T>(n[a]);
      ghost[a][lane] = static_cast<T>(1.7 * n[a]);
    }
    ghost_distance[lane] = T(1.7);
    curved[lane] = T(lane % 2);
    for (int k = 0; k < length; ++k) {
      double x[D], depth = 0;
      for (int a = 0; a < D; ++a) {
        x[a] = radius * value(random);
        depth += x[a] * n[a];
      }
      if (depth > 0) {  // mirrored into the body
        for (int a = 0; a < D; ++a) x[a] -= 2 * depth * n[a];
      }
      for (int a = 0; a < D; ++a) position[a][k * pack + lane] = static_cast<T>(x[a]);
      distance[k * pack + lane] = static_cast<T>(-std::abs(depth));
    }
  }
};

}  // namespace pliant::kernels::test
