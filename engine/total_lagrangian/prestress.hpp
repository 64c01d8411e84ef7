#pragma once

#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// Gives the stress points of a body the initial stress of its case, (TL.14), if it has one.
template <class T, int D>
void prestress(const BodyCase& source, Body<T, D>& body);

extern template void prestress(const BodyCase&, Body<double, 2>&);
extern template void prestress(const BodyCase&, Body<double, 3>&);
extern template void prestress(const BodyCase&, Body<float, 2>&);
extern template void prestress(const BodyCase&, Body<float, 3>&);

}  // namespace pliant::total_lagrangian
