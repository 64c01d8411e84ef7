#pragma once

#include <array>
#include <pliant/field.hpp>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/lattice/layout.hpp"
#include "engine/storage/buffer.hpp"

/// Views of the arrays of a method, for callers of the library.
namespace pliant {

/// The first `slots` values of each component.
template <class T, class Components>
FieldView field_view(std::string_view name, std::string_view unit, const Components& components,
                     std::int64_t slots) {
  FieldView view{name, unit, {}, {}};
  for (const Buffer<T>& component : components) {
    const std::span<const T> values(component.get(), static_cast<std::size_t>(slots));
    if constexpr (std::is_same_v<T, double>) {
      view.values.push_back(values);
    } else {
      view.single_values.push_back(values);
    }
  }
  return view;
}

/// Runs of the slots for which `is_particle(slot)`.
template <int D, class F>
std::vector<SlotRun> runs_of_particles(const Layout<D>& layout, F&& is_particle) {
  std::vector<SlotRun> runs;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t slot, const Cell<D>&) {
      if (!is_particle(slot)) return;
      const bool continues = !runs.empty() && runs.back().last == slot;
      if (continues) {
        ++runs.back().last;
      } else {
        runs.push_back({slot, slot + 1});
      }
    });
  }
  return runs;
}

/// position(slot, cell) of each slot for which `is_particle(slot)`; z = 0 in 2D.
template <int D, class F, class G>
std::vector<std::array<double, 3>> positions_of_particles(const Layout<D>& layout, F&& is_particle,
                                                          G&& position) {
  std::vector<std::array<double, 3>> positions;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t slot, const Cell<D>& cell) {
      if (!is_particle(slot)) return;
      const Point<D> x = position(slot, cell);
      std::array<double, 3>& padded = positions.emplace_back();
      for (int a = 0; a < D; ++a) padded[a] = x[a];
    });
  }
  return positions;
}

}  // namespace pliant
