#pragma once

#include <array>
#include <cstdint>

#include "engine/remeshed/state/body.hpp"

/// Arguments of the pair forces (RP.26) of plain SPH.
namespace pliant::sph {

/// The stress of a body's particles, in the form for pair forces.
template <class T, int D>
struct PairStress {
  using Tensor = std::array<Buffer<T>, kernels::symmetric_components<D>>;
  Tensor scaled;      ///< sigma/rho^2 [m^5/(kg s^2)]
  Tensor artificial;  ///< R of (RP.28) [m^5/(kg s^2)]

  void grow(std::int64_t slots) {
    for (Tensor* tensor : {&scaled, &artificial}) {
      for (Buffer<T>& component : *tensor) component.grow(slots, T(0));
    }
  }

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const Tensor* tensor : {&scaled, &artificial}) {
      for (const Buffer<T>& component : *tensor) sum += component.bytes();
    }
    return sum;
  }
};

/// Computes the pair stress of a block's particles at a stage; `artificial_stress` is epsilon of
/// (RP.28).
template <class T, int D>
void find_pair_stress(const remeshed::Body<T, D>& body, int block, int stage,
                      double artificial_stress, PairStress<T, D>& pair_stress);

/// A view of the pair stress for the kernel, with the viscosity of (RP.27): beta = 2 alpha, and c
/// of the material at rest.
template <class T, int D>
kernels::SymmetricPairs<T, D> symmetric_pairs(const remeshed::Body<T, D>& body,
                                              const PairStress<T, D>& pair_stress,
                                              double artificial_viscosity) {
  kernels::SymmetricPairs<T, D> pairs;
  for (int c = 0; c < kernels::symmetric_components<D>; ++c) {
    pairs.stress[c] = pair_stress.scaled[c].get();
    pairs.artificial[c] = pair_stress.artificial[c].get();
  }
  pairs.linear = static_cast<T>(artificial_viscosity) * kernels::wave_speed_at_rest(body.material);
  pairs.quadratic = static_cast<T>(2 * artificial_viscosity);
  return pairs;
}

}  // namespace pliant::sph
