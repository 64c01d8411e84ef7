#include "engine/point_based/bonds/nearest_nodes.hpp"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>

namespace pliant::point_based {

/// The set of points in the form that nanoflann expects, and its tree.
template <int D>
struct NearestNodes<D>::Tree {
  struct Points {
    const std::vector<Point<D>>& positions;
    std::size_t kdtree_get_point_count() const { return positions.size(); }
    double kdtree_get_pt(std::size_t node, std::size_t axis) const { return positions[node][axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                    Points, D, std::int32_t>;

  explicit Tree(const std::vector<Point<D>>& positions) : points{positions}, index(D, points) {
    index.buildIndex();
  }

  Points points;
  Index index;
};

template <int D>
NearestNodes<D>::NearestNodes(const std::vector<Point<D>>& positions)
    : tree_(std::make_unique<Tree>(positions)) {}

template <int D>
NearestNodes<D>::~NearestNodes() = default;

template <int D>
std::int32_t NearestNodes<D>::nearest(const Point<D>& x) const {
  return nearest(x, 1).front().node;
}

template <int D>
auto NearestNodes<D>::nearest(const Point<D>& x, std::size_t count) const -> std::vector<Found> {
  std::vector<std::int32_t> node(count);
  std::vector<double> square(count);
  const std::size_t found = tree_->index.knnSearch(x.data(), count, node.data(), square.data());
  std::vector<Found> list(found);
  for (std::size_t i = 0; i < found; ++i) list[i] = {std::sqrt(square[i]), node[i]};
  std::sort(list.begin(), list.end());
  return list;
}

template class NearestNodes<2>;
template class NearestNodes<3>;

}  // namespace pliant::point_based
