#pragma once

#include <string_view>

namespace pliant::kernels {

/// Instruction sets the kernels are compiled for; one binary holds all of them.
enum class Isa { sse2, avx2, avx512 };

/// The widest instruction set this processor runs.
Isa widest_supported();

/// True when this processor runs `isa`.
bool is_supported(Isa isa);

std::string_view name(Isa isa);

}  // namespace pliant::kernels
