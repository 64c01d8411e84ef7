#include "engine/point_based/cutting/cut_bonds.hpp"

#include <algorithm>
#include <cmath>

#include "engine/point_based/cutting/crossing.hpp"

namespace pliant::point_based {
namespace {

template <int D>
std::vector<Box<D>> boxes_of(const std::vector<MaterialPoint<D>>& positions,
                             const BondRows& bonds) {
  std::vector<Box<D>> boxes(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    boxes[i].grow(positions[i]);
    for (std::int64_t b = bonds.first[i]; b < bonds.first[i + 1]; ++b) {
      boxes[i].grow(positions[bonds.neighbour[b]]);
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

/// Bonds that end on a piece up to rounding are tested in both directions.
double squared_slack(double least_size) { return 1e-18 * least_size * least_size; }

double smoothstep(double x) {
  const double s = std::clamp(x, 0., 1.);
  return s * s * (3 - 2 * s);
}

}  // namespace

template <int D>
CutBonds<D>::CutBonds(std::vector<Point> positions, std::vector<double> sizes, BondRows bonds,
                      CutRule rule, InsideTest<D> is_inside)
    : positions_(std::move(positions)),
      sizes_(std::move(sizes)),
      bonds_(std::move(bonds)),
      rule_(rule),
      is_inside_(std::move(is_inside)),
      least_size_(*std::min_element(sizes_.begin(), sizes_.end())),
      boxes_(boxes_of<D>(positions_, bonds_)),
      factors_(bonds_.neighbour.size(), 1.) {}

template <int D>
std::int32_t CutBonds<D>::add_cut() {
  cuts_.emplace_back();
  fronts_.emplace_back(is_inside_, least_size_);
  grids_.emplace_back();
  return static_cast<std::int32_t>(cuts_.size()) - 1;
}

template <int D>
const std::vector<std::int32_t>& CutBonds<D>::advance(std::int32_t cut,
                                                      const std::vector<Point>& station) {
  const std::size_t first_piece = cuts_[cut].pieces().size();
  cuts_[cut].add_station(station);
  changed_.clear();
  if (cuts_[cut].pieces().empty()) return changed_;
  switch (rule_) {
    case CutRule::visibility:
      cut_visible(cut, first_piece);
      break;
    case CutRule::transparency:
      cut_transparent(cut, first_piece);
      break;
    case CutRule::product:
      cut_product(cut, first_piece);
      break;
    case CutRule::enrichment_grid:
      cut_grid(cut);
      break;
  }
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  return changed_;
}

template <int D>
void CutBonds<D>::set(std::int32_t node, std::int64_t bond, double factor) {
  if (factors_[bond] == factor) return;
  factors_[bond] = factor;
  changed_.push_back(node);
}

/// Calls f(node, bond, place) for each bond with weight that a new piece crosses. Both directions
/// of a bond are tested from the node of lower number on, so that they get the same answer.
template <int D>
template <class F>
void CutBonds<D>::for_each_crossed(std::int32_t cut, std::size_t first_piece, F&& f) {
  for (std::size_t piece = first_piece; piece < cuts_[cut].pieces().size(); ++piece) {
    const auto corners = cuts_[cut].corners(piece);
    boxes_.for_each_near(
        box_of(cuts_[cut], piece), squared_slack(least_size_), 0, [&](std::size_t i) {
          for (std::int64_t b = bonds_.first[i]; b < bonds_.first[i + 1]; ++b) {
            if (factors_[b] == 0) continue;
            const auto j = static_cast<std::size_t>(bonds_.neighbour[b]);
            const auto place =
                crossing<D>(positions_[std::min(i, j)], positions_[std::max(i, j)], corners);
            if (place) f(static_cast<std::int32_t>(i), b, *place);
          }
        });
  }
}

template <int D>
void CutBonds<D>::cut_visible(std::int32_t cut, std::size_t first_piece) {
  for_each_crossed(cut, first_piece,
                   [&](std::int32_t node, std::int64_t bond, const Point&) { set(node, bond, 0); });
}

template <int D>
void CutBonds<D>::cut_transparent(std::int32_t cut, std::size_t first_piece) {
  for_each_crossed(cut, first_piece, [&](std::int32_t node, std::int64_t bond, const Point& place) {
    const double size = (sizes_[node] + sizes_[bonds_.neighbour[bond]]) / 2;
    open_.push_back({bond, node, cut, place, size});
  });
  // A new piece can move the front of its own cut, and take away that of another that it meets.
  for (std::size_t c = 0; c < cuts_.size(); ++c) fronts_[c].update(cuts_, c);
  std::erase_if(open_, [&](const Crossing& open) {
    const double ahead = fronts_[open.cut].distance(open.place, open.size);
    const double left = 1 - smoothstep(ahead / open.size);  // (CU.1)
    set(open.node, open.bond, std::min(factors_[open.bond], left));
    return left == 0;
  });
}

template <int D>
void CutBonds<D>::cut_product(std::int32_t cut, std::size_t first_piece) {
  for (std::size_t piece = first_piece; piece < cuts_[cut].pieces().size(); ++piece) {
    const auto corners = cuts_[cut].corners(piece);
    boxes_.for_each_near(
        box_of(cuts_[cut], piece), squared_slack(least_size_), 0, [&](std::size_t i) {
          const double e_i = piece_enrichment<D>(positions_[i], corners);
          for (std::int64_t b = bonds_.first[i]; b < bonds_.first[i + 1]; ++b) {
            const double e_j = piece_enrichment<D>(positions_[bonds_.neighbour[b]], corners);
            set(static_cast<std::int32_t>(i), b, factors_[b] * (1 + e_i * e_j) / 2);  // (CU.3)
          }
        });
  }
}

template <int D>
void CutBonds<D>::cut_grid(std::int32_t cut) {
  grids_[cut].emplace(cuts_[cut]);
  std::vector<bool> is_near(positions_.size());
  for (std::size_t piece = 0; piece < cuts_[cut].pieces().size(); ++piece) {
    boxes_.for_each_near(box_of(cuts_[cut], piece), squared_slack(least_size_), 0,
                         [&](std::size_t i) { is_near[i] = true; });
  }
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (!is_near[i]) continue;
    for (std::int64_t b = bonds_.first[i]; b < bonds_.first[i + 1]; ++b) {
      double factor = 1;
      for (const auto& grid : grids_) {
        if (!grid) continue;
        const double e_i = (*grid)(positions_[i]);
        const double e_j = (*grid)(positions_[bonds_.neighbour[b]]);
        factor *= (1 + e_i * e_j) / 2;  // (CU.3)
      }
      set(static_cast<std::int32_t>(i), b, factor);
    }
  }
}

template class CutBonds<2>;
template class CutBonds<3>;

}  // namespace pliant::point_based
