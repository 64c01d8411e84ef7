#include "engine/remeshed/level_set/projections.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/engine/lattice/random_cells.hpp"

namespace pliant::test {
namespace {

/// The nodes around a circle (a ball in 3D) with their distance from it, in cells.
template <class T, int D>
class NodesOfACircle {
 public:
  static constexpr double radius = 5.3;

  explicit NodesOfACircle(std::int32_t far_away) {
    lattice_.spacing = 1;
    Cell<D> upper = diagonal<D>(15);
    lower_[0] = far_away;
    upper[0] += far_away;
    layout_.build(random_occupancy<D>(lower_, upper, 1, 1), {}, 1, 10);
    values_.resize(layout_.slots());
    for_each_cell<D>(lower_, upper, [&](const Cell<D>& cell) {
      values_[layout_.slot(cell)] = static_cast<T>(distance(cell));
    });
  }

  /// Largest distance of the closest points of nodes beside the circle from the exact ones.
  double error() {
    remeshed::Projections<T, D> nodes;
    nodes.clear(lower_);
    layout_.for_each_slot(layout_.blocks()[0], [&](std::int64_t slot, const Cell<D>& cell) {
      if (std::abs(distance(cell)) > 1) return;
      Point<D> start;
      std::copy(cell.begin(), cell.end(), start.begin());
      nodes.add(slot, cell, start);
    });
    nodes.run(lattice_, layout_, values_.data(), 3, 12,
              kernels::RemeshedTable<T, D>::of(kernels::widest_supported()));
    EXPECT_GT(nodes.size(), 20u);
    double worst = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_TRUE(nodes.has_converged(i));
      const Point<D> r = from_centre(nodes.node(i)), x = from_centre(nodes.point(i));
      double square = 0;
      for (int a = 0; a < D; ++a) square += std::pow(x[a] - r[a] * radius / norm(r), 2);
      worst = std::max(worst, std::sqrt(square));
    }
    return worst;
  }

 private:
  Point<D> from_centre(const Point<D>& x) const {
    Point<D> r;
    for (int a = 0; a < D; ++a) r[a] = x[a] - lower_[a] - 7.4;
    return r;
  }
  double norm(const Point<D>& r) const {
    double square = 0;
    for (const double component : r) square += component * component;
    return std::sqrt(square);
  }
  double distance(const Cell<D>& cell) const {
    Point<D> x;
    std::copy(cell.begin(), cell.end(), x.begin());
    return norm(from_centre(x)) - radius;
  }

  Lattice<D> lattice_;
  Layout<D> layout_;
  Cell<D> lower_ = {};
  std::vector<T> values_;
};

template <class Space>
struct Projecting : testing::Test {};
TYPED_TEST_SUITE(Projecting, Dimensions);

// Error of cubic interpolation of the distance: about (h/radius)^3 of a cell.
constexpr double of_cubics = 0.003;

TYPED_TEST(Projecting, leads_to_the_closest_point_of_a_circle) {
  constexpr int D = TypeParam::dimension;
  EXPECT_LT((NodesOfACircle<double, D>(0).error()), of_cubics);
  EXPECT_LT((NodesOfACircle<float, D>(0).error()), of_cubics);
}

// Near 10^6 a float resolves 1/16 of a cell.
TYPED_TEST(Projecting, is_as_exact_in_single_precision_far_from_the_first_cell) {
  constexpr int D = TypeParam::dimension;
  const double here = NodesOfACircle<float, D>(0).error();
  EXPECT_EQ((NodesOfACircle<float, D>(1 << 20).error()), here);
}

}  // namespace
}  // namespace pliant::test
