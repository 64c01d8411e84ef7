#pragma once

#include <cstdint>

namespace pliant::kernels {

/// Gradient of a field: by the moment matrix (RP.20), or that of H&K (RP.19), which is only
/// compiled for the kernel of the paper, Kernel::quartic_spline.
enum class Gradient : std::uint8_t { moment_matrix, normalised };

}  // namespace pliant::kernels
