#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/lattice/lattice.hpp"

namespace pliant::point_based {

/// Finds nodes by distance, with a k-d tree (nanoflann).
template <int D>
class NearestNodes {
 public:
  struct Found {
    double distance;  ///< [m]
    std::int32_t node;
    auto operator<=>(const Found&) const = default;
  };

  /// Keeps a reference to the positions [m].
  explicit NearestNodes(const std::vector<Point<D>>& positions);
  ~NearestNodes();

  /// The node nearest to `x`; there must be one.
  std::int32_t nearest(const Point<D>& x) const;

  /// The `count` nodes nearest to `x`, or all if there are fewer, sorted by distance and then by
  /// number.
  std::vector<Found> nearest(const Point<D>& x, std::size_t count) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

extern template class NearestNodes<2>;
extern template class NearestNodes<3>;

}  // namespace pliant::point_based
