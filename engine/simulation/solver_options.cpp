#include "engine/simulation/solver_options.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <thread>

namespace pliant {

namespace {

kernels::Isa isa_of(const std::string& name) {
  if (name.empty()) return kernels::widest_supported();
  for (const auto isa : {kernels::Isa::sse2, kernels::Isa::avx2, kernels::Isa::avx512}) {
    if (kernels::name(isa) != name) continue;
    if (kernels::is_supported(isa)) return isa;
    throw InputError(fmt::format("--isa {}: this processor does not run it; use {} or less", name,
                                 kernels::name(kernels::widest_supported())));
  }
  throw InputError(fmt::format("--isa {}: unknown; use sse2, avx2 or avx512", name));
}

int thread_count(int requested) {
  constexpr int most = 1024;
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (requested == 0) return processors;
  if (requested > 0 && requested <= most) return requested;
  throw InputError(
      fmt::format("--threads {}: give a number from 1 to {}, or leave it out for one thread per "
                  "processor, {} here",
                  requested, most, processors));
}

}  // namespace

SolverOptions solver_options(int threads, const std::string& isa) {
  return {thread_count(threads), isa_of(isa)};
}

}  // namespace pliant
