#include "engine/undeformed/contact/surface_patches.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace pliant::undeformed {

namespace {

constexpr double patch_size = 4;  // [size of facets]

/// Numbers the cubes with side `size` that contain points; with 0 there is only one cube.
template <int D>
std::vector<std::int32_t> cubes_of(const std::vector<Point<D>>& points, double size) {
  std::map<std::array<std::int64_t, D>, std::int32_t> number;
  std::vector<std::array<std::int64_t, D>> cube(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int a = 0; a < D && size > 0; ++a) {
      cube[i][a] = static_cast<std::int64_t>(std::floor(points[i][a] / size));
    }
    number.insert({cube[i], 0});
  }
  std::int32_t next = 0;
  for (auto& [place, its_number] : number) its_number = next++;
  std::vector<std::int32_t> cubes(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) cubes[i] = number.at(cube[i]);
  return cubes;
}

}  // namespace

Groups::Groups(std::span<const std::int32_t> group, std::size_t count) {
  first.assign(count + 1, 0);
  for (const std::int32_t g : group) ++first[g + 1];
  for (std::size_t g = 0; g < count; ++g) first[g + 1] += first[g];
  item.resize(group.size());
  std::vector<std::int32_t> next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < group.size(); ++i) {
    item[next[group[i]]++] = static_cast<std::int32_t>(i);
  }
}

template <int D>
Groups facets_around_corners(const ContactSurface<D>& surface) {
  std::vector<std::int32_t> corner;
  for (const auto& facet : surface.facet) corner.insert(corner.end(), facet.begin(), facet.end());
  Groups around(corner, surface.start.size());
  for (std::int32_t& facet : around.item) facet /= D;
  return around;
}

template Groups facets_around_corners(const ContactSurface<2>&);
template Groups facets_around_corners(const ContactSurface<3>&);

template <int D>
SurfacePatches<D>::SurfacePatches(const ContactSurface<D>& surface, std::size_t carriers,
                                  double size) {
  const std::vector<std::int32_t> of_corner = cubes_of<D>(surface.start, patch_size * size);
  const std::size_t count =
      of_corner.empty() ? 0 : *std::max_element(of_corner.begin(), of_corner.end()) + 1;
  std::vector<std::int32_t> of_facet, of_carrier(carriers, -1);
  for (const auto& facet : surface.facet) of_facet.push_back(of_corner[facet[0]]);
  for (std::int32_t c = 0; c < surface.corners(); ++c) {
    for (const Share& share : surface.shares(c)) {
      if (of_carrier[share.slot] < 0) of_carrier[share.slot] = of_corner[c];
    }
  }
  corners_ = Groups(of_corner, count);
  facets_ = Groups(of_facet, count);
  carriers_ = Groups(of_carrier, count);
  leverage_.assign(count, 0);
  std::vector<std::vector<std::int32_t>> sources(count);
  const auto add = [&](std::size_t patch, std::int32_t corner) {
    double sum = 0;
    for (const Share& share : surface.shares(corner)) {
      sum += std::abs(share.weight);
      sources[patch].push_back(of_carrier[share.slot]);
    }
    leverage_[patch] = std::max(leverage_[patch], sum);
  };
  for (std::size_t p = 0; p < count; ++p) {
    for (const std::int32_t c : corners_[p]) add(p, c);
    for (const std::int32_t f : facets_[p]) {
      for (const std::int32_t c : surface.facet[f]) add(p, c);
    }
    std::sort(sources[p].begin(), sources[p].end());
    sources[p].erase(std::unique(sources[p].begin(), sources[p].end()), sources[p].end());
    sources_.item.insert(sources_.item.end(), sources[p].begin(), sources[p].end());
    sources_.first.push_back(static_cast<std::int32_t>(sources_.item.size()));
  }
  carried_by_.resize(count);
  motion_.resize(count);
}

template <int D>
void SurfacePatches<D>::measure(const std::vector<Point<D>>& displacement,
                                const std::vector<Point<D>>& marked) {
  drift_ = {};
  double moving = 0;
  for (std::size_t p = 0; p < count(); ++p) {
    const auto carriers = carriers_[p];
    if (carriers.empty()) continue;
    Point<D> mean = {};
    for (const std::int32_t i : carriers) {
      for (int a = 0; a < D; ++a) mean[a] += displacement[i][a] - marked[i][a];
    }
    for (double& component : mean) component /= static_cast<double>(carriers.size());
    double largest = 0;
    for (const std::int32_t i : carriers) {
      double square = 0;
      for (int a = 0; a < D; ++a) {
        const double off = displacement[i][a] - marked[i][a] - mean[a];
        square += off * off;
      }
      largest = std::max(largest, square);
    }
    carried_by_[p] = {mean, std::sqrt(largest)};
    for (int a = 0; a < D; ++a) drift_[a] += mean[a];
    ++moving;
  }
  for (double& component : drift_) component /= std::max(moving, 1.);
  for (std::size_t p = 0; p < count(); ++p) {
    const auto sources = sources_[p];
    MotionBall<D> ball;
    for (const std::int32_t s : sources) {
      for (int a = 0; a < D; ++a) {
        ball.centre[a] += carried_by_[s].centre[a] / static_cast<double>(sources.size());
      }
    }
    for (const std::int32_t s : sources) {
      ball.radius = std::max(ball.radius, relative_motion<D>(carried_by_[s], {ball.centre, 0}));
    }
    ball.radius *= leverage_[p];
    motion_[p] = ball;
  }
}

template <int D>
double SurfacePatches<D>::largest_motion(const Point<D>& frame) const {
  double most = 0;
  for (const MotionBall<D>& ball : motion_) {
    most = std::max(most, relative_motion<D>(ball, {frame, 0}));
  }
  return most;
}

template class SurfacePatches<2>;
template class SurfacePatches<3>;

}  // namespace pliant::undeformed
