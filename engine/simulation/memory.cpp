#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "engine/simulation/estimate.hpp"

// Limits of memory from files of Linux; a missing file sets no limit.
namespace pliant {

namespace {

constexpr std::size_t any_memory = std::numeric_limits<std::size_t>::max();

std::size_t remaining(std::size_t limit, std::size_t used) { return limit - std::min(limit, used); }

/// The number that follows a key in a file [B], as in "MemAvailable:   12345 kB".
std::size_t value_in(const char* file, const std::string& key, std::size_t unit) {
  std::ifstream stream(file);
  for (std::string word; stream >> word;) {
    std::size_t number = 0;
    if (word == key && stream >> number) return number * unit;
  }
  return any_memory;
}

/// The number in a file; "max" sets no limit.
std::size_t number_in(const char* file) {
  std::ifstream stream(file);
  std::size_t number = 0;
  return stream >> number ? number : any_memory;
}

// Clean pages of files count as free, since Linux drops them when memory is needed.
std::size_t left_by_control_group() {
  const std::size_t limit = number_in("/sys/fs/cgroup/memory.max");
  const std::size_t used = number_in("/sys/fs/cgroup/memory.current");
  if (limit == any_memory || used == any_memory) return any_memory;
  const std::size_t files = value_in("/sys/fs/cgroup/memory.stat", "inactive_file", 1);
  return remaining(limit, files == any_memory ? used : remaining(used, files));
}

std::size_t left_of_address_space() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return any_memory;
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return remaining(limit.rlim_cur, pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
}

}  // namespace

std::size_t available_memory() {
  return std::min({value_in("/proc/meminfo", "MemAvailable:", 1024), left_by_control_group(),
                   left_of_address_space()});
}

}  // namespace pliant
