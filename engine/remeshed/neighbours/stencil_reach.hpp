#pragma once

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Smallest distance, over h, of an interior particle of a block from a particle or ghost whose
/// slot is just outside its stencil of `reach` slots on each side; infinite if there is none.
template <class T, int D>
double closest_outside(const Body<T, D>& body, int block, int reach);

extern template double closest_outside<double, 2>(const Body<double, 2>&, int, int);
extern template double closest_outside<double, 3>(const Body<double, 3>&, int, int);
extern template double closest_outside<float, 2>(const Body<float, 2>&, int, int);
extern template double closest_outside<float, 3>(const Body<float, 3>&, int, int);

}  // namespace pliant::remeshed
