#pragma once

#include "kernels/remeshed/ghosts/arguments.hpp"
#include "kernels/remeshed/ghosts/least_squares.hpp"

/// The fits (RP.43) and (RP.44) of ghosts, one in each lane: see SurfaceFits.
namespace pliant::kernels {

/// One register of ghosts.
template <class P, int D>
class FitLanes {
  using T = Scalar<P>;
  using Mask = typename P::batch_bool_type;
  static constexpr int terms = D + 1;
  static constexpr int pack = slots_per_pack;

 public:
  FitLanes(const SurfaceFits<T, D>& work, int lane) : work_(work), lane_(lane) {
    P normal[D];
    load_point(work.normal, lane, normal);
    find_tangents(normal);
  }

  void fit() {
    add_moments();
    linear_.right[0][0] = linear_.right[1][0] = P(T(1));
    P ghost[D];
    load_point(work_.ghost, lane_, ghost);
    set_constrained_terms(ghost, load<P>(work_.ghost_distance + lane_), value_at_ghost_);
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      linear_.right[0][a + 1] = ghost[a];
      linear_.right[1][a + 1] = P(T(0));
    }
    const P least = P(T(smallest_pivot));
    const Mask fitted = linear_.solve(least) && solve_constrained(least);
    xsimd::select(fitted, P(T(1)), P(T(0))).store_unaligned(work_.fitted + lane_);
    write_terms();
    write_constrained_sum();
  }

 private:
  static void load_point(const std::array<const T*, D>& from, std::int64_t at, P (&x)[D]) {
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) x[a] = load<P>(from[a] + at);
  }

  /// Unit vectors that are normal to n and to each other (Duff et al. 2017).
  void find_tangents(const P (&n)[D]) {
    if constexpr (D == 2) {
      tangent_[0][0] = -n[1];
      tangent_[0][1] = n[0];
    } else {
      const P one(T(1)), zero(T(0));
      const P sign = xsimd::select(n[2] < zero, -one, one);
      const P a = -one / (sign + n[2]), b = n[0] * n[1] * a;
      tangent_[0][0] = fused(sign * n[0] * n[0], a, one);
      tangent_[0][1] = sign * b;
      tangent_[0][2] = -sign * n[0];
      tangent_[1][0] = b;
      tangent_[1][1] = fused(n[1] * n[1], a, sign);
      tangent_[1][2] = -n[1];
    }
  }

  /// {phi, phi t[, phi t2], phi^2}
  void set_constrained_terms(const P (&position)[D], const P& distance, P (&term)[terms]) const {
    term[0] = distance;
#pragma GCC unroll 2
    for (int k = 1; k < D; ++k) {
      P along = tangent_[k - 1][0] * position[0];
#pragma GCC unroll 3
      for (int a = 1; a < D; ++a) along = fused(tangent_[k - 1][a], position[a], along);
      term[k] = distance * along;
    }
    term[D] = distance * distance;
  }

  /// Weight and position of the particle at `entry`.
  P weight(std::int64_t entry, P (&position)[D]) const {
    load_point(work_.position, entry, position);
    P square = position[0] * position[0];
#pragma GCC unroll 3
    for (int a = 1; a < D; ++a) square = fused(position[a], position[a], square);
    const P rest =
        xsimd::max(fused_minus(P(1 / (work_.radius * work_.radius)), square, P(T(1))), P(T(0)));
    return rest * rest;
  }

  template <class System>
  static void add(System& system, const P& weight, const P (&term)[terms]) {
#pragma GCC unroll 4
    for (int i = 0; i < terms; ++i) {
      const P weighted = weight * term[i];
#pragma GCC unroll 4
      for (int j = i; j < terms; ++j) system.at(i, j) = fused(weighted, term[j], system.at(i, j));
    }
  }

  void add_moments() {
#pragma GCC unroll 4
    for (int i = 0; i < terms; ++i) {
#pragma GCC unroll 4
      for (int j = i; j < terms; ++j) linear_.at(i, j) = curved_.at(i, j) = P(T(0));
    }
    for (int k = 0; k < work_.length; ++k) {
      const std::int64_t entry = static_cast<std::int64_t>(k) * pack + lane_;
      P position[D], term[terms];
      const P w = weight(entry, position);
      term[0] = P(T(1));
#pragma GCC unroll 3
      for (int a = 0; a < D; ++a) term[a + 1] = position[a];
      add(linear_, w, term);
      set_constrained_terms(position, load<P>(work_.distance + entry), term);
      add(curved_, w, term);
    }
  }

  /// The requested mean of the fits with and without the term phi^2; without, if it is not
  /// determined.
  Mask solve_constrained(const P& least) {
    SymmetricSystem<P, D, 1> plain;
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
      for (int j = i; j < D; ++j) plain.at(i, j) = curved_.at(i, j);
      plain.right[0][i] = value_at_ghost_[i];
    }
#pragma GCC unroll 4
    for (int i = 0; i < terms; ++i) curved_.right[0][i] = value_at_ghost_[i];
    const P share = load<P>(work_.curved + lane_);
    const Mask is_curved = curved_.solve(least) && share > P(T(0));
    const Mask is_plain = plain.solve(least);
    const Mask is_mean = is_curved && is_plain && share < P(T(1));
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      const P with = curved_.right[0][i], without = plain.right[0][i];
      constrained_[i] = xsimd::select(is_mean, fused(share, with - without, without),
                                      xsimd::select(is_curved, with, without));
    }
    const P last = curved_.right[0][D];
    constrained_[D] = xsimd::select(is_mean, share * last, xsimd::select(is_curved, last, P(T(0))));
    return is_curved || is_plain;
  }

  void write_terms() const {
#pragma GCC unroll 4
    for (int i = 0; i < terms; ++i) {
      linear_.right[0][i].store_unaligned(work_.linear[i] + lane_);
      linear_.right[1][i].store_unaligned(work_.surface[i] + lane_);
    }
    constrained_[0].store_unaligned(work_.constrained[0] + lane_);
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      P along(T(0));
#pragma GCC unroll 2
      for (int k = 1; k < D; ++k) along = fused(constrained_[k], tangent_[k - 1][a], along);
      along.store_unaligned(work_.constrained[a + 1] + lane_);
    }
    constrained_[D].store_unaligned(work_.constrained[D + 1] + lane_);
  }

  void write_constrained_sum() const {
    P sum(T(0));
    for (int k = 0; k < work_.length; ++k) {
      const std::int64_t entry = static_cast<std::int64_t>(k) * pack + lane_;
      P position[D], term[terms];
      const P w = weight(entry, position);
      set_constrained_terms(position, load<P>(work_.distance + entry), term);
      P b = constrained_[0] * term[0];
#pragma GCC unroll 3
      for (int i = 1; i < terms; ++i) b = fused(constrained_[i], term[i], b);
      sum = fused(w, b, sum);
    }
    sum.store_unaligned(work_.constrained_sum + lane_);
  }

  const SurfaceFits<T, D>& work_;
  int lane_;
  P tangent_[D - 1][D];
  P value_at_ghost_[terms], constrained_[terms];
  SymmetricSystem<P, terms, 2> linear_;
  SymmetricSystem<P, terms, 1> curved_;
};

template <class P, int D>
void fit_surface(const SurfaceFits<Scalar<P>, D>& work) {
  for (int lane = 0; lane < slots_per_pack; lane += lanes<P>) {
    FitLanes<P, D>(work, lane).fit();
  }
}

}  // namespace pliant::kernels
