#pragma once

#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// Sets the initial stress of the case, if it has one, at the stress points of a body, (TL.14).
template <class T, int D>
void prestress(const BodyCase& source, Body<T, D>& body);

extern template void prestress(const BodyCase&, Body<double, 2>&);
extern template void prestress(const BodyCase&, Body<double, 3>&);
extern template void prestress(const BodyCase&, Body<float, 2>&);
extern template void prestress(const BodyCase&, Body<float, 3>&);

}  // namespace pliant::total_lagrangian
