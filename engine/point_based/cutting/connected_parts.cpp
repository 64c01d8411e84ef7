#include "engine/point_based/cutting/connected_parts.hpp"

#include <numeric>

namespace pliant::point_based {
namespace {

/// Union-find; the root of a set is its lowest member.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::int32_t root(std::int32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::int32_t i, std::int32_t j) {
    const std::int32_t a = root(i), b = root(j);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
  }

 private:
  std::vector<std::int32_t> parent_;
};

}  // namespace

ConnectedParts connected_parts(std::span<const std::int64_t> first,
                               std::span<const std::int32_t> neighbour,
                               std::span<const double> factors, std::span<const double> volumes) {
  const auto count = static_cast<std::int32_t>(volumes.size());
  Sets sets(volumes.size());
  for (std::int32_t i = 0; i < count; ++i) {
    for (std::int64_t b = first[i]; b < first[i + 1]; ++b) {
      if (factors[b] > 0) sets.join(i, neighbour[b]);
    }
  }
  ConnectedParts parts;
  parts.part_of.resize(volumes.size());
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t root = sets.root(i);
    if (root == i) {
      parts.part_of[i] = static_cast<std::int32_t>(parts.volumes.size());
      parts.volumes.push_back(0);
    } else {
      parts.part_of[i] = parts.part_of[root];
    }
    parts.volumes[parts.part_of[i]] += volumes[i];
  }
  return parts;
}

}  // namespace pliant::point_based
