#pragma once

#include <array>

#include "engine/fields.hpp"
#include "kernels/energy.hpp"
#include "kernels/law.hpp"

/// Material quantities of single particles, for measurements and output.
namespace pliant::remeshed {

/// The carried state (S or F) of a slot.
template <class T, int D>
std::array<T, kernels::material_components<D>> carried_state(const FieldStore<T, D>& fields,
                                                             std::int64_t slot) {
  std::array<T, kernels::material_components<D>> state = {};
  for (int c = 0; c < fields.carried(); ++c) state[c] = fields.get(Field::material, c)[slot];
  return state;
}

template <class T, int D>
T density(const FieldStore<T, D>& fields, std::int64_t slot) {
  return fields.get(Field::mass)[slot] / fields.get(Field::volume)[slot];
}

/// Calls `f.operator()<Law>(carried, rho)` with the law of a material and the state of a slot in
/// packs.
template <class T, int D, class F>
auto by_law(const kernels::Material<T>& material, const FieldStore<T, D>& fields, std::int64_t slot,
            F&& f) {
  using Pack = xsimd::batch<T, xsimd::sse2>;
  const auto state = carried_state<T, D>(fields, slot);
  const auto call = [&]<kernels::Model model>() {
    using Law = kernels::Law<model, Pack, D>;
    Pack carried[Law::components];
    for (int c = 0; c < Law::components; ++c) carried[c] = Pack(state[c]);
    return f.template operator()<Law>(carried, Pack(density<T, D>(fields, slot)));
  };
  switch (material.model) {
    case kernels::Model::linear_rho:
      return call.template operator()<kernels::Model::linear_rho>();
    case kernels::Model::linear_log:
      return call.template operator()<kernels::Model::linear_log>();
    default:
      return call.template operator()<kernels::Model::reduced_polynomial>();
  }
}

/// p of (RP.5), (RP.6) or (RP.9) [Pa].
template <class T, int D>
T pressure(const kernels::Material<T>& material, const FieldStore<T, D>& fields,
           std::int64_t slot) {
  return by_law<T, D>(material, fields, slot, [&]<class Law>(const auto& carried, const auto& rho) {
    return Law::pressure(material, carried, rho).get(0);
  });
}

/// sigma of (RP.2) [Pa], in the order of symmetric_index.
template <class T, int D>
std::array<T, kernels::symmetric_components<D>> stress(const kernels::Material<T>& material,
                                                       const FieldStore<T, D>& fields,
                                                       std::int64_t slot) {
  return by_law<T, D>(material, fields, slot, [&]<class Law>(const auto& carried, const auto& rho) {
    xsimd::batch<T, xsimd::sse2> sigma[Law::symmetric];
    Law::stress(material, carried, rho, sigma);
    std::array<T, kernels::symmetric_components<D>> result;
    for (int c = 0; c < Law::symmetric; ++c) result[c] = sigma[c].get(0);
    return result;
  });
}

/// Elastic energy per current volume [J/m^3], (RP.40) or (RP.41).
template <class T, int D>
T energy_density(const kernels::Material<T>& material, const FieldStore<T, D>& fields,
                 std::int64_t slot) {
  const auto state = carried_state<T, D>(fields, slot);
  return material.model == kernels::Model::reduced_polynomial
             ? kernels::polynomial_energy<T, D>(material, state.data())
             : kernels::linear_energy<T, D>(material, state.data(), density<T, D>(fields, slot));
}

}  // namespace pliant::remeshed
