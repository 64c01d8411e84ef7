#pragma once

#include "engine/case/case.hpp"

namespace pliant {

/// The material constants for kernels: (RP.7), and for the reduced polynomial the small-strain
/// moduli K = 2/D and mu = 2 C_10. Moduli that relax are those of a sudden change: K0 of (RP.10),
/// and all coefficients of (TL.24).
kernels::Material<double> elastic_constants(const MaterialCase& given);

/// The terms of a Prony series.
std::vector<kernels::PronyTerm<double>> prony_terms(const PronyCase& given);

}  // namespace pliant
