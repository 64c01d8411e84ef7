#pragma once

#include "engine/case/case.hpp"

namespace pliant {

/// What the kernels read of a material: (RP.7), and for the reduced polynomial the small-strain
/// moduli K = 2/D, or K0 of (RP.10) where it relaxes, and mu = 2 C_10.
kernels::Material<double> elastic_constants(const MaterialCase& given);

/// The terms of its Prony series.
std::vector<kernels::PronyTerm<double>> prony_terms(const MaterialCase& given);

}  // namespace pliant
