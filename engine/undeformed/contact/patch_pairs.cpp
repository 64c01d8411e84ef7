#include "engine/undeformed/contact/patch_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "engine/blocks/box_tree.hpp"

namespace pliant::undeformed {

namespace {

constexpr double list_margin = 0.5;  // least motion of patches between two lists [spacing]
constexpr double pair_margin = 4;    // least motion of bodies between two pairings [spacing]
constexpr double without_rounding_of_boxes = 1 - 1e-6;

}  // namespace

template <class T, int D>
PatchPairs<T, D>::PatchPairs(MovingSurface<T, D>& corners, MovingSurface<T, D>& facets,
                             double reach)
    : corners_(corners),
      facets_(facets),
      reach_(reach),
      margin_(list_margin * facets.spacing()),
      box_(corners.patches().count()),
      other_box_(facets.patches().count()),
      moved_(box_.size()) {}

// The motion relative to the mean of both surfaces, so that bodies that fly together keep their
// pairs.
template <class T, int D>
double PatchPairs<T, D>::motion_in_common_frame() const {
  Point<D> frame;
  for (int a = 0; a < D; ++a) {
    frame[a] = (corners_.patches().drift()[a] + facets_.patches().drift()[a]) / 2;
  }
  return corners_.patches().largest_motion(frame) + facets_.patches().largest_motion(frame);
}

template <class T, int D>
bool PatchPairs<T, D>::hold() {
  if (used_ + motion_in_common_frame() + margin_ > wide_) pair_patches();
  std::fill(moved_.begin(), moved_.end(), 0.);
  most_moved_ = 0;
  for (const Pair& pair : pairs_) {
    const double moved = relative_motion<D>(corners_.patches().motion(pair.corners),
                                            facets_.patches().motion(pair.facets));
    if (moved > pair.room) return false;
    if (!pair.is_listed) continue;
    moved_[pair.corners] = std::max(moved_[pair.corners], moved);
    most_moved_ = std::max(most_moved_, moved);
  }
  return true;
}

template <class T, int D>
void PatchPairs<T, D>::expect_marks() {
  used_ += motion_in_common_frame();
}

template <class T, int D>
void PatchPairs<T, D>::measure(bool foreign) {
  if (foreign) pair_patches();
  for (const std::int32_t p : paired_) corners_.find_marked_places(p);
  for (const std::int32_t p : paired_others_) facets_.find_marked_places(p);
  for (const std::int32_t p : paired_) box_[p] = marked_box_of_corners(p);
  for (const std::int32_t p : paired_others_) other_box_[p] = marked_box_of_facets(p);
  find_rooms();
}

template <class T, int D>
Box<D> PatchPairs<T, D>::marked_box_of_corners(std::size_t patch) const {
  Box<D> box;
  for (const std::int32_t corner : corners_.patches().corners(patch)) {
    box.grow(corners_.place(corner));
  }
  return box;
}

template <class T, int D>
Box<D> PatchPairs<T, D>::marked_box_of_facets(std::size_t patch) const {
  Box<D> box;
  for (const std::int32_t facet : facets_.patches().facets(patch)) {
    for (const std::int32_t corner : facets_.facet(facet)) box.grow(facets_.place(corner));
  }
  return box;
}

// Pairs patches from the marks. Patches without a partner may move by `wide_`.
template <class T, int D>
void PatchPairs<T, D>::pair_patches() {
  used_ = 0;
  Box<D> all, all_others;
  for (std::size_t p = 0; p < box_.size(); ++p) corners_.find_marked_places(p);
  for (std::size_t p = 0; p < other_box_.size(); ++p) facets_.find_marked_places(p);
  for (std::size_t p = 0; p < box_.size(); ++p) all.grow(box_[p] = marked_box_of_corners(p));
  for (std::size_t p = 0; p < other_box_.size(); ++p) {
    all_others.grow(other_box_[p] = marked_box_of_facets(p));
  }
  wide_ = std::max({pair_margin * facets_.spacing(), 2 * motion_in_common_frame() + margin_,
                    without_rounding_of_boxes * std::sqrt(squared_gap(all, all_others)) - reach_});
  const double reach = (reach_ + wide_) / without_rounding_of_boxes;
  pairs_.clear();
  const BoxTree<D> tree(other_box_);
  for (std::size_t p = 0; p < box_.size(); ++p) {
    tree.for_each_near(box_[p], reach * reach, 0, [&](std::size_t q) {
      pairs_.push_back({static_cast<std::int32_t>(p), static_cast<std::int32_t>(q), 0, false});
    });
  }
  paired_.clear();
  paired_others_.clear();
  for (const Pair& pair : pairs_) {
    paired_.push_back(pair.corners);
    paired_others_.push_back(pair.facets);
  }
  for (std::vector<std::int32_t>* patches : {&paired_, &paired_others_}) {
    std::sort(patches->begin(), patches->end());
    patches->erase(std::unique(patches->begin(), patches->end()), patches->end());
  }
  find_rooms();
}

template <class T, int D>
void PatchPairs<T, D>::find_rooms() {
  for (Pair& pair : pairs_) {
    const double gap = std::sqrt(squared_gap(box_[pair.corners], other_box_[pair.facets]));
    pair.is_listed = gap <= reach_ + margin_;
    pair.room = without_rounding_of_boxes * (pair.is_listed ? margin_ : gap - reach_);
  }
}

template class PatchPairs<double, 2>;
template class PatchPairs<double, 3>;
template class PatchPairs<float, 2>;
template class PatchPairs<float, 3>;

}  // namespace pliant::undeformed
