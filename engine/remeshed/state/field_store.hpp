#pragma once

#include <array>
#include <vector>

#include "engine/remeshed/state/fields.hpp"
#include "engine/storage/buffer.hpp"
#include "kernels/material.hpp"
#include "kernels/remeshed/evolving.hpp"

namespace pliant::remeshed {

/// Components of a field of the state; `material_components` are those of the material state (S or
/// F), `terms` the terms of the Prony series.
template <int D>
constexpr int components(Rank rank, int material_components, int terms = 0) {
  switch (rank) {
    case Rank::vector:
      return D;
    case Rank::material:
      return material_components;
    case Rank::prony:
      return terms;
    default:
      return 1;
  }
}

/// One copy of the state as a structure of arrays, with the fields that have this many copies.
template <class T, int D>
class FieldStore {
 public:
  FieldStore() = default;
  FieldStore(kernels::Model model, int prony_terms, int copy)
      : material_components_(kernels::material_component_count<D>(model)) {
    for (const Declaration& f : state_fields) {
      if (f.copies <= copy) continue;
      (*this)[f.field].resize(components<D>(f.rank, material_components_, prony_terms));
    }
  }

  /// Makes room for `slots`; new slots contain zeros, which are valid for vacant slots.
  void grow(std::int64_t slots) {
    for (auto& field : arrays_) {
      for (Buffer<T>& component : field) component.grow(slots, T(0));
    }
  }

  std::vector<Buffer<T>>& operator[](Field f) { return arrays_[static_cast<int>(f)]; }
  const std::vector<Buffer<T>>& operator[](Field f) const { return arrays_[static_cast<int>(f)]; }
  T* get(Field f, int component = 0) { return (*this)[f][component].get(); }
  const T* get(Field f, int component = 0) const { return (*this)[f][component].get(); }

  /// The evolving fields of this copy.
  template <class U = T>
  kernels::Evolving<U, D> evolving() {
    kernels::Evolving<U, D> view = {};
    for (std::size_t a = 0; a < (*this)[Field::drift].size(); ++a) {
      view.drift[a] = (*this)[Field::drift][a].get();
    }
    for (int a = 0; a < D; ++a) view.velocity[a] = get(Field::velocity, a);
    view.volume = get(Field::volume);
    for (int c = 0; c < material_components_; ++c) view.material[c] = get(Field::material, c);
    return view;
  }

  int material_components() const { return material_components_; }

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& field : arrays_) {
      for (const Buffer<T>& component : field) sum += component.bytes();
    }
    return sum;
  }

 private:
  int material_components_ = 0;
  std::array<std::vector<Buffer<T>>, state_field_count> arrays_;
};

/// A component of a field of the state.
struct StateComponent {
  Field field;
  int component;
};

/// The fields that store the components of sigma in odd stages: fields of Q2 that only a remeshing
/// and its follow-up write, (RP.21). The last component in 3D has its own array.
template <int D>
inline constexpr auto odd_stress_storage = [] {
  using F = Field;
  if constexpr (D == 2) {
    return std::to_array<StateComponent>({{F::mass, 0}, {F::level_set, 0}, {F::displacement, 0}});
  } else {
    return std::to_array<StateComponent>({{F::mass, 0},
                                          {F::level_set, 0},
                                          {F::displacement, 0},
                                          {F::displacement, 1},
                                          {F::displacement, 2}});
  }
}();

}  // namespace pliant::remeshed
