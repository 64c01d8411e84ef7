#include "engine/point_based/surface/sharp_edges.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/nodes/faces.hpp"
#include "engine/point_based/surface/surface_lattice.hpp"

// Corners of facets lie where lines of the lattice leave the body, so that facets cut off its
// edges:
//
//          face           face        The end of such a facet that is nearer to the edge moves onto
//     o-------o        o--------o     it: now both facets lie on faces.
//              \   ->           |
//               o               |
//               | face          o face
namespace pliant::point_based {

namespace {

template <int D>
class EdgeSharpener {
 public:
  EdgeSharpener(const Shape& shape, BodySurface<D>& surface)
      : faces_(shape, surface.spacing), surface_(surface) {
    for (Point<D>& x : surface.start) {
      through_.push_back(faces_.through_or_near(x));
      if (faces_.are_planes(through_.back())) x = faces_.onto(x, through_.back());
    }
  }

  void sharpen() {
    std::vector<std::size_t> facets = facets_across_edges();
    if (facets.empty()) return;
    for (const std::size_t f : facets) {
      for (const std::int32_t corner : surface_.facet[f]) {
        surface_.start[corner] = faces_.onto(surface_.start[corner], through_[corner]);
      }
    }
    while (move_corners(facets)) facets = facets_across_edges();
    drop_flat_facets();
  }

 private:
  using Facet = std::array<std::int32_t, D>;

  /// The move of a corner of a facet onto an edge or a corner of the body.
  struct Move {
    double way;  ///< [m]
    std::int32_t corner;
    std::size_t facet;
    std::vector<int> faces;  ///< that meet there
    Point<D> place;          ///< [m]
  };

  bool is_on(std::int32_t corner, int face) const {
    return std::ranges::find(through_[corner], face) != through_[corner].end();
  }

  /// Whether the corners of a facet lie on faces, but not all on one.
  bool cuts_off_an_edge(const Facet& facet) const {
    if (std::ranges::any_of(facet, [&](std::int32_t v) { return through_[v].empty(); })) {
      return false;
    }
    return std::ranges::none_of(through_[facet[0]], [&](int face) {
      return std::ranges::all_of(facet, [&](std::int32_t v) { return is_on(v, face); });
    });
  }

  std::vector<std::size_t> facets_across_edges() const {
    std::vector<std::size_t> facets;
    for (std::size_t f = 0; f < surface_.facet.size(); ++f) {
      if (cuts_off_an_edge(surface_.facet[f])) facets.push_back(f);
    }
    return facets;
  }

  /// Adds the moves of a corner of a facet onto faces of other corners along its own faces.
  void add_moves(std::size_t facet, std::int32_t corner, std::vector<Move>& moves) const {
    if (through_[corner].size() == D) return;
    for (const std::int32_t other : surface_.facet[facet]) {
      for (const int face : through_[other]) {
        if (is_on(corner, face)) continue;
        Move move = {0, corner, facet, through_[corner], {}};
        move.faces.push_back(face);
        move.place = faces_.onto(surface_.start[corner], move.faces);
        move.way = norm<D>(difference<D>(move.place, surface_.start[corner]));
        if (move.way <= surface_.spacing && faces_.meet(move.place, move.faces)) {
          moves.push_back(std::move(move));
        }
      }
    }
  }

  /// Makes the shortest moves first, as long as they concern corners that are where they were.
  bool move_corners(const std::vector<std::size_t>& facets) {
    std::vector<Move> moves;
    for (const std::size_t f : facets) {
      for (const std::int32_t corner : surface_.facet[f]) add_moves(f, corner, moves);
    }
    std::ranges::stable_sort(moves, {}, &Move::way);
    bool has_moved = false;
    for (const Move& move : moves) {
      std::vector<int>& through = through_[move.corner];
      const bool is_where_it_was = through.size() < move.faces.size();
      if (!is_where_it_was || !cuts_off_an_edge(surface_.facet[move.facet])) continue;
      through = faces_.through(move.place);
      surface_.start[move.corner] = move.place;
      has_moved = true;
    }
    return has_moved;
  }

  void drop_flat_facets() {
    std::erase_if(surface_.facet, [&](const auto& facet) {
      std::array<Point<D>, D> x;
      for (int v = 0; v < D; ++v) x[v] = surface_.start[facet[v]];
      return !has_area<D>(x, surface_.spacing);
    });
  }

  Faces<D> faces_;
  BodySurface<D>& surface_;
  std::vector<std::vector<int>> through_;  ///< [corner] faces
};

}  // namespace

template <int D>
void sharpen_edges(const Shape& shape, BodySurface<D>& surface) {
  EdgeSharpener<D>(shape, surface).sharpen();
}

template void sharpen_edges<2>(const Shape&, BodySurface<2>&);
template void sharpen_edges<3>(const Shape&, BodySurface<3>&);

}  // namespace pliant::point_based
