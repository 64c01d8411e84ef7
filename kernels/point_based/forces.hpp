#pragma once

#include <algorithm>

#include "kernels/dilatation.hpp"
#include "kernels/point_based/bonds_of_register.hpp"
#include "kernels/point_based/collect_points.hpp"
#include "kernels/point_based/groups_of_register.hpp"
#include "kernels/point_based/kept_gradient.hpp"
#include "kernels/point_based/memory_of_register.hpp"
#include "kernels/point_based/point_lanes.hpp"
#include "kernels/stiffening.hpp"

/// Forces of a block of nodes, for a register of nodes at a time, one in each lane: neighbours'
/// displacements -> F -> P -> forces along the bonds.
namespace pliant::kernels {

/// B = V (P - kappa (F - I) A) of (PB.5), plus the viscous stress (PB.9); adds pressure, (PB.11).
/// `shared` is the part of groups and of relaxation in the derivative of psi with respect to theta.
template <ElasticLaw law, class P, int D>
inline void stress_of_nodes(const PointForces<Scalar<P>, D>& block, std::int64_t slot,
                            const P& shared, const P (&h)[D * D], P (&b)[D * D], P (&pressure)[D]) {
  using T = Scalar<P>;
  constexpr int symmetric = symmetric_components<D>;
  P f[D * D], cof[D * D];
  with_unit<P, D>(h, f);
  if (block.kept[0] != nullptr) {
    P kept[D * D];
    apply_kept<P, D>(block, slot, f, kept);
  }
  cofactor(f, cof);
  first_piola<law, P, D>(block.material, f, cof, b);
  if (block.share != nullptr || block.bulk.terms > 0) {
    add_volumetric_stress<law, P, D>(shared, f, cof, b);
  }
  if (block.strain[0] != nullptr) {
    P e[symmetric], rate[symmetric], s[symmetric];
    green_strain<P, D>(f, e);
#pragma GCC unroll 6
    for (int c = 0; c < symmetric; ++c) {
      rate[c] = P(block.viscosity) * (e[c] - load<P>(block.strain[c] + slot));
      e[c].store_unaligned(block.strain[c] + slot);
    }
    hooke<P, D>(P(block.material.lame_modulus), P(block.material.shear_modulus), rate, s);
    add_pulled_back<P, D>(f, s, b);
  }
  if constexpr (law == ElasticLaw::reduced_polynomial) {
    if (block.networks.terms > 0) add_networks<P, D>(block, slot, f, b);
  }
  if (block.initial_stress[0] != nullptr) {
    add_initial_stress<P, D>(block.initial_stress, slot, f, b);
  }
  if (block.kept[0] != nullptr) {
    P p[D * D], transposed[D * D];
#pragma GCC unroll 9
    for (int c = 0; c < D * D; ++c) {
      p[c] = b[c];
      b[c] = P(T(0));
      transposed[c] = load<P>(block.kept[c % D * D + c / D] + slot);
    }
    add_product<P, D>(p, transposed, b);
  }
  const P volume = load<P>(block.volume + slot), stiffness = load<P>(block.stiffness + slot);
  P moment[symmetric];
#pragma GCC unroll 6
  for (int c = 0; c < symmetric; ++c) moment[c] = stiffness * load<P>(block.moment[c] + slot);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      P value = volume * b[D * i + j];
#pragma GCC unroll 3
      for (int k = 0; k < D; ++k) {
        value = fused_minus(h[D * i + k], moment[symmetric_index<D>(k, j)], value);
      }
      b[D * i + j] = value;
    }
  }
  for (P& component : pressure) component = P(T(0));
  if (block.load[0] == nullptr) return;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      pressure[i] = fused_minus(cof[D * i + j], load<P>(block.load[j] + slot), pressure[i]);
    }
  }
}

/// Checks that F is finite and J positive in all lanes; otherwise returns the first lane where not.
template <class P, int D>
inline int impossible_lane(const P (&h)[D * D]) {
  using T = Scalar<P>;
  P f[D * D], finite(T(0));
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) {
    f[c] = c % (D + 1) == 0 ? h[c] + P(T(1)) : h[c];
    finite = fused(f[c], P(T(0)), finite);
  }
  const auto sound = (finite == P(T(0))) && (determinant(f) > P(T(0)));
  return xsimd::all(sound) ? -1 : first_lane<P>(!sound);
}

/// Looks for states that are not possible, and for the largest lambda q^2 of (PB.12).
template <ElasticLaw law, class P, int D>
[[gnu::noinline]] void examine_register(const PointForces<Scalar<P>, D>& block, std::int64_t slot,
                                        const P (&h)[D * D], PointForcesResult& result) {
  using T = Scalar<P>;
  const int bad = impossible_lane<P, D>(h);
  if (bad >= 0) {
    if (result.non_finite < 0) result.non_finite = slot + bad;
    return;
  }
  P f[D * D], stretch(T(1));
  with_unit<P, D>(h, f);
  if (block.kept[0] != nullptr) {
    P kept[D * D];
    apply_kept<P, D>(block, slot, f, kept);
    stretch = norm2_of<P, D>(kept);
  }
  P stiffening = stiffening2<law, P, D>(block.material, f);
  if constexpr (law == ElasticLaw::reduced_polynomial) {
    if (block.networks.terms > 0) {
      stiffening = stiffening2<law, P, D>(block.material, f, network_modulus<P, D>(block, slot, f));
    }
  }
  const P frequency2 = load<P>(block.frequency2 + slot) * stretch * stiffening;
  result.frequency2 = std::max(result.frequency2, static_cast<double>(largest(frequency2)));
}

/// F - I of (PB.4); stores d of every bond.
template <class P, int D>
[[gnu::always_inline]] inline void displacement_gradient(const PointForces<Scalar<P>, D>& block,
                                                         const RegisterBonds<Scalar<P>, D>& bonds,
                                                         std::int64_t slot,
                                                         P (&difference)[most_bonds][D],
                                                         P (&h)[D * D]) {
  using T = Scalar<P>;
  const BondPrefetch<P, D> prefetch(bonds, block.bonds, slot % slots_per_pack, 0);
  P here[D], sum[D * D];
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) here[a] = load<P>(block.displacement[a] + slot);
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) sum[c] = P(T(0));
  for (int k = 0; k < block.bonds; ++k) {
    prefetch(k);
    P d[D];
    PointLanes<P, D>::gather(block.point, bonds.neighbours(k), d);
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      d[a] = d[a] - here[a];
      difference[k][a] = d[a];
    }
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      const P g = load<P>(bonds.coefficients(k, j));
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) sum[D * i + j] = fused(d[i], g, sum[D * i + j]);
    }
  }
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) h[c] = sum[c];
}

/// Adds T_ij of (PB.8) of all bonds to the nodes and subtracts it from their neighbours.
template <class P, int D>
[[gnu::always_inline]] inline void add_bond_forces(const PointForces<Scalar<P>, D>& block,
                                                   const RegisterBonds<Scalar<P>, D>& bonds,
                                                   std::int64_t slot,
                                                   const P (&difference)[most_bonds][D],
                                                   const P (&b)[D * D], P (&sum)[D]) {
  const BondPrefetch<P, D> prefetch(bonds, block.bonds, slot % slots_per_pack, 1);
  const P stiffness = load<P>(block.stiffness + slot);
  for (int k = 0; k < block.bonds; ++k) {
    prefetch(k);
    const P weight = stiffness * load<P>(bonds.coefficients(k, D));
    P t[D];
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) t[i] = weight * difference[k][i];
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      const P g = load<P>(bonds.coefficients(k, j));
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) t[i] = fused(b[D * i + j], g, t[i]);
    }
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) sum[i] = sum[i] + t[i];
    PointLanes<P, D>::subtract(t, bonds.neighbours(k), block.force);
  }
}

/// The bonds of a register of nodes; `local` is the local number of its first one.
template <class P, int D>
[[gnu::always_inline]] inline RegisterBonds<Scalar<P>, D> bonds_of_nodes(
    const PointForces<Scalar<P>, D>& block, int local) {
  const int lane = local % slots_per_pack;
  const auto pack = static_cast<std::int64_t>(local - lane) * block.bonds;
  return {block.neighbour + pack + lane, block.bond + pack * (D + 1) + lane};
}

/// Forces of the registers of nodes from local number `local` on: one, or as many as a group needs.
/// Every sum must stay in registers, so loops over components must be unrolled, and everything
/// inlined.
template <ElasticLaw law, class P, int D>
inline void add_forces_of_registers(const PointForces<Scalar<P>, D>& block, int local,
                                    PointForcesResult& result) {
  using T = Scalar<P>;
  constexpr int registers = registers_of_groups<P, D>;
  P difference[registers][most_bonds][D], h[registers][D * D], shared[registers];
  for (P& of_register : shared) of_register = P(T(0));
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) {
    const int first = local + r * lanes<P>;
    displacement_gradient(block, bonds_of_nodes<P, D>(block, first), block.first + first,
                          difference[r], h[r]);
    if (block.examine) examine_register<law, P, D>(block, block.first + first, h[r], result);
  }
  if (block.share != nullptr) shared_pressure<law, P, D>(block, block.first + local, h, shared);
  if constexpr (law == ElasticLaw::reduced_polynomial) {
    if (block.bulk.terms > 0) relax_nodes<P, D>(block, block.first + local, h, shared);
  }
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) {
    const int first = local + r * lanes<P>;
    P b[D * D], sum[D];
    stress_of_nodes<law, P, D>(block, block.first + first, shared[r], h[r], b, sum);
    add_bond_forces(block, bonds_of_nodes<P, D>(block, first), block.first + first, difference[r],
                    b, sum);
    std::uint16_t own[lanes<P>];
    for (int l = 0; l < lanes<P>; ++l) {
      own[l] = static_cast<std::uint16_t>(point_stride * (first + l));
    }
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) sum[i] = P(T(0)) - sum[i];
    PointLanes<P, D>::subtract(sum, own, block.force);
  }
}

template <ElasticLaw law, class P, int D>
inline PointForcesResult evaluate_forces_of(const PointForces<Scalar<P>, D>& block) {
  collect_points<P, D>(block, nullptr);
  PointForcesResult result;
  for (int local = 0; local < block.count; local += registers_of_groups<P, D> * lanes<P>) {
    add_forces_of_registers<law, P, D>(block, local, result);
  }
  return result;
}

template <class P, int D>
PointForcesResult evaluate_point_forces(const PointForces<Scalar<P>, D>& block) {
  switch (block.material.law) {
    case ElasticLaw::neo_hookean:
      return evaluate_forces_of<ElasticLaw::neo_hookean, P, D>(block);
    case ElasticLaw::st_venant_kirchhoff:
      return evaluate_forces_of<ElasticLaw::st_venant_kirchhoff, P, D>(block);
    case ElasticLaw::reduced_polynomial:
      break;
  }
  return evaluate_forces_of<ElasticLaw::reduced_polynomial, P, D>(block);
}

}  // namespace pliant::kernels
