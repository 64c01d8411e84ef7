#pragma once

#include "kernels/point_based/first_piola.hpp"
#include "kernels/point_based/point_lanes.hpp"

/// Forces of a block of nodes, a pack of nodes at a time with one node in each lane:
/// neighbours' displacements -> F -> P -> forces along the bonds.
namespace pliant::kernels {

/// Copies displacements of own slots and of the halo into the array of points, and clears forces.
template <class P, int D>
inline void collect_points(const PointForces<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  T* to = block.point;
  const auto put = [&](std::int64_t slot) {
    for (int a = 0; a < D; ++a) to[a] = block.displacement[a][slot];
    for (int a = D; a < point_stride; ++a) to[a] = T(0);
    to += point_stride;
  };
  for (int i = 0; i < block.count; ++i) put(block.first + i);
  for (int i = 0; i < block.halo_count; ++i) put(block.halo[i]);
  const int values = (block.count + block.halo_count) * point_stride;
  for (int i = 0; i < values; ++i) block.force[i] = T(0);
}

/// What the bonds of a pack of nodes need: numbers and coefficients of bond k in lane l.
template <class T, int D>
struct PackBonds {
  const std::uint16_t* neighbour;
  const T* bond;

  const std::uint16_t* numbers(int k, int lane) const {
    return neighbour + k * slots_per_pack + lane;
  }
  /// g for c < D, w for c = D.
  const T* coefficient(int k, int c, int lane) const {
    return bond + (k * (D + 1) + c) * slots_per_pack + lane;
  }
};

/// c += a b.
template <class P, int D>
inline void add_product(const P (&a)[D * D], const P (&b)[D * D], P (&c)[D * D]) {
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      for (int k = 0; k < D; ++k) c[D * i + j] = fused(a[D * i + k], b[D * k + j], c[D * i + j]);
    }
  }
}

/// B = V (P - kappa (F - I) A) of (PB.5), plus the viscous stress (PB.9); adds pressure, (PB.11).
template <ElasticLaw law, class P, int D>
inline void stress_of_nodes(const PointForces<Scalar<P>, D>& block, std::int64_t slot,
                            const P (&h)[D * D], P (&b)[D * D], P (&pressure)[D]) {
  using T = Scalar<P>;
  constexpr int symmetric = symmetric_components<D>;
  P f[D * D], cof[D * D];
  for (int c = 0; c < D * D; ++c) f[c] = c % (D + 1) == 0 ? h[c] + P(T(1)) : h[c];
  if (block.kept[0] != nullptr) {
    P fit[D * D], kept[D * D];
    for (int c = 0; c < D * D; ++c) {
      kept[c] = load<P>(block.kept[c] + slot);
      fit[c] = f[c];
      f[c] = P(T(0));
    }
    add_product<P, D>(fit, kept, f);
  }
  cofactor(f, cof);
  first_piola<law, P, D>(block.material, f, cof, b);
  if (block.strain[0] != nullptr) {
    P e[symmetric], rate[symmetric], s[symmetric];
    green_strain<P, D>(f, e);
    for (int c = 0; c < symmetric; ++c) {
      rate[c] = P(block.viscosity) * (e[c] - load<P>(block.strain[c] + slot));
      e[c].store_unaligned(block.strain[c] + slot);
    }
    hooke<P, D>(P(block.material.lame_modulus), P(block.material.shear_modulus), rate, s);
    add_pulled_back<P, D>(f, s, b);
  }
  if (block.kept[0] != nullptr) {
    P p[D * D], transposed[D * D];
    for (int c = 0; c < D * D; ++c) {
      p[c] = b[c];
      b[c] = P(T(0));
      transposed[c] = load<P>(block.kept[c % D * D + c / D] + slot);
    }
    add_product<P, D>(p, transposed, b);
  }
  const P volume = load<P>(block.volume + slot), stiffness = load<P>(block.stiffness + slot);
  P moment[symmetric];
  for (int c = 0; c < symmetric; ++c) moment[c] = stiffness * load<P>(block.moment[c] + slot);
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      P value = volume * b[D * i + j];
      for (int k = 0; k < D; ++k) {
        value = fused_minus(h[D * i + k], moment[symmetric_index<D>(k, j)], value);
      }
      b[D * i + j] = value;
    }
  }
  for (P& component : pressure) component = P(T(0));
  if (block.load[0] == nullptr) return;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      pressure[i] = fused_minus(cof[D * i + j], load<P>(block.load[j] + slot), pressure[i]);
    }
  }
}

/// Whether F is finite and J positive in all lanes; else the first lane where not.
template <class P, int D>
inline int impossible_lane(const P (&h)[D * D]) {
  using T = Scalar<P>;
  P f[D * D], finite(T(0));
  for (int c = 0; c < D * D; ++c) {
    f[c] = c % (D + 1) == 0 ? h[c] + P(T(1)) : h[c];
    finite = fused(f[c], P(T(0)), finite);
  }
  const auto sound = (finite == P(T(0))) && (determinant(f) > P(T(0)));
  return xsimd::all(sound) ? -1 : first_lane<P>(!sound);
}

/// Forces of the pack of nodes that starts at local number `local`.
template <ElasticLaw law, class P, int D>
inline void add_forces_of_pack(const PointForces<Scalar<P>, D>& block, int local,
                               std::int64_t& non_finite) {
  using T = Scalar<P>;
  using Points = PointLanes<P, D>;
  constexpr int registers = registers_per_pack<P>;
  const std::int64_t slot = block.first + local;
  const PackBonds<T, D> bonds = {
      block.neighbour + static_cast<std::int64_t>(local) * block.bonds,
      block.bond + static_cast<std::int64_t>(local) * block.bonds * (D + 1)};
  alignas(64) T difference[most_bonds][D][slots_per_pack];
  P b[registers][D * D], sum[registers][D], stiffness[registers];
  for (int r = 0; r < registers; ++r) {
    const int lane = r * lanes<P>;
    P here[D], h[D * D];
    for (int a = 0; a < D; ++a) here[a] = load<P>(block.displacement[a] + slot + lane);
    for (P& component : h) component = P(T(0));
    for (int k = 0; k < block.bonds; ++k) {
      P d[D], g[D];
      Points::gather(block.point, bonds.numbers(k, lane), d);
      for (int a = 0; a < D; ++a) {
        g[a] = load<P>(bonds.coefficient(k, a, lane));
        d[a] = d[a] - here[a];
        d[a].store_aligned(&difference[k][a][lane]);
      }
      for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) h[D * i + j] = fused(d[i], g[j], h[D * i + j]);
      }
    }
    if (block.examine && non_finite < 0) {
      const int bad = impossible_lane<P, D>(h);
      if (bad >= 0) non_finite = slot + lane + bad;
    }
    stress_of_nodes<law, P, D>(block, slot + lane, h, b[r], sum[r]);
    stiffness[r] = load<P>(block.stiffness + slot + lane);
  }
  for (int k = 0; k < block.bonds; ++k) {
    for (int r = 0; r < registers; ++r) {
      const int lane = r * lanes<P>;
      const P weight = stiffness[r] * load<P>(bonds.coefficient(k, D, lane));
      P t[D];
      for (int i = 0; i < D; ++i) t[i] = weight * P::load_aligned(&difference[k][i][lane]);
      for (int j = 0; j < D; ++j) {
        const P g = load<P>(bonds.coefficient(k, j, lane));
        for (int i = 0; i < D; ++i) t[i] = fused(b[r][D * i + j], g, t[i]);
      }
      for (int i = 0; i < D; ++i) sum[r][i] = sum[r][i] + t[i];
      Points::subtract(t, bonds.numbers(k, lane), block.force);
    }
  }
  std::uint16_t own[slots_per_pack];
  for (int l = 0; l < slots_per_pack; ++l) own[l] = static_cast<std::uint16_t>(local + l);
  for (int r = 0; r < registers; ++r) {
    for (int i = 0; i < D; ++i) sum[r][i] = P(T(0)) - sum[r][i];
    Points::subtract(sum[r], own + r * lanes<P>, block.force);
  }
}

template <ElasticLaw law, class P, int D>
inline PointForcesResult evaluate_forces_of(const PointForces<Scalar<P>, D>& block) {
  collect_points<P, D>(block);
  PointForcesResult result = {-1};
  for (int local = 0; local < block.count; local += slots_per_pack) {
    add_forces_of_pack<law, P, D>(block, local, result.non_finite);
  }
  return result;
}

/// See PointForces.
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
