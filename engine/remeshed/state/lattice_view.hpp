#pragma once

#include <functional>
#include <vector>

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// A body's fields on nodes: what surface and integral measurements read.
template <class T, int D>
struct LatticeView {
  const Body<T, D>& body;
  const Population<T, D>& population;
  const FieldStore<T, D>& fields;
};

/// Gives the bodies on fresh nodes at the present time, remeshed only when they are asked for.
template <class T, int D>
using NodeSource = std::function<std::vector<LatticeView<T, D>>()>;

}  // namespace pliant::remeshed
