#include "engine/point_based/observe/opened_surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/blocks/box_tree.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/point_based/cutting/crossing.hpp"
#include "engine/point_based/cutting/subdivide.hpp"
#include "engine/point_based/nearest_nodes.hpp"
#include "engine/point_based/node_state.hpp"
#include "engine/point_based/surface.hpp"

namespace pliant::point_based {
namespace {

constexpr std::size_t carriers = 8;  // nodes that a place moves with
constexpr double beside = 0.3;       // from a piece to where its side is looked at [H]

template <int D>
using Corners = std::array<Point<D>, D>;

template <class T, int D>
class SurfaceWriter {
 public:
  SurfaceWriter(const Body<T, D>& body, std::span<const CutSurface<D>> cuts, int owner,
                SurfaceVertices& vertices)
      : body_(body), owner_(owner), vertices_(vertices) {
    body.for_each_node([&](std::int64_t slot) {
      slots_.push_back(slot);
      places_.push_back(body.start[slot]);
      states_.push_back(node_state(body, body.block_of(slot), slot));
    });
    tree_.emplace(places_);
    std::vector<Box<D>> boxes;
    for (const CutSurface<D>& cut : cuts) {
      for (std::size_t p = 0; p < cut.pieces().size(); ++p) {
        pieces_.push_back(cut.corners(p));
        Box<D>& box = boxes.emplace_back();
        for (const Point<D>& corner : pieces_.back()) box.grow(corner);
      }
    }
    boxes_.emplace(std::move(boxes));
  }

  void write() {
    for (const auto& facet : body_.surface.facet) {
      Corners<D> corners;
      for (int v = 0; v < D; ++v) corners[v] = body_.surface.start[facet[v]];
      add(corners);
    }
    const auto is_inside = inside_of<D>(body_.source->geometry, 0);
    for (const Corners<D>& cut : pieces_) {
      subdivide<D>(cut, body_.resolution, [&](Corners<D> piece) {
        if (!is_inside(centre<D>(piece))) return;
        add(piece);
        std::swap(piece[0], piece[1]);
        add(piece);
      });
    }
  }

 private:
  /// A piece whose body lies behind it; nothing for a piece without area.
  void add(const Corners<D>& piece) {
    Point<D> side = centre<D>(piece);
    const Point<D> area = undeformed::area_vector<D>(piece);
    double square = 0;
    for (const double component : area) square += component * component;
    if (square == 0) return;
    for (int a = 0; a < D; ++a) {
      side[a] -= beside * body_.resolution * area[a] / std::sqrt(square);
    }
    const std::int64_t slot = slots_[tree_->nearest(side)];
    for (const Point<D>& corner : piece) {
      const Point<D> now = present(corner, side);
      const Vector x = padded<D>(now);
      vertices_.vertex.push_back(static_cast<std::int64_t>(vertices_.owner.size()));
      vertices_.position.insert(vertices_.position.end(), x.begin(), x.end());
      for (int a = 0; a < D; ++a) {
        vertices_.displacement.push_back(now[a] - corner[a]);
        vertices_.velocity.push_back(body_.velocity[a][slot]);
      }
      vertices_.owner.push_back(owner_);
    }
  }

  bool is_cut_off(const Point<D>& node, const Point<D>& side) const {
    Box<D> way;
    way.grow(node);
    way.grow(side);
    bool is_crossed = false;
    boxes_->for_each_near(way, 0, 0, [&](std::size_t piece) {
      is_crossed = is_crossed || crossing<D>(node, side, pieces_[piece]);
    });
    return is_crossed;
  }

  /// Where `x` is now: a mean over the nearest nodes on its side of x_i + F_i (X - X_i), with
  /// weights that vanish at the farthest.
  Point<D> present(const Point<D>& x, const Point<D>& side) const {
    const auto near = tree_->nearest(x, carriers + 1);
    const double farthest = near.back().distance;
    Point<D> sum = {};
    double weights = 0;
    for (const auto& [distance, node] : near) {
      if (is_cut_off(places_[node], side)) continue;
      const double weight = 1e-6 + 1 - distance * distance / (farthest * farthest);
      const Point<D> at = body_.position(slots_[node]);
      for (int a = 0; a < D; ++a) {
        double moved = at[a];
        for (int b = 0; b < D; ++b) {
          moved += states_[node].gradient[D * a + b] * (x[b] - places_[node][b]);
        }
        sum[a] += weight * moved;
      }
      weights += weight;
    }
    // A sliver without nodes of its own stays where it was.
    if (weights == 0) return x;
    for (double& component : sum) component /= weights;
    return sum;
  }

  const Body<T, D>& body_;
  int owner_;
  SurfaceVertices& vertices_;
  std::vector<std::int64_t> slots_;  ///< [node]
  std::vector<Point<D>> places_;     ///< [node] undeformed
  std::vector<NodeState<D>> states_;
  std::optional<NearestNodes<D>> tree_;
  std::vector<Corners<D>> pieces_;   ///< of all cuts, along the way of each blade
  std::optional<BoxTree<D>> boxes_;  ///< [piece]
};

}  // namespace

template <class T, int D>
void add_opened_surface(const Body<T, D>& body, std::span<const CutSurface<D>> cuts, int owner,
                        SurfaceVertices& vertices) {
  SurfaceWriter<T, D>(body, cuts, owner, vertices).write();
}

template void add_opened_surface<double, 2>(const Body<double, 2>&, std::span<const CutSurface<2>>,
                                            int, SurfaceVertices&);
template void add_opened_surface<double, 3>(const Body<double, 3>&, std::span<const CutSurface<3>>,
                                            int, SurfaceVertices&);
template void add_opened_surface<float, 2>(const Body<float, 2>&, std::span<const CutSurface<2>>,
                                           int, SurfaceVertices&);
template void add_opened_surface<float, 3>(const Body<float, 3>&, std::span<const CutSurface<3>>,
                                           int, SurfaceVertices&);

}  // namespace pliant::point_based
