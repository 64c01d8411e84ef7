#pragma once

#include "kernels/remeshed/stage/arguments.hpp"
#include "kernels/remeshed/stage/gradient_sums.hpp"
#include "kernels/remeshed/stage/weight.hpp"

/// The moment-matrix gradient (RP.20) of several fields in one sweep over the neighbours, or that
/// of H&K (RP.19), whose weights contain v_q and which uses only the diagonal of A.
///
/// For every neighbour q of a pack of particles p: d = x_q - x_p, omega(|d|), and
///
///     A += omega d d^T          H_f += omega d (f_q - f_p)          (grad f = A^-1 H_f at the end)
///
/// In 2D, velocity and stress need 13 accumulators, which AVX-512 keeps in registers. In 3D they
/// would need 33. There the divergence of the stress is summed after A is inverted,
///
///     div sigma_i = sum_q (sigma_q - sigma_p)_ij (A^-1 omega d)_j
///
/// in three accumulators, from the values omega d that the first sweep has left in the first cache.
/// Positions are given by the drift xi from the slots: d = (xi_q + offset h) - xi_p, so that the
/// result does not depend on where the body is.
namespace pliant::kernels {

/// The fields of a sweep: the drift, and the fields to differentiate.
template <class T, int D, int F>
struct SweepFields {
  const T* drift[D];
  const T* field[F];
};

/// Distances d and weights of the neighbours of a pack of particles p.
template <Kernel kernel, class P, int D>
class Separation {
  using T = Scalar<P>;

 public:
  Separation(const T* const (&drift)[D], std::int64_t slot, T spacing)
      : weight_(spacing), spacing_(spacing) {
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      drift_[i] = drift[i];
      position_[i] = load<P>(drift[i] + slot);
    }
  }

  /// Computes d and omega d of neighbours `offset` cells away; `neighbour(field)` loads their
  /// values.
  template <class Load>
  [[gnu::always_inline]] void operator()(const P (&offset)[D], const Load& neighbour, P (&d)[D],
                                         P (&weighted)[D]) const {
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      d[i] = neighbour(drift_[i]) - fused_minus(offset[i], P(spacing_), position_[i]);
    }
    P distance2 = d[0] * d[0];
#pragma GCC unroll 3
    for (int i = 1; i < D; ++i) distance2 = fused(d[i], d[i], distance2);
    const P omega = weight_(distance2);
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) weighted[i] = omega * d[i];
  }

 private:
  PairWeight<kernel, P> weight_;
  T spacing_;
  const T* drift_[D];
  P position_[D];
};

/// The factor v_q of the weights of (RP.19); those of (RP.20) have none.
template <Gradient gradient, class P, int D>
class VolumeWeight {
 public:
  explicit VolumeWeight(const Scalar<P>* volume) : volume_(volume) {}

  template <class Load>
  [[gnu::always_inline]] void operator()(const Load& neighbour, P (&weighted)[D]) const {
    if constexpr (gradient == Gradient::normalised) {
      const P volume = neighbour(volume_);
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) weighted[i] = volume * weighted[i];
    }
  }

 private:
  const Scalar<P>* volume_;
};

/// Differences of some fields between a neighbour and a pack of particles.
template <class P, int F>
class Differences {
  using T = Scalar<P>;

 public:
  Differences(const T* const* field, std::int64_t slot) {
#pragma GCC unroll 9
    for (int f = 0; f < F; ++f) {
      field_[f] = field[f];
      value_[f] = load<P>(field[f] + slot);
    }
  }

  template <class Load>
  [[gnu::always_inline]] void operator()(const Load& neighbour, P (&difference)[F]) const {
#pragma GCC unroll 9
    for (int f = 0; f < F; ++f) difference[f] = neighbour(field_[f]) - value_[f];
  }

 private:
  const T* field_[F];
  P value_[F];
};

/// How far the rows of the stencil reach along x, [abs(dz)][abs(dy)]. Nodes that are as far as the
/// nearest ones outside the stencil, at `reach + 1` cells, are left out too.
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

/// Largest number of pairs of the stencil.
template <Kernel kernel, int D>
inline constexpr int stencil_bound = power(2 * stencil_reach(kernel) + 1, D) - 1;

/// Calls `visit(offset, load)` for the neighbours in a row, up to `width` on each side.
template <int width, bool centre, class P, int D, class Visit>
[[gnu::always_inline]] inline void visit_row(int dy, int dz, std::int64_t row, const Visit& visit) {
  using T = Scalar<P>;
#pragma GCC unroll 5
  for (int dx = -width; dx <= width; ++dx) {
    if (centre && dx == 0) continue;
    const T cells[3] = {T(dx), T(dy), T(dz)};
    P offset[D];
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) offset[i] = P(cells[i]);
    visit(offset, [&](const T* field) { return load<P>(field + row + dx); });
  }
}

/// The same for all rows. In 2D the rows are unrolled at compile time. In 3D that would exceed the
/// instruction cache, so only their widths are known at compile time.
template <Kernel kernel, class P, int D, class Visit>
[[gnu::always_inline]] inline void visit_stencil(const std::int64_t* neighbour_row,
                                                 std::int64_t slot, const Visit& visit) {
  constexpr int reach = stencil_reach(kernel);
  static_assert(reach <= 2);
  static constexpr RowWidths<typename P::arch_type, reach> widths;
  if constexpr (D == 2) {
#pragma GCC unroll 5
    for (int dy = -reach; dy <= reach; ++dy) {
      const std::int64_t row = slot + neighbour_row[row_index<D>(dy)];
      if (dy == 0) {
        visit_row<reach, true, P, D>(dy, 0, row, visit);
      } else if (widths.width[0][dy < 0 ? -dy : dy] == 2) {
        visit_row<2, false, P, D>(dy, 0, row, visit);
      } else {
        visit_row<1, false, P, D>(dy, 0, row, visit);
      }
    }
  } else {
    for (int dz = -reach; dz <= reach; ++dz) {
      for (int dy = -reach; dy <= reach; ++dy) {
        const std::int64_t row = slot + neighbour_row[row_index<D>(dy, dz)];
        if (dy == 0 && dz == 0) {
          visit_row<reach, true, P, D>(dy, dz, row, visit);
          continue;
        }
        const int width = widths.width[dz < 0 ? -dz : dz][dy < 0 ? -dy : dy];
        if (reach > 1 && width == 2) {
          visit_row<2, false, P, D>(dy, dz, row, visit);
        } else if (reach > 1 && width == 0) {
          visit_row<0, false, P, D>(dy, dz, row, visit);
        } else {
          visit_row<1, false, P, D>(dy, dz, row, visit);
        }
      }
    }
  }
}

/// The first values of an array of another type, converted.
template <class To, class From>
[[gnu::always_inline]] inline To converted(const From* from) {
  alignas(64) typename To::value_type lane[To::size];
  for (std::size_t l = 0; l < To::size; ++l) {
    lane[l] = static_cast<typename To::value_type>(from[l]);
  }
  return To::load_aligned(lane);
}

/// The same for the neighbour lists of the register of particles at `slot`, which starts at lane
/// `slot % slots_per_pack` of its pack.
template <class P, int D, class Visit>
[[gnu::always_inline]] inline void visit_list(const NeighbourLists<D>& lists, std::int64_t slot,
                                              const Visit& visit) {
  using T = Scalar<P>;
  using Slots = xsimd::batch<xsimd::as_integer_t<T>, typename P::arch_type>;
  constexpr int pack = slots_per_pack;
  std::int64_t entry = lists.start[slot / pack] + slot % pack;
  for (std::int32_t k = 0; k < lists.length[slot / pack]; ++k, entry += pack) {
    const Slots neighbour = converted<Slots>(lists.neighbour + entry);
    P offset[D];
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) offset[i] = converted<P>(lists.offset[i] + entry);
    visit(offset, [&](const T* field) { return P::gather(field, neighbour); });
  }
}

}  // namespace pliant::kernels
