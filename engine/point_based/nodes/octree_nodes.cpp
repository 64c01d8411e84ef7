#include "engine/point_based/nodes/octree_nodes.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "engine/geometry/signed_distance.hpp"

namespace pliant::point_based {
namespace {

template <int D>
using Corner = std::array<std::int64_t, D>;  // lower corner of a cell, in units of the finest size

/// The part of a cell inside the body.
template <int D>
struct Part {
  double volume = 0;
  std::array<double, D> centroid = {};

  void add(double v, const std::array<double, D>& x) {
    volume += v;
    for (int a = 0; a < D; ++a) centroid[a] += v / volume * (x[a] - centroid[a]);
  }
};

constexpr int samples = 4;  ///< along each side of a cell that the surface crosses
constexpr double least_part = 0.3;

/// Calls f(index) for all D-tuples of 0 .. n - 1.
template <int D, class F>
void for_each_index(int n, F&& f) {
  std::array<int, D> index = {};
  while (true) {
    f(index);
    int a = 0;
    while (a < D && ++index[a] == n) index[a++] = 0;
    if (a == D) return;
  }
}

template <int D>
class Octree {
 public:
  Octree(const Shape& body, const OctreeSizes& sizes)
      : body_(body), sizes_(sizes), bounds_(bounding_box(body)) {
    while (sizes.finest * static_cast<double>(std::int64_t{2} << levels_) <=
           sizes.coarsest * (1 + 1e-12)) {
      ++levels_;
    }
  }

  NodeCloud<D> operator()() {
    const std::int64_t root = std::int64_t{1} << levels_;
    Corner<D> count = {}, corner = {};
    for (int a = 0; a < D; ++a) {
      const double cells = (bounds_.upper[a] - bounds_.lower[a]) / (size(levels_));
      assert(std::isfinite(cells));
      count[a] = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(cells - 1e-9)));
    }
    while (true) {
      Corner<D> scaled = corner;
      for (std::int64_t& c : scaled) c *= root;
      divide(scaled, levels_);
      int a = 0;
      while (a < D && ++corner[a] == count[a]) corner[a++] = 0;
      if (a == D) break;
    }
    join_fragments();
    return std::move(cloud_);
  }

 private:
  double size(int level) const {
    return sizes_.finest * static_cast<double>(std::int64_t{1} << level);
  }

  std::array<double, D> place(const Corner<D>& corner, double offset) const {
    std::array<double, D> x;
    for (int a = 0; a < D; ++a) {
      x[a] = bounds_.lower[a] + sizes_.finest * static_cast<double>(corner[a]) + offset;
    }
    return x;
  }

  double distance(const std::array<double, D>& x) const {
    Vector point = {};
    std::copy_n(x.begin(), D, point.begin());
    return signed_distance(body_, point, D);
  }

  void divide(const Corner<D>& corner, int level) {
    const double side = size(level), reach = side * std::sqrt(D) / 2;
    const std::array<double, D> middle = place(corner, side / 2);
    const double d = distance(middle);
    if (d > reach) return;
    const bool is_inside = d < -reach;
    const double allowed = is_inside ? sizes_.finest + sizes_.growth * -d : sizes_.finest;
    if (level > 0 && side > allowed * (1 + 1e-12)) {
      const std::int64_t half = std::int64_t{1} << (level - 1);
      for_each_index<D>(2, [&](const std::array<int, D>& index) {
        Corner<D> child = corner;
        for (int a = 0; a < D; ++a) child[a] += half * index[a];
        divide(child, level - 1);
      });
    } else if (is_inside) {
      add_node(corner, level, {std::pow(side, D), middle});
    } else {
      add_part(corner, level);
    }
  }

  void add_part(const Corner<D>& corner, int level) {
    const double side = size(level) / samples;
    Part<D> part;
    for_each_index<D>(samples, [&](const std::array<int, D>& index) {
      std::array<double, D> x = place(corner, side / 2);
      for (int a = 0; a < D; ++a) x[a] += side * index[a];
      const double fraction = std::clamp(0.5 - distance(x) / side, 0., 1.);
      if (fraction > 0) part.add(fraction * std::pow(side, D), x);
    });
    if (part.volume >= least_part * std::pow(size(level), D)) {
      add_node(corner, level, part);
    } else if (part.volume > 0) {
      fragments_.emplace_back(corner, part);
    }
  }

  void add_node(const Corner<D>& corner, int level, const Part<D>& part) {
    if (level == 0) node_of_[corner] = cloud_.positions.size();
    cloud_.positions.push_back(part.centroid);
    cloud_.volumes.push_back(part.volume);
  }

  /// The largest of the finest leaves around a fragment takes it. A fragment without such a leaf
  /// becomes a node.
  void join_fragments() {
    for (const auto& fragment : fragments_) {
      const Corner<D>& corner = fragment.first;
      const Part<D>& part = fragment.second;
      std::size_t best = cloud_.volumes.size();
      for_each_index<D>(3, [&](const std::array<int, D>& index) {
        Corner<D> beside = corner;
        for (int a = 0; a < D; ++a) beside[a] += index[a] - 1;
        const auto found = node_of_.find(beside);
        if (found == node_of_.end()) return;
        const bool is_first = best == cloud_.volumes.size();
        if (is_first || cloud_.volumes[found->second] > cloud_.volumes[best]) best = found->second;
      });
      if (best == cloud_.volumes.size()) {
        add_node(corner, 0, part);
        continue;
      }
      Part<D> joined{cloud_.volumes[best], cloud_.positions[best]};
      joined.add(part.volume, part.centroid);
      cloud_.volumes[best] = joined.volume;
      cloud_.positions[best] = joined.centroid;
    }
  }

  const Shape& body_;
  OctreeSizes sizes_;
  pliant::Box<3> bounds_;
  int levels_ = 0;  ///< number of levels up to the roots; 0 is the finest
  NodeCloud<D> cloud_;
  std::map<Corner<D>, std::size_t> node_of_;  ///< nodes of the finest leaves
  std::vector<std::pair<Corner<D>, Part<D>>> fragments_;
};

}  // namespace

template <int D>
NodeCloud<D> octree_nodes(const Shape& body, const OctreeSizes& sizes) {
  return Octree<D>(body, sizes)();
}

template NodeCloud<2> octree_nodes<2>(const Shape&, const OctreeSizes&);
template NodeCloud<3> octree_nodes<3>(const Shape&, const OctreeSizes&);

}  // namespace pliant::point_based
