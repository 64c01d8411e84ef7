#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/point_based/state.hpp"
#include "engine/storage/buffer.hpp"
#include "kernels/finite_elements/table.hpp"

namespace pliant::finite_elements {

using undeformed::Clock;

/// Elements of a block of nodes, padded to whole packs with elements without volume.
struct ElementRange {
  std::int64_t first;
  int count;
};

/// The elements of a body, in the order of the blocks that they belong to.
template <class T, int D>
struct Elements {
  kernels::HyperelasticMaterial<T> material;  ///< with zero volumetric modulus
  T volumetric_modulus = 0;                   ///< Lambda of (FE.3) [Pa]
  double highest_frequency = 0;               ///< a bound, (FE.6) [1/s]
  std::vector<ElementRange> blocks;
  Buffer<std::uint16_t> corner;  ///< [pack][D + 1][lane] local numbers times point_stride
  Buffer<T> shape;               ///< [pack][element_values][lane]
  Buffer<T> initial_stress;      ///< [pack][component][lane] S0 of (TL.14) [Pa]; none: 0
  Buffer<T> pressure;            ///< [slot] of (FE.4) [Pa]; none: (FE.3)
  std::vector<std::array<std::int32_t, D + 1>> slots;  ///< [element] of the corners

  bool averages() const { return pressure.bytes() > 0; }
  bool is_prestressed() const { return initial_stress.bytes() > 0; }

  /// The initial stress of an element [Pa], in the order of symmetric_index.
  std::array<double, kernels::symmetric_components<D>> prestress(std::int64_t element) const {
    std::array<double, kernels::symmetric_components<D>> stress;
    for (std::size_t c = 0; c < stress.size(); ++c) {
      stress[c] = initial_stress[stress_place(element, static_cast<int>(c))];
    }
    return stress;
  }
  static std::int64_t stress_place(std::int64_t element, int component) {
    constexpr int lanes = kernels::slots_per_pack, count = kernels::symmetric_components<D>;
    return (element / lanes * count + component) * lanes + element % lanes;
  }

  /// Size of its arrays [B].
  std::size_t bytes() const {
    return corner.bytes() + shape.bytes() + initial_stress.bytes() + pressure.bytes() +
           slots.size() * sizeof(slots[0]);
  }

  /// Component j of the gradient of corner a = 1 .. D [1/m].
  double gradient(std::int64_t element, int a, int j) const {
    return value(element, (a - 1) * D + j);
  }
  double volume(std::int64_t element) const { return value(element, D * D); }

 private:
  double value(std::int64_t element, int which) const {
    constexpr int lanes = kernels::slots_per_pack;
    const std::int64_t pack = element / lanes, lane = element % lanes;
    return shape[(pack * kernels::element_values<D> + which) * lanes + lane];
  }
};

/// The nodes are those of the point-based method: they move, are held and are loaded in the same
/// way. Their bonds give the gradients in frames, (FE.7).
template <class T, int D>
struct State : point_based::State<T, D> {
  using point_based::State<T, D>::State;

  std::vector<Elements<T, D>> elements;  ///< [body]
};

}  // namespace pliant::finite_elements
