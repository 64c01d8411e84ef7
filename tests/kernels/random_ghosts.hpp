#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "kernels/remeshed/ghosts/fit_coefficients.hpp"
#include "kernels/remeshed/table.hpp"
#include "tests/kernels/field.hpp"

namespace pliant::kernels::test {

/// Ghosts with up to 22 random particles each; some have none, every fourth is a wall ghost, and
/// some particles are beyond the radius of the fit.
template <class T, int D>
struct RandomGhosts {
  static constexpr int width = record_width<D>, particles = 40, ghosts = 50;

  RandomGhosts() : records(particles * width), surface_distance(particles) {
    for (T& x : records) x = value();
    for (T& x : surface_distance) x = value();
    for (int g = 0; g < ghosts; ++g) add_ghost(g % 4 == 0);
    pairs.resize(pairs.size() + slots_per_pack);
    wall_distance.resize(wall_distance.size() + slots_per_pack);
  }

  /// The coefficients of the k-th particle of all ghosts, which belongs to ghost g.
  FitCoefficients<double> coefficients(int g, std::int64_t k) const {
    const FitTerms<T, D>& q = terms[g];
    double square = 0, broad = 0, c = q.linear[0], a = q.surface[0], b = q.constrained[0];
    for (int i = 0; i < D; ++i) {
      const double r = q.start[i] + cells_along(pairs[k], i);
      square += r * r;
      broad += q.broad[i] * r;
      c += q.linear[i + 1] * r;
      a += q.surface[i + 1] * r;
      b += q.constrained[i + 1] * r;
    }
    const double phi = wall_begin[g] < 0 ? surface_distance[record_of(pairs[k])]
                                         : wall_distance[wall_begin[g] + k - begin[g]];
    const double root = std::max(1 - q.steepness * square + broad * broad, 0.);
    const double w = root * root;
    return {w * c, w * phi * (b + q.constrained[D + 1] * phi), w * a};
  }

  /// Sum of the values k of the records, weighted with one kind of coefficient.
  double sum(double FitCoefficients<double>::*fit, int ghost, int k) const {
    double total = 0;
    for (std::int64_t i = begin[ghost]; i < begin[ghost + 1]; ++i) {
      total += coefficients(ghost, i).*fit * double(records[record_of(pairs[i]) * width + k]);
    }
    return total;
  }

  GhostSums<T, D> sums(std::int64_t first, std::int64_t count, T* into) const {
    return {first,
            count,
            begin.data(),
            pairs.data(),
            terms.data(),
            wall_begin.data(),
            wall_distance.data(),
            surface_distance.data(),
            records.data(),
            into};
  }

  Field<T> records, surface_distance, wall_distance;
  std::vector<FitTerms<T, D>> terms;
  std::vector<std::int64_t> begin = {0}, wall_begin;
  std::vector<FitPair> pairs;

 private:
  std::mt19937 random{5};

  T value() { return std::uniform_real_distribution<T>(-1, 1)(random); }

  void add_ghost(bool of_wall) {
    FitTerms<T, D>& fit = terms.emplace_back();
    fit.steepness = T(0.15);
    for (T& term : fit.start) term = value() / 2;
    for (T& term : fit.broad) term = value() / 8;
    for (T& term : fit.linear) term = value() / 4;
    for (T& term : fit.surface) term = value() / 4;
    for (T& term : fit.constrained) term = value() / 4;
    wall_begin.push_back(of_wall ? static_cast<std::int64_t>(wall_distance.size()) : -1);
    for (int i = static_cast<int>(random() % 23); i > 0; --i) {
      std::array<std::int32_t, D> cells;
      for (std::int32_t& c : cells) c = static_cast<std::int32_t>(random() % 5) - 2;
      pairs.push_back(fit_pair<D>(static_cast<std::int32_t>(random() % particles), cells));
      if (of_wall) wall_distance.push_back(value());
    }
    begin.push_back(static_cast<std::int64_t>(pairs.size()));
  }
};

}  // namespace pliant::kernels::test
