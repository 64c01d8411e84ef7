#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "kernels/remeshed/table.hpp"
#include "tests/kernels/field.hpp"

namespace pliant::kernels::test {

/// Rows that fill the box around a remeshing tile.
template <int D>
std::vector<NodeRow> whole_rows(const std::array<std::int32_t, D>& extent) {
  std::vector<NodeRow> rows(D == 3 ? extent[1] * extent[2] : extent[1]);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    rows[r] = {0, extent[0], static_cast<std::int64_t>(r) * extent[0]};
  }
  return rows;
}

/// A full box of lattice cells in memory, with the layout that kernels expect: rows of whole packs
/// with spare packs between them. Cells nearer than `margin` to the faces of the box are not
/// interior, so that rows begin and end with packs that are interior in some lanes only.
template <class T, int D>
class Patch {
 public:
  static constexpr int pack = slots_per_pack;
  static constexpr int margin = 3;

  Patch(std::array<int, D> cells, T h) : spacing(h), cells_(cells) {
    row_slots_ = cells[0] + pack;
    int rows = 1;
    for (int i = 1; i < D; ++i) rows *= cells[i];
    slots = padding * 2 + static_cast<std::int64_t>(rows) * row_slots_;
    interior.assign(slots, 0);
    kind.assign(slots, Kind::vacant);
    pack_state.assign(slots / pack, PackState::ghosts);
    for (int row = 0; row < rows; ++row) add_row(row);
  }

  std::int64_t slot(const std::array<int, D>& cell) const {
    std::int64_t row = D == 3 ? cell[D - 1] * cells_[1] + cell[1] : cell[1];
    return padding + row * row_slots_ + cell[0];
  }

  /// Calls `f(slot, cell)` for all cells of the box.
  template <class F>
  void for_each(F&& f) const {
    for (const Segment<D>& segment : segments) {
      auto cell = segment.cell;
      for (int i = 0; i < segment.count; ++i, ++cell[0]) f(segment.first + i, cell);
    }
  }

  template <class F>
  void for_each_interior(F&& f) const {
    for_each([&](std::int64_t s, const std::array<std::int32_t, D>& cell) {
      if (interior[s] != 0) f(s, cell);
    });
  }

  std::array<double, D> node(const std::array<std::int32_t, D>& cell) const {
    std::array<double, D> x;
    for (int i = 0; i < D; ++i) x[i] = (cell[i] + 0.5) * spacing;
    return x;
  }

  T spacing;
  std::int64_t slots;
  std::vector<Segment<D>> segments;
  Field<Mark> interior;
  std::vector<Kind> kind;
  std::vector<PackState> pack_state;

 private:
  static constexpr std::int64_t padding = 64;

  void add_row(int row) {
    std::array<std::int32_t, D> cell = {};
    cell[1] = row % cells_[1];
    if constexpr (D == 3) cell[2] = row / cells_[1];
    Segment<D> segment{padding + row * row_slots_, cells_[0], cell, {}};
    bool inner = true;
    for (int i = 1; i < D; ++i) inner = inner && cell[i] >= margin && cell[i] < cells_[i] - margin;
    for (int dz = D == 3 ? -3 : 0; dz <= (D == 3 ? 3 : 0); ++dz) {
      for (int dy = -3; dy <= 3; ++dy) {
        const std::int64_t offset = (dz * cells_[1] + dy) * row_slots_;
        segment.neighbour_row[row_index<D>(dy, dz)] = inner ? offset : 0;
      }
    }
    for (int x = 0; inner && x < cells_[0]; ++x) {
      if (x < margin || x >= cells_[0] - margin) continue;
      interior[segment.first + x] = 1;
      kind[segment.first + x] = Kind::interior;
    }
    for (int x = 0; inner && x < cells_[0]; x += pack) {
      const bool all = x >= margin && x + pack <= cells_[0] - margin;
      pack_state[(segment.first + x) / pack] = all ? PackState::all : PackState::some;
    }
    segments.push_back(segment);
  }

  std::array<int, D> cells_;
  std::int64_t row_slots_;
};

/// Fields of one state of a patch.
template <class T, int D>
struct State {
  explicit State(std::int64_t slots) : volume(slots, T(1)) {
    for (auto* fields : {&drift, &velocity}) {
      for (auto& field : *fields) field.assign(slots, T(0));
    }
    for (auto& field : material) field.assign(slots, T(0));
    for (auto& field : stress) field.assign(slots, T(0));
  }

  Evolving<T, D> evolving() { return view<T>(*this); }
  Evolving<const T, D> evolving() const { return view<const T>(*this); }

  std::array<T*, symmetric_components<D>> stress_fields() {
    std::array<T*, symmetric_components<D>> fields;
    for (std::size_t c = 0; c < fields.size(); ++c) fields[c] = stress[c].data();
    return fields;
  }
  std::array<const T*, symmetric_components<D>> stress_fields() const {
    std::array<const T*, symmetric_components<D>> fields;
    for (std::size_t c = 0; c < fields.size(); ++c) fields[c] = stress[c].data();
    return fields;
  }

  std::array<Field<T>, D> drift, velocity;
  Field<T> volume;
  std::array<Field<T>, material_components<D>> material;
  std::array<Field<T>, symmetric_components<D>> stress;

 private:
  template <class U, class Self>
  static Evolving<U, D> view(Self& self) {
    Evolving<U, D> q{};
    for (int i = 0; i < D; ++i) {
      q.drift[i] = self.drift[i].data();
      q.velocity[i] = self.velocity[i].data();
    }
    q.volume = self.volume.data();
    for (int c = 0; c < material_components<D>; ++c) q.material[c] = self.material[c].data();
    return q;
  }
};

/// Moves the particle of every slot by up to `amount` in every direction.
template <class T, std::size_t D>
void jitter(std::array<Field<T>, D>& drift, T amount, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<T> shift(-amount, amount);
  for (auto& field : drift) {
    for (T& xi : field) xi = shift(random);
  }
}

/// Lists of the lattice neighbours within `reach` cells, for every pack with interior particles,
/// padded with the particle itself.
template <int D>
struct BoxLists {
  template <class T>
  BoxLists(const Patch<T, D>& patch, int reach) {
    constexpr int pack = slots_per_pack;
    start.assign(patch.slots / pack, 0);
    length.assign(patch.slots / pack, 0);
    for (const Segment<D>& segment : patch.segments) {
      for (int i = 0; i < segment.count; i += pack) {
        const std::int64_t first = segment.first + i;
        if (!holds_interior(patch.pack_state[first / pack])) continue;
        start[first / pack] = static_cast<std::int64_t>(neighbour.size());
        for (int dz = D == 3 ? -reach : 0; dz <= (D == 3 ? reach : 0); ++dz) {
          for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
              add(patch, first, {dx, dy, dz}, segment.neighbour_row[row_index<D>(dy, dz)] + dx);
              ++length[first / pack];
            }
          }
        }
      }
    }
  }

  NeighbourLists<D> view() const {
    NeighbourLists<D> lists{start.data(), length.data(), neighbour.data(), {}};
    for (int i = 0; i < D; ++i) lists.offset[i] = offset[i].data();
    return lists;
  }

  template <class T>
  void add(const Patch<T, D>& patch, std::int64_t first, std::array<int, 3> cells,
           std::int64_t away) {
    for (int l = 0; l < slots_per_pack; ++l) {
      const bool real = patch.interior[first + l] != 0;
      neighbour.push_back(static_cast<std::int32_t>(first + l + (real ? away : 0)));
      for (int i = 0; i < D; ++i) offset[i].push_back(real ? cells[i] : 0);
    }
  }

  std::vector<std::int64_t> start;
  std::vector<std::int32_t> length, neighbour;
  std::array<std::vector<std::int32_t>, D> offset;
};

}  // namespace pliant::kernels::test
