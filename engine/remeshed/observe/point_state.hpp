#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/remeshed/state/body.hpp"
#include "kernels/energy.hpp"
#include "kernels/law.hpp"
#include "kernels/remeshed/remeshing/set_determinant.hpp"
#include "kernels/remeshed/stage/relaxation.hpp"
#include "kernels/with_scalar.hpp"

/// Material quantities of single particles, for measurements and output; `fields` are those of a
/// body or of its remeshed copy.
namespace pliant::remeshed {

/// The material state (S or F) of a slot.
template <class T, int D>
std::array<T, kernels::material_components<D>> material_state(const FieldStore<T, D>& fields,
                                                              std::int64_t slot) {
  std::array<T, kernels::material_components<D>> state = {};
  for (int c = 0; c < fields.material_components(); ++c)
    state[c] = fields.get(Field::material, c)[slot];
  return state;
}

/// The shift [m] from the place of a slot such that its particle started in the first period,
/// (RP.93). It is whole periods, so that a body stays in one piece however often it has passed an
/// end.
template <class T, int D>
Point<D> passed_periods(const Lattice<D>& lattice, const FieldStore<T, D>& fields,
                        std::int64_t slot, const Cell<D>& cell) {
  Point<D> passed = {};
  for (int a = 0; a < D; ++a) {
    const double n = lattice.period[a];
    if (n == 0) continue;
    const double start = cell[a] + 0.5 - fields.get(Field::displacement, a)[slot] / lattice.spacing;
    passed[a] = -std::floor(start / n) * n * lattice.spacing;
  }
  return passed;
}

/// Inertial density, (RP.87) [kg/m^3].
template <class T, int D>
T density(const FieldStore<T, D>& fields, std::int64_t slot) {
  return fields.get(Field::mass)[slot] / fields.get(Field::volume)[slot];
}

/// Calls `f.operator()<Law>(carried, rho)` with the law of a material and the state of a slot, as
/// packs.
template <class T, int D, class F>
auto by_law(const kernels::Material<T>& material, const FieldStore<T, D>& fields, std::int64_t slot,
            F&& f) {
  using Pack = xsimd::batch<T, xsimd::sse2>;
  const auto state = material_state<T, D>(fields, slot);
  return kernels::with_model(material.model, [&]<kernels::Model model>() {
    using Law = kernels::Law<model, Pack, D>;
    Pack carried[Law::components];
    for (int c = 0; c < Law::components; ++c) carried[c] = Pack(state[c]);
    return f.template operator()<Law>(carried, Pack(density<T, D>(fields, slot)));
  });
}

/// sum p_i of (RP.10) [Pa].
template <class T, int D>
T memory_pressure(const FieldStore<T, D>& fields, std::int64_t slot) {
  T sum = 0;
  for (const Buffer<T>& pressure : fields[Field::memory_pressure]) sum += pressure[slot];
  return sum;
}

/// p of (RP.2), with the p_i of (RP.10) [Pa].
template <class T, int D>
T pressure(const Body<T, D>& body, const FieldStore<T, D>& fields, std::int64_t slot) {
  const kernels::Material<T>& material = body.material;
  const auto elastic = [&]<class Law>(const auto& carried, const auto& rho) {
    return Law::pressure(material, carried, rho).get(0);
  };
  return by_law<T, D>(material, fields, slot, elastic) + memory_pressure<T, D>(fields, slot);
}

/// sigma of (RP.2) [Pa], in the order of symmetric_index.
template <class T, int D>
std::array<T, kernels::symmetric_components<D>> stress_of(const Body<T, D>& body,
                                                          const FieldStore<T, D>& fields,
                                                          std::int64_t slot) {
  const kernels::Material<T>& material = body.material;
  const T relaxed = memory_pressure<T, D>(fields, slot);
  return by_law<T, D>(material, fields, slot, [&]<class Law>(const auto& carried, const auto& rho) {
    xsimd::batch<T, xsimd::sse2> sigma[Law::symmetric];
    Law::stress(material, carried, rho, sigma);
    std::array<T, kernels::symmetric_components<D>> result;
    for (int c = 0; c < Law::symmetric; ++c) result[c] = sigma[c].get(0);
    for (int i = 0; i < D; ++i) result[kernels::symmetric_index<D>(i, i)] -= relaxed;
    return result;
  });
}

/// Elastic energy per current volume [J/m^3], (RP.62), (RP.63), (RP.64), (PB.6) or (PB.7). It is in
/// double precision, since it is quadratic in a small strain.
template <class T, int D>
double energy_density(const Body<T, D>& body, const FieldStore<T, D>& fields, std::int64_t slot) {
  const auto material = kernels::with_scalar<double>(body.material);
  std::array<double, kernels::material_components<D>> state;
  std::ranges::copy(material_state<T, D>(fields, slot), state.begin());
  if (!kernels::carries_deformation(material.model)) {
    return kernels::linear_energy<double, D>(material, state.data(), density<T, D>(fields, slot));
  }
  const double volume_ratio = kernels::determinant<double, D>(state);
  double energy = kernels::hyperelastic_energy<double, D>(material, state.data());
  for (std::size_t i = 0; i < body.prony.size(); ++i) {
    const kernels::PronyTerm<double> term{body.prony[i].ratio, body.prony[i].time};
    const double pressure = fields.get(Field::memory_pressure, static_cast<int>(i))[slot];
    energy += kernels::relaxed_energy(term, material.bulk_modulus, pressure, volume_ratio - 1);
  }
  return energy / volume_ratio;
}

}  // namespace pliant::remeshed
