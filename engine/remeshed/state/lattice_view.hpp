#pragma once

#include <functional>
#include <vector>

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// A body's fields on nodes, for measurements of surfaces and integrals.
template <class T, int D>
struct LatticeView {
  const Body<T, D>& body;
  const Population<T, D>& population;
  const FieldStore<T, D>& fields;
};

/// Returns the bodies on nodes at the present time; remeshes them only when called.
template <class T, int D>
using NodeSource = std::function<std::vector<LatticeView<T, D>>()>;

}  // namespace pliant::remeshed
