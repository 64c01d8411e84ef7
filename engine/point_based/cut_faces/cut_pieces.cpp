#include "engine/point_based/cut_faces/cut_pieces.hpp"

#include "engine/point_based/cutting/subdivide.hpp"
#include "engine/undeformed/body.hpp"
#include "engine/undeformed/contact/contact_surface.hpp"

namespace pliant::point_based {

namespace {

template <int D>
std::vector<Box<D>> boxes_of_pieces(std::span<const CutSurface<D>> cuts) {
  std::vector<Box<D>> boxes;
  for (const CutSurface<D>& cut : cuts) {
    for (std::size_t p = 0; p < cut.pieces().size(); ++p) {
      Box<D>& box = boxes.emplace_back();
      for (const Point<D>& corner : cut.corners(p)) box.grow(corner);
    }
  }
  return boxes;
}

template <int D>
Box<D> box_between(const Point<D>& p, const Point<D>& q) {
  Box<D> box;
  box.grow(p);
  box.grow(q);
  return box;
}

}  // namespace

template <int D>
CutPieces<D>::CutPieces(std::span<const CutSurface<D>> cuts) : tree_(boxes_of_pieces(cuts)) {
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    for (std::size_t p = 0; p < cuts[c].pieces().size(); ++p) {
      const auto corners = cuts[c].corners(p);
      pieces_.push_back({corners, PieceCrossing<D>(corners), static_cast<std::int32_t>(c)});
    }
  }
}

template <int D>
auto CutPieces<D>::crossings(const Point<D>& p, const Point<D>& q) const -> std::vector<Crossed> {
  std::vector<Crossed> found;
  tree_.for_each_near(box_between<D>(p, q), 0, 0, [&](std::size_t i) {
    const auto place = pieces_[i].crossing(p, q);
    if (!place) return;
    Point<D> normal = undeformed::area_vector<D>(pieces_[i].corners);
    undeformed::normalise<D>(normal);
    found.push_back({*place, normal, pieces_[i].cut});
  });
  return found;
}

template <int D>
bool CutPieces<D>::separate(const Point<D>& p, const Point<D>& q, std::int32_t but) const {
  bool is_crossed = false;
  tree_.for_each_near(box_between<D>(p, q), 0, 0, [&](std::size_t i) {
    is_crossed = is_crossed || (pieces_[i].cut != but && pieces_[i].crossing(p, q));
  });
  return is_crossed;
}

template <int D>
std::vector<Box<D>> CutPieces<D>::boxes(double length) const {
  std::vector<Box<D>> boxes;
  for (const Piece& piece : pieces_) {
    subdivide<D>(piece.corners, length, [&boxes](const std::array<Point<D>, D>& part) {
      Box<D>& box = boxes.emplace_back();
      for (const Point<D>& corner : part) box.grow(corner);
    });
  }
  return boxes;
}

template class CutPieces<2>;
template class CutPieces<3>;

}  // namespace pliant::point_based
