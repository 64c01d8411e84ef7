#pragma once

#include "kernels/cofactor.hpp"
#include "kernels/law.hpp"
#include "kernels/total_lagrangian/corner_modes.hpp"

/// Stress points: corner displacements -> modes -> F -> Cauchy stress -> first Piola-Kirchhoff
/// stress -> forces, mode by mode.
namespace pliant::kernels {

/// Bound of the largest singular value: sqrt(largest row sum * largest column sum), squared.
template <class P, int D>
inline P norm2_bound(const P (&matrix)[D * D]) {
  P row(Scalar<P>(0)), column(Scalar<P>(0));
  for (int i = 0; i < D; ++i) {
    P of_row = xsimd::abs(matrix[D * i]), of_column = xsimd::abs(matrix[i]);
    for (int j = 1; j < D; ++j) {
      of_row = of_row + xsimd::abs(matrix[D * i + j]);
      of_column = of_column + xsimd::abs(matrix[D * j + i]);
    }
    row = xsimd::max(row, of_row);
    column = xsimd::max(column, of_column);
  }
  return row * column;
}

/// Displacement modes of the cells of a register, [component][mode].
template <class P, int D>
inline void displacement_modes(const StressPoints<Scalar<P>, D>& block,
                               const std::int64_t (&row)[1 << (D - 1)], std::int64_t slot,
                               P (&mode)[D][1 << D]) {
  for (int i = 0; i < D; ++i) {
    const Scalar<P>* d = block.displacement[i] + slot;
    for (int c = 0; c < (1 << D); ++c) mode[i][c] = load<P>(d + row[c >> 1] + (c & 1));
    to_modes<P, D>(mode[i]);
  }
}

/// What a register of stress points adds to the block's result.
template <class P>
struct StressPointExtremes {
  P wave_speed2 = P(Scalar<P>(0));
  std::int64_t non_finite = -1;
};

template <class P, int D>
inline void examine(const Material<Scalar<P>>& material, const P (&f)[D * D], const P (&cof)[D * D],
                    const P& finite, const P& fraction, std::int64_t slot,
                    StressPointExtremes<P>& extremes) {
  using T = Scalar<P>;
  using L = Law<Model::reduced_polynomial, P, D>;
  const P zero(T(0)), jacobian = determinant(f);
  const auto inside = fraction > zero;
  const auto sound = (finite == zero) && (jacobian > zero);
  if (extremes.non_finite < 0 && xsimd::any(inside && !sound)) {
    extremes.non_finite = slot + first_lane<P>(inside && !sound);
  }
  // Of the deformed material, in units of the lattice: |F^-1| = |cof F|/J.
  const P c2 = L::wave_speed2(material, f, P(material.density) / jacobian) *
               norm2_bound<P, D>(cof) / (jacobian * jacobian);
  extremes.wave_speed2 = xsimd::max(extremes.wave_speed2, xsimd::select(inside && sound, c2, zero));
}

/// See StressPoints.
template <class P, int D>
StressPointsResult evaluate_stress_points(const StressPoints<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  using L = Law<Model::reduced_polynomial, P, D>;
  constexpr int corners = 1 << D;
  T volume = 1;
  for (int a = 0; a < D; ++a) volume *= block.spacing;
  // Half the corners pull each way, so that a difference over h is 2/2^D of a gradient mode.
  const T slope = T(2) / (corners * block.spacing);
  const T stiffness =
      block.hourglass * volume * T(8) / (T(3) * corners * corners * block.spacing * block.spacing);
  StressPointExtremes<P> extremes;
  const P zero(T(0));
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    std::int64_t row[corners / 2];
    for (int r = 0; r < corners / 2; ++r) row[r] = corner_row<typename P::arch_type>(segment, r, 1);
    for (std::int64_t slot = segment.first; slot < segment.first + segment.count;
         slot += lanes<P>) {
      const P fraction = load<P>(block.fraction + slot);
      const auto inside = fraction > zero;
      if (!xsimd::any(inside)) {
        for (int i = 0; i < D; ++i) {
          for (T* force : block.force[i]) zero.store_unaligned(force + slot);
        }
        continue;
      }
      P mode[D][corners], f[D * D], cof[D * D], sigma[L::symmetric];
      displacement_modes<P, D>(block, row, slot, mode);
      for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) {
          // Corners of cells outside the body are nothing in particular.
          f[D * i + j] = xsimd::select(inside, mode[i][1 << j] * P(slope), zero);
        }
        f[D * i + i] = f[D * i + i] + P(T(1));
      }
      cofactor(f, cof);
      L::stress(block.material, f, P(T(1)), sigma);
      const P weight = P(volume * slope) * fraction;
      const P half_modulus = half_tangent_modulus(block.material, isochoric_strain<P, D>(f).excess);
      const P resistance = P(T(2) * stiffness) * half_modulus * fraction;
      P finite = zero;
      for (int i = 0; i < D; ++i) {
        for (int m = 1; m < corners; ++m) {
          if (m & (m - 1)) {
            const P hourglass = xsimd::select(inside, mode[i][m], zero);
            (resistance * hourglass).store_unaligned(block.force[i][m - 1] + slot);
          }
        }
        for (int j = 0; j < D; ++j) {
          P stress = sigma[symmetric_index<D>(i, 0)] * cof[j];
          for (int k = 1; k < D; ++k) {
            stress = fused(sigma[symmetric_index<D>(i, k)], cof[D * k + j], stress);
          }
          finite = fused(stress, zero, finite);
          (weight * stress).store_unaligned(block.force[i][(1 << j) - 1] + slot);
        }
      }
      if (block.examine) {
        examine<P, D>(block.material, f, cof, finite, fraction, slot, extremes);
      }
    }
  }
  return {square_root<P>(largest(extremes.wave_speed2)), extremes.non_finite};
}

}  // namespace pliant::kernels
