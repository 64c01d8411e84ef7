#include "engine/report/nearest_values.hpp"

#include <algorithm>
#include <array>
#include <nanoflann.hpp>

namespace pliant::report {
namespace {

constexpr std::size_t neighbours = 6;

/// Particles in the form that nanoflann expects.
struct Cloud {
  const std::vector<float>& position;

  std::size_t kdtree_get_point_count() const { return position.size() / 3; }
  float kdtree_get_pt(std::size_t p, std::size_t axis) const { return position[3 * p + axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud,
                                                 3, std::uint32_t>;

}  // namespace

void take_nearest_values(const FramePoints& particles, const std::vector<std::size_t>& scalars,
                         FramePoints& points) {
  for (const auto s : scalars) points.values[s].assign(points.count(), 0);
  if (scalars.empty() || particles.count() == 0) return;
  const Cloud cloud{particles.position};
  const Tree tree(3, cloud);
  std::array<std::uint32_t, neighbours> index = {};
  std::array<float, neighbours> square = {};
  for (std::size_t i = 0; i < points.count(); ++i) {
    const auto found =
        tree.knnSearch(points.position.data() + 3 * i, neighbours, index.data(), square.data());
    const float least = std::max(1e-3F * square[found - 1], 1e-30F);
    for (const auto s : scalars) {
      float sum = 0, weight = 0;
      for (std::size_t n = 0; n < found; ++n) {
        const float w = 1 / (square[n] + least);
        sum += w * particles.values[s][index[n]];
        weight += w;
      }
      points.values[s][i] = sum / weight;
    }
  }
}

}  // namespace pliant::report
