#include "engine/point_based/nodes/octree_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/nodes/lattice_nodes.hpp"

namespace pliant::point_based {
namespace {

/// The corners of the leaves of an octree whose finest cells are those of a lattice.
template <int D>
class LeafCorners {
 public:
  LeafCorners(const BodyLattice<D>& lattice, const Shape& body, const OctreeSizes& sizes,
              const std::vector<Point<D>>& cuts)
      : lattice_(lattice), body_(body), growth_(sizes.growth), kept_(lattice.points()) {
    if (!cuts.empty()) cuts_.emplace(cuts);
    for (const double side : lattice.pitch()) {
      finest_ = std::max(finest_, side);
      diagonal_ += side * side;
    }
    diagonal_ = std::sqrt(diagonal_);
    while (sizes.finest * static_cast<double>(std::int64_t{2} << levels_) <=
           sizes.coarsest * (1 + 1e-12)) {
      ++levels_;
    }
  }

  std::vector<bool> operator()() {
    // The lattice has one layer of points more than the body on each side.
    Cell<D> last_root = lattice_.last(2);
    for (std::int32_t& cells : last_root) cells = (cells - 1) >> levels_;
    for_each_cell<D>({}, last_root, [&](const Cell<D>& root) {
      Cell<D> corner = root;
      for (std::int32_t& cells : corner) cells = 1 + (cells << levels_);
      divide(corner, levels_);
    });
    return std::move(kept_);
  }

 private:
  void divide(const Cell<D>& corner, int level) {
    const std::int32_t cells = 1 << level;
    if (level == 0) return keep(corner, cells);
    const double side = finest_ * cells, reach = diagonal_ * cells / 2;
    Cell<D> middle = corner;
    for (int a = 0; a < D; ++a) middle[a] += cells / 2;
    const double d = signed_distance(body_, padded<D>(lattice_.place(middle)), D);
    if (d > reach) return;
    const double depth = std::min(-d, distance_to_cuts(lattice_.place(middle)));
    if (depth > reach && side <= (finest_ + growth_ * depth) * (1 + 1e-12)) {
      return keep(corner, cells);
    }
    Cell<D> last;
    last.fill(1);
    for_each_cell<D>({}, last, [&](const Cell<D>& half) {
      Cell<D> child = corner;
      for (int a = 0; a < D; ++a) child[a] += half[a] * cells / 2;
      divide(child, level - 1);
    });
  }

  /// A lower bound, by places of the cuts.
  double distance_to_cuts(const Point<D>& x) const {
    if (!cuts_) return std::numeric_limits<double>::infinity();
    return cuts_->nearest(x, 1).front().distance - finest_ / 2;
  }

  void keep(const Cell<D>& corner, std::int32_t cells) {
    const Cell<D> end = lattice_.last(0);
    for (int c = 0; c < BodyLattice<D>::corners; ++c) {
      Cell<D> point = corner;
      bool exists = true;
      for (int a = 0; a < D; ++a) {
        point[a] += (c >> a & 1) * cells;
        exists = exists && point[a] <= end[a];
      }
      if (exists) kept_[lattice_.index(point)] = true;
    }
  }

  const BodyLattice<D>& lattice_;
  const Shape& body_;
  double growth_;
  double finest_ = 0, diagonal_ = 0;  ///< longest side and diagonal of the finest cells [m]
  int levels_ = 0;                    ///< of the roots; 0 is the finest
  std::optional<NearestNodes<D>> cuts_;
  std::vector<bool> kept_;  ///< [lattice point]
};

}  // namespace

template <int D>
NodeCloud<D> octree_nodes(const Shape& body, const OctreeSizes& sizes,
                          const std::vector<Point<D>>& cuts) {
  return lattice_nodes<D>(body, sizes.finest, [&](const BodyLattice<D>& lattice) {
    return LeafCorners<D>(lattice, body, sizes, cuts)();
  });
}

template NodeCloud<2> octree_nodes<2>(const Shape&, const OctreeSizes&,
                                      const std::vector<Point<2>>&);
template NodeCloud<3> octree_nodes<3>(const Shape&, const OctreeSizes&,
                                      const std::vector<Point<3>>&);

}  // namespace pliant::point_based
