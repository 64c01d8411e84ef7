#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace pliant {

/// Slots first, first + 1, ..., last - 1 of a body hold particles.
struct SlotRun {
  std::int64_t first, last;
};

/// The arrays in which a body keeps one field: one for each component, indexed by slot. One of the
/// two lists is filled, that of the precision of the simulation. Slots without a particle hold any
/// number.
struct FieldView {
  std::string_view name, unit;
  std::vector<std::span<const double>> values;
  std::vector<std::span<const float>> single_values;
};

}  // namespace pliant
