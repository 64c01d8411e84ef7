#pragma once

#include "kernels/moment.hpp"
#include "kernels/table.hpp"
#include "kernels/weight.hpp"

/// The moment-matrix gradient (RP.18) of several fields in one sweep over the neighbours.
///
/// For every neighbour q of a pack of particles p: d = x_q - x_p, omega(|d|), and
///
///     A += omega d d^T          H_f += omega d (f_q - f_p)          (grad f = A^-1 H_f at the end)
///
/// In 2D with velocity and stress that makes 13 accumulators, which AVX-512 keeps in registers. In
/// 3D it would make 33, so that velocity and stress are swept one after the other, A with the
/// former. Positions enter as displacements xi from the slots: d = (xi_q + offset h) - xi_p, so
/// that the result does not depend on where the body is.
namespace pliant::kernels {

/// A of a pack.
template <class P, int D>
struct MomentSums {
  P moment[symmetric_components<D>];

  MomentSums() {
    for (P& a : moment) a = P(Scalar<P>(0));
  }

  [[gnu::always_inline]] void add(const P (&weighted)[D], const P (&d)[D]) {
    for (int i = 0; i < D; ++i) {
      for (int j = i; j < D; ++j) {
        P& a = moment[symmetric_index<D>(i, j)];
        a = fused(weighted[i], d[j], a);
      }
    }
  }
};

/// H of a pack.
template <class P, int D, int F>
struct SlopeSums {
  P slope[F][D];

  SlopeSums() {
    for (auto& row : slope) {
      for (P& h : row) h = P(Scalar<P>(0));
    }
  }

  [[gnu::always_inline]] void add(const P (&weighted)[D], const P (&)[D],
                                  const P (&difference)[F]) {
    for (int f = 0; f < F; ++f) {
      for (int i = 0; i < D; ++i) slope[f][i] = fused(weighted[i], difference[f], slope[f][i]);
    }
  }
};

/// Both.
template <class P, int D, int F>
struct GradientSums : MomentSums<P, D>, SlopeSums<P, D, F> {
  [[gnu::always_inline]] void add(const P (&weighted)[D], const P (&d)[D],
                                  const P (&difference)[F]) {
    MomentSums<P, D>::add(weighted, d);
    SlopeSums<P, D, F>::add(weighted, d, difference);
  }
};

/// Gradients of F fields from their sums and the inverse of A.
template <class P, int D, int F>
inline void solve(const P (&inverse)[symmetric_components<D>], const SlopeSums<P, D, F>& sums,
                  P (&gradient)[F][D]) {
#pragma GCC unroll 16
  for (int f = 0; f < F; ++f) {
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      P value = inverse[symmetric_index<D>(i, 0)] * sums.slope[f][0];
      for (int j = 1; j < D; ++j) {
        value = fused(inverse[symmetric_index<D>(i, j)], sums.slope[f][j], value);
      }
      gradient[f][i] = value;
    }
  }
}

/// The same with A; not finite where the neighbours do not span the space.
template <class P, int D, int F>
inline void solve(const GradientSums<P, D, F>& sums, P (&gradient)[F][D]) {
  P inverse[symmetric_components<D>];
  invert_symmetric(sums.moment, inverse);
  solve<P, D, F>(inverse, sums, gradient);
}

/// The fields of a sweep: where particles are, and what is differentiated.
template <class T, int D, int F>
struct SweepFields {
  const T* displacement[D];
  const T* field[F];
};

/// A pack of particles p about to meet its neighbours.
template <Weight weight, class P, int D, int F>
class PairSweep {
  using T = Scalar<P>;

 public:
  PairSweep(const SweepFields<T, D, F>& fields, std::int64_t slot, T spacing)
      : fields_(fields), weight_(spacing), spacing_(spacing) {
    for (int i = 0; i < D; ++i) position_[i] = load<P>(fields.displacement[i] + slot);
    for (int f = 0; f < F; ++f) value_[f] = load<P>(fields.field[f] + slot);
  }

  /// Adds neighbours whose slots lie `offset` cells away; `neighbour(field)` loads them.
  template <class Load, class Sums>
  [[gnu::always_inline]] void meet(const P (&offset)[D], const Load& neighbour, Sums& sums) const {
    P d[D], difference[F];
    for (int i = 0; i < D; ++i) {
      d[i] = neighbour(fields_.displacement[i]) - fused_minus(offset[i], spacing_, position_[i]);
    }
    for (int f = 0; f < F; ++f) difference[f] = neighbour(fields_.field[f]) - value_[f];
    P distance2 = d[0] * d[0];
    for (int i = 1; i < D; ++i) distance2 = fused(d[i], d[i], distance2);
    const P omega = weight_(distance2);
    P weighted[D];
    for (int i = 0; i < D; ++i) weighted[i] = omega * d[i];
    sums.add(weighted, d, difference);
  }

 private:
  const SweepFields<T, D, F>& fields_;
  PairWeight<weight, P> weight_;
  P spacing_;
  P position_[D];
  P value_[F];
};

/// How far the rows of the stencil reach along x, [abs(dz)][abs(dy)]: nodes at `reach + 1` cells
/// are as far as the nearest ones outside the stencil, and left out too.
template <class Arch, int reach>
struct RowWidths {
  int width[reach + 1][reach + 1];

  constexpr RowWidths() : width() {
    for (int dz = 0; dz <= reach; ++dz) {
      for (int dy = 0; dy <= reach; ++dy) {
        int w = reach;
        while (w * w + dy * dy + dz * dz >= (reach + 1) * (reach + 1)) --w;
        width[dz][dy] = w;
      }
    }
  }
};

/// Sums over the lattice neighbours of the pack at `slot`.
template <Weight weight, template <class, int, int> class Sums, class P, int D, int F>
[[gnu::always_inline]] inline void sweep_stencil(const SweepFields<Scalar<P>, D, F>& fields,
                                                 const std::int64_t* neighbour_row,
                                                 std::int64_t slot, Scalar<P> spacing,
                                                 Sums<P, D, F>& sums) {
  using T = Scalar<P>;
  constexpr int reach = stencil_reach(weight);
  constexpr int depth = D == 3 ? reach : 0;
  static constexpr RowWidths<typename P::arch_type, reach> widths;
  const PairSweep<weight, P, D, F> sweep(fields, slot, spacing);
  for (int dz = -depth; dz <= depth; ++dz) {
#pragma GCC unroll 5
    for (int dy = -reach; dy <= reach; ++dy) {
      const std::int64_t row = slot + neighbour_row[row_index<D>(dy, dz)];
      const int width = widths.width[dz < 0 ? -dz : dz][dy < 0 ? -dy : dy];
#pragma GCC unroll 5
      for (int dx = -reach; dx <= reach; ++dx) {
        if ((dx == 0 && dy == 0 && dz == 0) || dx < -width || dx > width) continue;
        const T cells[3] = {T(dx), T(dy), T(dz)};
        P offset[D];
        for (int i = 0; i < D; ++i) offset[i] = P(cells[i]);
        sweep.meet(
            offset, [&](const T* field) { return load<P>(field + row + dx); }, sums);
      }
    }
  }
}

/// The first lanes of an array of another type, converted.
template <class To, class From>
[[gnu::always_inline]] inline To converted(const From* from) {
  alignas(64) typename To::value_type lane[To::size];
  for (std::size_t l = 0; l < To::size; ++l) {
    lane[l] = static_cast<typename To::value_type>(from[l]);
  }
  return To::load_aligned(lane);
}

/// Lets `sweep` meet one entry of the lists: one neighbour for each lane.
template <class P, int D, class Sweep, class... Sums>
[[gnu::always_inline]] inline void meet_listed(const NeighbourLists<D>& lists, std::int64_t entry,
                                               Sweep& sweep, Sums&... sums) {
  using T = Scalar<P>;
  using Slots = xsimd::batch<xsimd::as_integer_t<T>, typename P::arch_type>;
  const Slots neighbour = converted<Slots>(lists.neighbour + entry);
  P offset[D];
  for (int i = 0; i < D; ++i) offset[i] = converted<P>(lists.offset[i] + entry);
  sweep.meet(
      offset, [&](const T* field) { return P::gather(field, neighbour); }, sums...);
}

/// Sums over the listed neighbours of the register of particles at `slot`, which starts at lane
/// `slot % slots_per_pack` of its pack.
template <Weight weight, template <class, int, int> class Sums, class P, int D, int F>
[[gnu::always_inline]] inline void sweep_list(const SweepFields<Scalar<P>, D, F>& fields,
                                              const NeighbourLists<D>& lists, std::int64_t slot,
                                              Scalar<P> spacing, Sums<P, D, F>& sums) {
  using T = Scalar<P>;
  constexpr int pack = slots_per_pack<T>;
  const PairSweep<weight, P, D, F> sweep(fields, slot, spacing);
  std::int64_t entry = lists.start[slot / pack] + slot % pack;
  for (std::int32_t k = 0; k < lists.length[slot / pack]; ++k, entry += pack) {
    meet_listed<P, D>(lists, entry, sweep, sums);
  }
}

}  // namespace pliant::kernels
