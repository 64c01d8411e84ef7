#pragma once

#include <cstddef>

#include "kernels/hyperelastic_material.hpp"

namespace pliant::kernels {

/// A material with its constants converted to the scalar type T.
template <class T, class U>
Material<T> with_scalar(const Material<U>& m) {
  Material<T> material;
  material.model = m.model;
  material.density = static_cast<T>(m.density);
  material.bulk_modulus = static_cast<T>(m.bulk_modulus);
  material.shear_modulus = static_cast<T>(m.shear_modulus);
  material.order = m.order;
  for (std::size_t n = 0; n < m.coefficient.size(); ++n) {
    material.coefficient[n] = static_cast<T>(m.coefficient[n]);
  }
  material.compressibility = static_cast<T>(m.compressibility);
  return material;
}

template <class T, class U>
HyperelasticMaterial<T> with_scalar(const HyperelasticMaterial<U>& m) {
  return {m.law, static_cast<T>(m.density), static_cast<T>(m.shear_modulus),
          static_cast<T>(m.lame_modulus), with_scalar<T>(m.polynomial)};
}

}  // namespace pliant::kernels
