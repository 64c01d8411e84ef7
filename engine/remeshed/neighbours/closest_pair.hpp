#pragma once

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Smallest distance between two particles of a body, over h; at most 2. It falls towards 0 when
/// particles clump.
template <class T, int D>
double closest_pair(const Body<T, D>& body);

extern template double closest_pair<double, 2>(const Body<double, 2>&);
extern template double closest_pair<double, 3>(const Body<double, 3>&);
extern template double closest_pair<float, 2>(const Body<float, 2>&);
extern template double closest_pair<float, 3>(const Body<float, 3>&);

}  // namespace pliant::remeshed
