#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "engine/total_lagrangian/fitted_cells.hpp"

namespace pliant::total_lagrangian {

/// [slot] by how far particles start from their nodes [m], (TL.11).
template <int D>
using Shifts = std::map<std::int32_t, Column<D>>;

/// The cells of a body whose corners are shifted. Keeps references.
template <class T, int D>
class ShiftedCells {
 public:
  /// `held` tells for each slot whether a wall holds its particle.
  ShiftedCells(const Body<T, D>& body, const std::vector<bool>& held) : body_(body), held_(held) {}

  /// Halves the shifts of the corners of cells that would collapse.
  void keep_open(Shifts<D>& shifts) const {
    for (int k = 0; k < most_halvings; ++k) {
      std::set<std::int32_t> closing;
      for_each_filled_cell([&](const Cell<D>& cell) {
        const auto corners = body_.corners(cell);
        const auto moves = [&](std::int64_t q) { return shifts.contains(static_cast<int>(q)); };
        if (std::none_of(corners.begin(), corners.end(), moves)) return;
        if (volume_of(corners, shifts) > smallest_det) return;
        if (is_held(corners)) return;
        for (const std::int64_t q : corners) {
          if (moves(q)) closing.insert(static_cast<std::int32_t>(q));
        }
      });
      if (closing.empty()) return;
      for (const std::int32_t q : closing) shifts[q] /= 2;
    }
  }

  /// Cells behind a wall that shifts have made flat, or have pulled into the body: what is there
  /// belongs to the cells before them.
  std::vector<Cell<D>> flat(const Shifts<D>& shifts) const {
    std::set<Cell<D>> flat;
    for (const auto& [slot, shift] : shifts) {
      const Cell<D> corner = body_.layout.cell(slot);
      for (int c = 0; c < (1 << D); ++c) {
        Cell<D> cell = corner;
        for (int a = 0; a < D; ++a) cell[a] -= c >> a & 1;
        const std::int64_t p = body_.layout.slot(cell);
        if (p < 0) continue;
        const Corners corners = body_.corners(cell);
        if (has_free_corner(corners)) continue;
        if (!(body_.fraction[p] > 0) || volume_of(corners, shifts) < smallest_det)
          flat.insert(cell);
      }
    }
    return {flat.begin(), flat.end()};
  }

 private:
  static constexpr double smallest_det = 0.1;  // smallest det A of a cell, (TL.11)
  static constexpr int most_halvings = 8;

  using Corners = std::array<std::int64_t, (1 << D)>;

  // det A of (TL.11).
  double volume_of(const Corners& corners, const Shifts<D>& shifts) const {
    const auto shift_of = [&](std::int64_t slot) -> Column<D> {
      const auto found = shifts.find(static_cast<std::int32_t>(slot));
      return found == shifts.end() ? Column<D>::Zero() : found->second;
    };
    return shape_of<D>(corners, moments_of_whole_cell<D>, body_.lattice.spacing, shift_of)
        .determinant();
  }

  bool is_held(const Corners& corners) const {
    return std::ranges::all_of(corners, [&](std::int64_t q) { return held_[q]; });
  }

  bool has_free_corner(const Corners& corners) const {
    return std::ranges::any_of(
        corners, [&](std::int64_t q) { return q >= 0 && body_.is_particle(q) && !held_[q]; });
  }

  template <class F>
  void for_each_filled_cell(F&& f) const {
    for (const Block<D>& block : body_.layout.blocks()) {
      body_.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
        if (body_.fraction[p] > 0) f(cell);
      });
    }
  }

  const Body<T, D>& body_;
  const std::vector<bool>& held_;
};

}  // namespace pliant::total_lagrangian
