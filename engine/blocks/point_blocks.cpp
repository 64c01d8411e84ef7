#include "engine/blocks/point_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/blocks/box_tree.hpp"
#include "engine/blocks/hilbert_curve.hpp"

// Whether two blocks have points within the radius of each other is decided from coarse to fine: by
// the boxes of blocks, by the boxes of leaves (short runs of a block), and finally by points. In
// two blocks that share a face, most pairs of leaves there have such points, so the first pairs
// decide. Boxes exclude most others.
namespace pliant {

namespace {

constexpr std::int64_t leaf_size = 16;  // points

template <int D>
using Position = std::array<double, D>;

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("blocks of points: " + what);
}

template <class T, int D>
std::vector<Position<D>> checked(const std::array<std::span<const T>, D>& positions, double radius,
                                 int block_size) {
  if (!(radius >= 0) || !std::isfinite(radius)) refuse(fmt::format("the radius is {}", radius));
  if (block_size < 1) refuse(fmt::format("the block size is {}", block_size));
  const std::size_t count = positions[0].size();
  std::vector<Position<D>> points(count);
  for (int a = 0; a < D; ++a) {
    if (positions[a].size() != count)
      refuse(fmt::format("{} points have {} coordinates along axis {}", count, positions[a].size(),
                         a));
    for (std::size_t p = 0; p < count; ++p) {
      if (!std::isfinite(positions[a][p]))
        refuse(fmt::format("coordinate {} of point {} is {}", a, p, positions[a][p]));
      points[p][a] = static_cast<double>(positions[a][p]);
    }
  }
  return points;
}

/// [slot] numbers of the points along the curve.
template <int D>
std::vector<std::int64_t> order_along_curve(const std::vector<Position<D>>& points) {
  Box<D> box;
  for (const Position<D>& x : points) box.grow(x);
  double extent = 0;
  if (!points.empty()) {
    for (int a = 0; a < D; ++a) extent = std::max(extent, box.upper[a] - box.lower[a]);
  }
  if (!std::isfinite(extent)) refuse("the coordinates are too far apart for floating point");
  constexpr double most = (std::uint64_t{1} << hilbert_bits<D>)-1;
  std::vector<std::pair<std::uint64_t, std::int64_t>> keys(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::array<std::uint32_t, D> grid;
    for (int a = 0; a < D; ++a) {
      const double share = extent > 0 ? (points[p][a] - box.lower[a]) / extent : 0;
      grid[a] = static_cast<std::uint32_t>(share * most);
    }
    keys[p] = {hilbert_key<D>(grid), static_cast<std::int64_t>(p)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::int64_t> order(points.size());
  for (std::size_t s = 0; s < order.size(); ++s) order[s] = keys[s].second;
  return order;
}

template <int D>
class Adjacency {
 public:
  Adjacency(std::vector<Position<D>> points, const std::vector<std::int64_t>& first_slot,
            double radius)
      : points_(std::move(points)),
        squared_radius_(radius * radius),
        count_(first_slot.size() - 1),
        tree_(boxes(first_slot)) {}

  scheduler::Blocks find() {
    scheduler::Blocks blocks;
    blocks.neighbours.resize(count_);
    for (std::size_t a = 0; a < count_; ++a) {
      tree_.for_each_near(tree_[a], squared_radius_, a + 1, [&](std::size_t b) {
        if (!are_near(a, b)) return;
        blocks.neighbours[a].push_back(static_cast<int>(b));
        blocks.neighbours[b].push_back(static_cast<int>(a));
      });
    }
    return blocks;
  }

 private:
  struct Leaf {
    Box<D> box;
    std::int64_t first, last;  ///< slots, the last one excluded
  };

  std::vector<Box<D>> boxes(const std::vector<std::int64_t>& first_slot) {
    std::vector<Box<D>> of_blocks(count_);
    for (std::size_t b = 0; b < count_; ++b) {
      first_leaf_.push_back(leaves_.size());
      for (std::int64_t s = first_slot[b]; s < first_slot[b + 1]; s += leaf_size) {
        Leaf leaf = {{}, s, std::min(s + leaf_size, first_slot[b + 1])};
        for (std::int64_t p = leaf.first; p < leaf.last; ++p) leaf.box.grow(points_[p]);
        of_blocks[b].grow(leaf.box);
        leaves_.push_back(leaf);
      }
    }
    first_leaf_.push_back(leaves_.size());
    return of_blocks;
  }

  void select(std::size_t block, const Box<D>& near, std::vector<std::size_t>& selected) const {
    selected.clear();
    for (std::size_t l = first_leaf_[block]; l < first_leaf_[block + 1]; ++l) {
      if (squared_gap(leaves_[l].box, near) <= squared_radius_) selected.push_back(l);
    }
  }

  bool are_near(std::size_t a, std::size_t b) {
    select(a, tree_[b], of_a_);
    select(b, tree_[a], of_b_);
    for (const std::size_t i : of_a_) {
      for (const std::size_t j : of_b_) {
        if (squared_gap(leaves_[i].box, leaves_[j].box) <= squared_radius_ &&
            have_near_points(leaves_[i], leaves_[j]))
          return true;
      }
    }
    return false;
  }

  bool have_near_points(const Leaf& a, const Leaf& b) const {
    for (std::int64_t p = a.first; p < a.last; ++p) {
      for (std::int64_t q = b.first; q < b.last; ++q) {
        double squared_distance = 0;
        for (int i = 0; i < D; ++i) {
          const double d = points_[p][i] - points_[q][i];
          squared_distance += d * d;
        }
        if (squared_distance <= squared_radius_) return true;
      }
    }
    return false;
  }

  std::vector<Position<D>> points_;  ///< [slot]
  double squared_radius_;
  std::size_t count_;
  std::vector<Leaf> leaves_;
  std::vector<std::size_t> first_leaf_;  ///< [block + 1]
  BoxTree<D> tree_;                      ///< of the blocks
  std::vector<std::size_t> of_a_, of_b_;
};

}  // namespace

template <class T, int D>
PointBlocks blocks_of_points(const std::array<std::span<const T>, D>& positions, double radius,
                             int block_size) {
  const std::vector<Position<D>> points = checked<T, D>(positions, radius, block_size);
  PointBlocks result;
  result.order = order_along_curve<D>(points);
  const auto count = static_cast<std::int64_t>(points.size());
  const std::int64_t blocks = (count + block_size - 1) / block_size;
  result.first_slot.push_back(0);
  for (std::int64_t b = 1; b <= blocks; ++b) result.first_slot.push_back(count * b / blocks);
  std::vector<Position<D>> in_order;
  in_order.reserve(points.size());
  for (const std::int64_t p : result.order) in_order.push_back(points[p]);
  result.blocks = Adjacency<D>(std::move(in_order), result.first_slot, radius).find();
  return result;
}

template PointBlocks blocks_of_points<float, 2>(const std::array<std::span<const float>, 2>&,
                                                double, int);
template PointBlocks blocks_of_points<double, 2>(const std::array<std::span<const double>, 2>&,
                                                 double, int);
template PointBlocks blocks_of_points<float, 3>(const std::array<std::span<const float>, 3>&,
                                                double, int);
template PointBlocks blocks_of_points<double, 3>(const std::array<std::span<const double>, 3>&,
                                                 double, int);

}  // namespace pliant
