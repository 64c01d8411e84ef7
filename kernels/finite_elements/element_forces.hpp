#pragma once

#include "kernels/dilatation.hpp"
#include "kernels/finite_elements/arguments.hpp"
#include "kernels/point_based/collect_points.hpp"
#include "kernels/point_based/point_lanes.hpp"

/// Forces of the elements of a block, for a register of elements at a time, one in each lane:
/// displacements of the corners -> F -> P -> forces on the corners.
namespace pliant::kernels {

/// Corners and shapes of a register of elements; `element` is the number of its first one in a
/// block.
template <class P, int D>
struct ElementLanes {
  using T = Scalar<P>;
  const std::uint16_t* corner;
  const T* shape;

  ElementLanes(const ElementBlock<T, D>& block, int element) {
    const int lane = element % slots_per_pack, pack = element - lane;
    corner = block.corner + pack * (D + 1) + lane;
    shape = block.shape + pack * element_values<D> + lane;
  }
  const std::uint16_t* corners(int a) const { return corner + a * slots_per_pack; }
  /// Component j of the gradient of corner a = 1 .. D.
  const T* gradient(int a, int j) const { return shape + ((a - 1) * D + j) * slots_per_pack; }
  const T* volume() const { return shape + D * D * slots_per_pack; }
};

/// F of (FE.1).
template <class P, int D>
[[gnu::always_inline]] inline void element_gradient(const ElementBlock<Scalar<P>, D>& block,
                                                    const ElementLanes<P, D>& at, P (&f)[D * D]) {
  using T = Scalar<P>;
  P from[D];
  PointLanes<P, D>::gather(block.point, at.corners(0), from);
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) f[c] = P(c % (D + 1) == 0 ? T(1) : T(0));
#pragma GCC unroll 3
  for (int a = 1; a <= D; ++a) {
    P d[D];
    PointLanes<P, D>::gather(block.point, at.corners(a), d);
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) d[i] = d[i] - from[i];
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      const P g = load<P>(at.gradient(a, j));
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) f[D * i + j] = fused(d[i], g, f[D * i + j]);
    }
  }
}

/// p += F S0, (TL.14).
template <class P, int D>
inline void add_element_prestress(const ElementBlock<Scalar<P>, D>& block, int element,
                                  const P (&f)[D * D], P (&piola)[D * D]) {
  constexpr int components = symmetric_components<D>;
  const int lane = element % slots_per_pack;
  const Scalar<P>* const first = block.initial_stress + (element - lane) * components + lane;
  std::array<const Scalar<P>*, components> stress;
  for (int c = 0; c < components; ++c) stress[c] = first + c * slots_per_pack;
  add_initial_stress<P, D>(stress, 0, f, piola);
}

/// The mean of the pressures at the corners.
template <class P, int D>
inline P mean_pressure(const ElementBlock<Scalar<P>, D>& block, const ElementLanes<P, D>& at) {
  using T = Scalar<P>;
  alignas(64) T lane[lanes<P>];
  for (int l = 0; l < lanes<P>; ++l) {
    T sum = block.point[at.corners(0)[l] + D];
    for (int a = 1; a <= D; ++a) sum += block.point[at.corners(a)[l] + D];
    lane[l] = sum * T(1. / (D + 1));
  }
  return P::load_aligned(lane);
}

/// P(F) of (FE.5).
template <ElasticLaw law, class P, int D>
inline void element_stress(const ElementBlock<Scalar<P>, D>& block, const ElementLanes<P, D>& at,
                           const P (&f)[D * D], P (&piola)[D * D]) {
  P cof[D * D];
  cofactor(f, cof);
  first_piola<law, P, D>(block.material, f, cof, piola);
  const P pressure = block.pressure != nullptr
                         ? mean_pressure<P, D>(block, at)
                         : P(block.volumetric_modulus) * dilatation<law, P, D>(f);
  add_volumetric_stress<law, P, D>(pressure, f, cof, piola);
}

/// Checks that F is finite and J positive in all lanes; otherwise returns the first lane where not.
template <class P, int D>
inline int impossible_element(const P (&f)[D * D]) {
  using T = Scalar<P>;
  P finite(T(0));
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) finite = fused(f[c], P(T(0)), finite);
  const auto sound = (finite == P(T(0))) && (determinant(f) > P(T(0)));
  return xsimd::all(sound) ? -1 : first_lane<P>(!sound);
}

template <ElasticLaw law, class P, int D>
inline PointForcesResult element_forces_of(const ElementBlock<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  collect_points<P, D>(block, block.pressure);
  PointForcesResult result;
  for (int element = 0; element < block.elements; element += lanes<P>) {
    const ElementLanes<P, D> at(block, element);
    P f[D * D], piola[D * D], sum[D];
    element_gradient<P, D>(block, at, f);
    if (block.examine && result.non_finite < 0) {
      const int bad = impossible_element<P, D>(f);
      if (bad >= 0) {
        const int local = at.corners(0)[bad] / point_stride;
        result.non_finite =
            local < block.count ? block.first + local : block.halo[local - block.count];
      }
    }
    element_stress<law, P, D>(block, at, f, piola);
    if (block.initial_stress != nullptr) add_element_prestress<P, D>(block, element, f, piola);
    const P volume = load<P>(at.volume());
#pragma GCC unroll 9
    for (int c = 0; c < D * D; ++c) piola[c] = volume * piola[c];
    for (P& component : sum) component = P(T(0));
#pragma GCC unroll 3
    for (int a = 1; a <= D; ++a) {
      P t[D];
      for (P& component : t) component = P(T(0));
#pragma GCC unroll 3
      for (int j = 0; j < D; ++j) {
        const P g = load<P>(at.gradient(a, j));
#pragma GCC unroll 3
        for (int i = 0; i < D; ++i) t[i] = fused(piola[D * i + j], g, t[i]);
      }
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) sum[i] = sum[i] - t[i];
      PointLanes<P, D>::subtract(t, at.corners(a), block.force);
    }
    PointLanes<P, D>::subtract(sum, at.corners(0), block.force);
  }
  return result;
}

/// Forces of the elements of a block on their corners, (FE.5).
template <class P, int D>
PointForcesResult evaluate_element_forces(const ElementBlock<Scalar<P>, D>& block) {
  switch (block.material.law) {
    case ElasticLaw::neo_hookean:
      return element_forces_of<ElasticLaw::neo_hookean, P, D>(block);
    case ElasticLaw::st_venant_kirchhoff:
      return element_forces_of<ElasticLaw::st_venant_kirchhoff, P, D>(block);
    case ElasticLaw::reduced_polynomial:
      break;
  }
  return element_forces_of<ElasticLaw::reduced_polynomial, P, D>(block);
}

}  // namespace pliant::kernels
