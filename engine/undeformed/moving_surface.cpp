#include "engine/undeformed/moving_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant::undeformed {

namespace {

constexpr double least_opposition = -0.5;  // of the normals of surfaces that meet

/// That of most of the surface: facets in cells that it hardly cuts are tiny.
template <int D>
double size_of_facets(const ContactSurface<D>& surface) {
  double area = 0, squares = 0;
  for (const auto& facet : surface.facet) {
    std::array<Point<D>, D> x;
    for (int v = 0; v < D; ++v) x[v] = surface.start[facet[v]];
    const Point<D> n = area_vector<D>(x);
    area += std::sqrt(dot<D>(n, n));
    squares += dot<D>(n, n);
  }
  const double mean = area > 0 ? squares / area : 0;
  return D == 2 ? mean : std::sqrt(2 * mean);
}

}  // namespace

template <class T, int D>
MovingSurface<T, D>::MovingSurface(Body<T, D>& body, Displacements<T, D> moved,
                                   ContactSurface<D> surface)
    : body_(&body),
      moved_(moved),
      surface_(std::move(surface)),
      held_(held_directions(body)),
      spacing_(size_of_facets(surface_)) {
  first_around_.assign(surface_.corners() + 1, 0);
  for (const auto& facet : surface_.facet) {
    for (const std::int32_t corner : facet) ++first_around_[corner + 1];
  }
  for (std::int32_t c = 0; c < surface_.corners(); ++c) first_around_[c + 1] += first_around_[c];
  around_.resize(first_around_.back());
  std::vector<std::int32_t> next(first_around_.begin(), first_around_.end() - 1);
  for (std::size_t f = 0; f < surface_.facet.size(); ++f) {
    for (const std::int32_t corner : surface_.facet[f]) {
      around_[next[corner]++] = static_cast<std::int32_t>(f);
    }
  }
  for (std::int32_t c = 0; c < surface_.corners(); ++c) {
    double sum = 0;
    for (const Share& share : surface_.shares(c)) {
      sum += std::abs(share.weight);
      carriers_.push_back(share.slot);
    }
    lever_ = std::max(lever_, sum);
  }
  std::sort(carriers_.begin(), carriers_.end());
  carriers_.erase(std::unique(carriers_.begin(), carriers_.end()), carriers_.end());
  marked_.resize(carriers_.size());
  place_.resize(surface_.corners());
  normal_.resize(surface_.facet.size());
  is_corner_watched_.resize(place_.size());
  is_ring_watched_.resize(place_.size());
  is_facet_watched_.resize(normal_.size());
}

template <class T, int D>
void MovingSurface<T, D>::watch_none() {
  for (const std::int32_t corner : watched_corners_) {
    is_corner_watched_[corner] = is_ring_watched_[corner] = false;
  }
  for (const std::int32_t facet : watched_facets_) is_facet_watched_[facet] = false;
  watched_corners_.clear();
  watched_facets_.clear();
}

template <class T, int D>
void MovingSurface<T, D>::watch(std::int32_t corner) {
  if (is_ring_watched_[corner]) return;
  is_ring_watched_[corner] = true;
  watch_corner(corner);
  for (std::int32_t i = first_around_[corner]; i < first_around_[corner + 1]; ++i) {
    const std::int32_t facet = around_[i];
    if (is_facet_watched_[facet]) continue;
    is_facet_watched_[facet] = true;
    watched_facets_.push_back(facet);
    for (const std::int32_t other : surface_.facet[facet]) watch_corner(other);
  }
}

template <class T, int D>
void MovingSurface<T, D>::watch_corner(std::int32_t corner) {
  if (is_corner_watched_[corner]) return;
  is_corner_watched_[corner] = true;
  watched_corners_.push_back(corner);
}

template <class T, int D>
void MovingSurface<T, D>::find_places(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) find_place(watched_corners_[i]);
}

template <class T, int D>
void MovingSurface<T, D>::find_normals(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) find_normal(watched_facets_[i]);
}

template <class T, int D>
void MovingSurface<T, D>::find_place(std::int32_t corner) {
  Point<D> x = carried<T, D>(displacement(), surface_.shares(corner));
  for (int a = 0; a < D; ++a) x[a] += surface_.start[corner][a];
  place_[corner] = x;
}

template <class T, int D>
void MovingSurface<T, D>::find_normal(std::int32_t facet) {
  normal_[facet] = area_vector<D>(places(facet));
  normalise<D>(normal_[facet]);
}

template <class T, int D>
std::array<Point<D>, D> MovingSurface<T, D>::places(std::int32_t facet) const {
  std::array<Point<D>, D> x;
  for (int v = 0; v < D; ++v) x[v] = place_[surface_.facet[facet][v]];
  return x;
}

template <class T, int D>
double MovingSurface<T, D>::height(std::int32_t facet, const Point<D>& x) const {
  return dot<D>(difference<D>(x, place_[surface_.facet[facet][0]]), normal_[facet]);
}

template <class T, int D>
Point<D> MovingSurface<T, D>::normal(std::int32_t corner) const {
  Point<D> sum = {};
  for (std::int32_t i = first_around_[corner]; i < first_around_[corner + 1]; ++i) {
    const Point<D> n = area_vector<D>(places(around_[i]));
    for (int a = 0; a < D; ++a) sum[a] += n[a];
  }
  normalise<D>(sum);
  return sum;
}

template <class T, int D>
bool MovingSurface<T, D>::opposes(std::int32_t corner, const Point<D>& normal) const {
  const auto begin = around_.begin() + first_around_[corner];
  const auto end = around_.begin() + first_around_[corner + 1];
  return begin == end || std::any_of(begin, end, [&](std::int32_t facet) {
           return dot<D>(normal_[facet], normal) <= least_opposition;
         });
}

template <class T, int D>
void MovingSurface<T, D>::mark() {
  for (std::size_t i = 0; i < carriers_.size(); ++i) {
    for (int a = 0; a < D; ++a) marked_[i][a] = displacement()[a][carriers_[i]];
  }
  for (std::int32_t c = 0; c < surface_.corners(); ++c) find_place(c);
  for (std::size_t f = 0; f < normal_.size(); ++f) find_normal(static_cast<std::int32_t>(f));
}

template <class T, int D>
auto MovingSurface<T, D>::motion(const Point<D>& frame) const -> Motion {
  double most = 0;
  Point<D> sum = {};
  for (std::size_t i = 0; i < carriers_.size(); ++i) {
    double square = 0;
    for (int a = 0; a < D; ++a) {
      const double d = displacement()[a][carriers_[i]] - marked_[i][a];
      sum[a] += d;
      square += (d - frame[a]) * (d - frame[a]);
    }
    most = std::max(most, square);
  }
  for (double& component : sum) component /= static_cast<double>(carriers_.size());
  return {lever_ * std::sqrt(most), sum};
}

template class MovingSurface<double, 2>;
template class MovingSurface<double, 3>;
template class MovingSurface<float, 2>;
template class MovingSurface<float, 3>;

}  // namespace pliant::undeformed
