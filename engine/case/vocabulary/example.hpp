#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/case/vocabulary/key.hpp"

/// Examples of values in messages, with as many components as the case has dimensions.
namespace pliant {

/// The example with `dimension` components in every list of numbers or formulas: a 0 (or, without
/// one, a 1) is repeated or removed.
std::string with_components(std::string_view example, int dimension);

/// The example of a key for a value of this type.
template <class Value>
std::string example_in(std::string_view example, int dimension) {
  using V = std::remove_cvref_t<Value>;
  constexpr bool has_vectors =
      std::is_same_v<V, Vector> || std::is_same_v<V, Direction> ||
      std::is_same_v<V, VectorExpression> || std::is_same_v<V, std::optional<VectorExpression>> ||
      std::is_same_v<V, Shape> || std::is_same_v<V, std::vector<Shape>> ||
      std::is_same_v<V, std::optional<RigidRotation>> ||
      std::is_same_v<V, std::optional<WallRotation>> || std::is_same_v<V, AngularVelocity>;
  if constexpr (has_vectors) return with_components(example, dimension);
  return std::string(example);
}

}  // namespace pliant
