#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace pliant {

/// A run of slots that hold particles of a body: first, first + 1, ..., last - 1.
struct SlotRun {
  std::int64_t first, last;
};

/// The arrays in which a body stores one field: one for each component, indexed by slot. Of the two
/// lists, only that of the simulation's precision is filled. Values of slots without a particle are
/// arbitrary.
struct FieldView {
  std::string_view name, unit;
  std::vector<std::span<const double>> values;
  std::vector<std::span<const float>> single_values;
};

}  // namespace pliant
