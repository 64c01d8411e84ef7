#include "engine/point_based/cutting/cut_bonds.hpp"

#include <algorithm>
#include <cmath>

#include "engine/point_based/cutting/crossing.hpp"

namespace pliant::point_based {
namespace {

template <int D>
std::vector<Box<D>> boxes_of(const std::vector<MaterialPoint<D>>& positions, const BondRows& bonds,
                             std::int32_t first, std::int32_t last) {
  std::vector<Box<D>> boxes(last - first);
  for (std::int32_t i = first; i < last; ++i) {
    Box<D>& box = boxes[i - first];
    box.grow(positions[i]);
    for (std::int64_t b = bonds.first[i]; b < bonds.first[i + 1]; ++b) {
      box.grow(positions[bonds.neighbour[b]]);
    }
  }
  return boxes;
}

template <int D>
Box<D> box_of(const CutSurface<D>& cut, std::size_t piece) {
  Box<D> box;
  for (const std::int32_t corner : cut.pieces()[piece]) box.grow(cut.points()[corner]);
  return box;
}

/// Bonds that end on a piece, up to rounding, are tested in both directions.
double squared_slack(double least_size) { return 1e-18 * least_size * least_size; }

}  // namespace

template <int D>
CutBonds<D>::CutBonds(std::vector<Point> positions, std::vector<double> sizes, BondRows bonds,
                      CutRule rule, InsideTest<D> is_inside,
                      const std::vector<std::int32_t>& first_nodes)
    : positions_(std::move(positions)),
      sizes_(std::move(sizes)),
      bonds_(std::move(bonds)),
      rule_(rule),
      is_inside_(std::move(is_inside)),
      least_size_(*std::min_element(sizes_.begin(), sizes_.end())),
      factors_(bonds_.neighbour.size(), 1.) {
  parts_.reserve(first_nodes.size());
  for (std::size_t p = 0; p < first_nodes.size(); ++p) {
    const std::int32_t first = first_nodes[p];
    const std::int32_t last = p + 1 < first_nodes.size()
                                  ? first_nodes[p + 1]
                                  : static_cast<std::int32_t>(positions_.size());
    parts_.push_back(
        {first, last, BoxTree<D>(boxes_of<D>(positions_, bonds_, first, last)), {}, {}});
  }
}

template <int D>
std::int32_t CutBonds<D>::add_cut() {
  cuts_.emplace_back();
  first_new_.push_back(0);
  fronts_.emplace_back(is_inside_, least_size_);
  grids_.emplace_back();
  return static_cast<std::int32_t>(cuts_.size()) - 1;
}

template <int D>
void CutBonds<D>::begin_moves() {
  for (std::size_t c = 0; c < cuts_.size(); ++c) {
    first_new_[c] = cuts_[c].pieces().size();
    fronts_[c].forget_changes();
  }
}

template <int D>
void CutBonds<D>::move(std::int32_t cut, const std::vector<Point>& station) {
  cuts_[cut].add_station(station);
  if (cuts_[cut].pieces().empty()) return;
  if (rule_ == CutRule::enrichment_grid) grids_[cut].emplace(cuts_[cut]);
  if (rule_ != CutRule::transparency) return;
  // A new piece can move the front of its own cut, and remove that of another cut that it meets.
  for (std::size_t c = 0; c < cuts_.size(); ++c) fronts_[c].update(cuts_, c);
}

template <int D>
const std::vector<std::int32_t>& CutBonds<D>::update(std::size_t number) {
  Part& part = parts_[number];
  part.changed.clear();
  switch (rule_) {
    case CutRule::visibility:
      cut_visible(part);
      break;
    case CutRule::transparency:
      cut_transparent(part);
      break;
    case CutRule::product:
      cut_product(part);
      break;
    case CutRule::enrichment_grid:
      cut_grid(part);
      break;
  }
  std::sort(part.changed.begin(), part.changed.end());
  part.changed.erase(std::unique(part.changed.begin(), part.changed.end()), part.changed.end());
  return part.changed;
}

template <int D>
const std::vector<std::int32_t>& CutBonds<D>::advance(std::int32_t cut,
                                                      const std::vector<Point>& station) {
  begin_moves();
  move(cut, station);
  changed_.clear();
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const std::vector<std::int32_t>& nodes = update(part);
    changed_.insert(changed_.end(), nodes.begin(), nodes.end());
  }
  return changed_;
}

template <int D>
void CutBonds<D>::set(Part& part, std::int32_t node, std::int64_t bond, double factor) {
  if (factors_[bond] == factor) return;
  factors_[bond] = factor;
  part.changed.push_back(node);
}

/// Calls f(node, piece), piece by piece, for the nodes of a part whose bonds may reach pieces of a
/// cut.
template <int D>
template <class F>
void CutBonds<D>::for_each_near(const Part& part, std::int32_t cut, std::size_t first_piece,
                                F&& f) const {
  for (std::size_t piece = first_piece; piece < cuts_[cut].pieces().size(); ++piece) {
    part.boxes.for_each_near(
        box_of(cuts_[cut], piece), squared_slack(least_size_), 0,
        [&](std::size_t i) { f(part.first + static_cast<std::int32_t>(i), piece); });
  }
}

/// Calls f(node, bond, cut, place) for each bond with weight that a new piece crosses. Both
/// directions of a bond are tested from the node with the lower number, so that they agree.
template <int D>
template <class F>
void CutBonds<D>::for_each_crossed(const Part& part, F&& f) {
  for (std::int32_t cut = 0; cut < static_cast<std::int32_t>(cuts_.size()); ++cut) {
    std::optional<PieceCrossing<D>> crossed;
    std::size_t tested = cuts_[cut].pieces().size();
    for_each_near(part, cut, first_new_[cut], [&](std::int32_t i, std::size_t piece) {
      if (piece != tested) crossed.emplace(cuts_[cut].corners(piece));
      tested = piece;
      for (std::int64_t b = bonds_.first[i]; b < bonds_.first[i + 1]; ++b) {
        if (factors_[b] == 0) continue;
        const std::int32_t j = bonds_.neighbour[b];
        const auto place = (*crossed)(positions_[std::min(i, j)], positions_[std::max(i, j)]);
        if (place) f(i, b, cut, *place);
      }
    });
  }
}

template <int D>
void CutBonds<D>::cut_visible(Part& part) {
  for_each_crossed(part, [&](std::int32_t node, std::int64_t bond, std::int32_t, const Point&) {
    set(part, node, bond, 0);
  });
}

// The share of a bond changes when it is crossed, and when parts of the front near the crossing are
// added or removed.
template <int D>
void CutBonds<D>::cut_transparent(Part& part) {
  for_each_crossed(part,
                   [&](std::int32_t node, std::int64_t bond, std::int32_t cut, const Point& place) {
                     const double size = (sizes_[node] + sizes_[bonds_.neighbour[bond]]) / 2;
                     part.open.push_back({bond, node, cut, place, size});
                   });
  std::erase_if(part.open, [&](Crossing& open) {
    Box<D> place;
    place.grow(open.place);
    const double reach = reach_of_front * open.size;
    const double square = reach * reach * (1 + 1e-6);  // 1e-6: rounding of distances
    if (!open.is_new && squared_gap(fronts_[open.cut].changed(), place) > square) return false;
    open.is_new = false;
    const double ahead = fronts_[open.cut].distance(open.place, reach);
    const double left = share_before_front(ahead, open.size);
    set(part, open.node, open.bond, std::min(factors_[open.bond], left));
    return left == 0;
  });
}

template <int D>
void CutBonds<D>::cut_product(Part& part) {
  for (std::int32_t cut = 0; cut < static_cast<std::int32_t>(cuts_.size()); ++cut) {
    for_each_near(part, cut, first_new_[cut], [&](std::int32_t i, std::size_t piece) {
      const auto corners = cuts_[cut].corners(piece);
      const double e_i = piece_enrichment<D>(positions_[i], corners);
      for (std::int64_t b = bonds_.first[i]; b < bonds_.first[i + 1]; ++b) {
        const double e_j = piece_enrichment<D>(positions_[bonds_.neighbour[b]], corners);
        set(part, i, b, factors_[b] * (1 + e_i * e_j) / 2);  // (CU.3)
      }
    });
  }
}

template <int D>
void CutBonds<D>::cut_grid(Part& part) {
  std::vector<bool> is_near(part.last - part.first);
  for (std::int32_t cut = 0; cut < static_cast<std::int32_t>(cuts_.size()); ++cut) {
    if (cuts_[cut].pieces().size() == first_new_[cut]) continue;
    for_each_near(part, cut, 0,
                  [&](std::int32_t i, std::size_t) { is_near[i - part.first] = true; });
  }
  for (std::int32_t i = part.first; i < part.last; ++i) {
    if (!is_near[i - part.first]) continue;
    for (std::int64_t b = bonds_.first[i]; b < bonds_.first[i + 1]; ++b) {
      double factor = 1;
      for (const auto& grid : grids_) {
        if (!grid) continue;
        const double e_i = (*grid)(positions_[i]);
        const double e_j = (*grid)(positions_[bonds_.neighbour[b]]);
        factor *= (1 + e_i * e_j) / 2;  // (CU.3)
      }
      set(part, i, b, factor);
    }
  }
}

template class CutBonds<2>;
template class CutBonds<3>;

}  // namespace pliant::point_based
