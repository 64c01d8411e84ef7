#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/method/field.hpp"
#include "engine/output/results/frame.hpp"

namespace pliant {

/// A field of a frame, with its name and unit from the list of its method.
template <class Field, class IndexSpace, class Group, class V>
FrameField shown(const FieldDeclaration<Field, IndexSpace, Group>& field, int components,
                 std::vector<V> values) {
  return {std::string(field.name), std::string(field.unit), components, std::move(values)};
}

}  // namespace pliant
