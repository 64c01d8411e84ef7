#include "engine/bench/machine.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include <pliant/version.hpp>
#include "kernels/isa.hpp"

namespace pliant::bench {

namespace {

// The value of the first line in /proc/cpuinfo with this key.
std::string processor_entry(const std::string& key) {
  std::ifstream entries("/proc/cpuinfo");
  for (std::string line; std::getline(entries, line);) {
    const std::size_t colon = line.find(':');
    if (line.starts_with(key) && colon != std::string::npos && colon + 2 <= line.size()) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

std::string kibibytes(int name) { return fmt::format("{} KiB", sysconf(name) / 1024); }

}  // namespace

std::vector<std::string> machine_description() {
  std::string isa;
  for (const auto set : {kernels::Isa::sse2, kernels::Isa::avx2, kernels::Isa::avx512}) {
    if (kernels::is_supported(set)) isa += fmt::format(" {}", kernels::name(set));
  }
  return {fmt::format("processor: {}, {} in use", processor_entry("model name"),
                      std::thread::hardware_concurrency()),
          "instruction sets:" + isa,
          fmt::format("caches: first level {}, second level {}, third level {}",
                      kibibytes(_SC_LEVEL1_DCACHE_SIZE), kibibytes(_SC_LEVEL2_CACHE_SIZE),
                      kibibytes(_SC_LEVEL3_CACHE_SIZE)),
          fmt::format("compiler: GCC {}", __VERSION__), fmt::format("pliant {}", version)};
}

}  // namespace pliant::bench
