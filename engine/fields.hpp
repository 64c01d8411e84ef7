#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "engine/storage/buffer.hpp"
#include "kernels/material.hpp"
#include "kernels/remeshed/evolving.hpp"

/// The one list of particle fields: storage, stage copies, checkpoints, output and the scheduler's
/// names follow from it.
namespace pliant {

enum class Field {
  drift,
  velocity,
  volume,
  material,
  mass,
  level_set,
  displacement,
  memory_pressure
};
inline constexpr int field_count = 8;

enum class Rank { scalar, vector, material, prony };

/// How a field crosses to the new lattice, (RP.22) and (RP.23).
enum class Remeshed { not_at_all, as_density_times_volume, as_mass_mean, as_volume_mean, as_mean };

struct FieldDeclaration {
  Field field;
  std::string_view symbol, name, unit;
  Rank rank;
  Remeshed remeshed;
  bool evolving;  ///< advanced by the Runge-Kutta method, so that each stage has its copy
};

inline constexpr std::array<FieldDeclaration, field_count> fields = {{
    {Field::drift, "xi", "drift", "m", Rank::vector, Remeshed::not_at_all, true},
    {Field::velocity, "u", "velocity", "m/s", Rank::vector, Remeshed::as_mass_mean, true},
    {Field::volume, "v", "volume", "m^D", Rank::scalar, Remeshed::as_density_times_volume, true},
    {Field::material, "S|F", "material_state", "Pa|1", Rank::material, Remeshed::as_volume_mean,
     true},
    {Field::mass, "m", "mass", "kg", Rank::scalar, Remeshed::as_density_times_volume, false},
    {Field::level_set, "phi", "level_set", "m", Rank::scalar, Remeshed::as_mean, false},
    {Field::displacement, "d", "displacement", "m", Rank::vector, Remeshed::as_volume_mean, false},
    {Field::memory_pressure, "p_i", "memory_pressure", "Pa", Rank::prony, Remeshed::as_volume_mean,
     false},
}};

/// Components of a field; `material_components` are those of what the material model evolves (S or
/// F), `terms` those of its Prony series.
template <int D>
constexpr int components(Rank rank, int material_components, int terms = 0) {
  switch (rank) {
    case Rank::scalar:
      return 1;
    case Rank::vector:
      return D;
    case Rank::material:
      return material_components;
    case Rank::prony:
      break;
  }
  return terms;
}

/// Structure of arrays of the declared fields, or of the evolving ones only.
template <class T, int D>
class FieldStore {
 public:
  FieldStore() = default;
  FieldStore(kernels::Model model, int prony_terms, bool evolving_only)
      : material_components_(kernels::material_component_count<D>(model)) {
    for (const FieldDeclaration& f : fields) {
      if (evolving_only && !f.evolving) continue;
      arrays_[static_cast<int>(f.field)].resize(
          components<D>(f.rank, material_components_, prony_terms));
    }
  }

  /// Room for `slots`; new slots hold zeros, which vacant slots may.
  void grow(std::int64_t slots) {
    for (auto& field : arrays_) {
      for (Buffer<T>& component : field) component.grow(slots, T(0));
    }
  }

  std::vector<Buffer<T>>& operator[](Field f) { return arrays_[static_cast<int>(f)]; }
  const std::vector<Buffer<T>>& operator[](Field f) const { return arrays_[static_cast<int>(f)]; }
  T* get(Field f, int component = 0) { return (*this)[f][component].get(); }
  const T* get(Field f, int component = 0) const { return (*this)[f][component].get(); }

  template <class U = T>
  kernels::Evolving<U, D> evolving() {
    kernels::Evolving<U, D> view = {};
    for (int a = 0; a < D; ++a) {
      view.drift[a] = get(Field::drift, a);
      view.velocity[a] = get(Field::velocity, a);
    }
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
  std::array<std::vector<Buffer<T>>, field_count> arrays_;
};

}  // namespace pliant
