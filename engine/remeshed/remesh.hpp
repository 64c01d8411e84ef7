#pragma once

#include <memory>
#include <vector>

#include "engine/remeshed/ghost_fill.hpp"
#include "engine/remeshed/ghost_fits.hpp"
#include "engine/remeshed/level_set.hpp"
#include "engine/remeshed/state.hpp"
#include "scheduler/phase.hpp"
#include "scheduler/workers.hpp"

namespace pliant::remeshed {

/// Moves one body's particles back onto its lattice: section 2.3 of H&K, (RP.21)-(RP.31).
///
/// Works in two parts, since the blocks of the new lattice are known only after the first:
/// `departure_phases` over the present blocks (ghosts take up mass, then the new layout is found),
/// and `arrival_phases` over the new ones (scatter, filter, level set, classification, ghost fits).
/// The result lies in `spare` and `stage[1]`; the particles themselves are untouched until
/// `commit`.
template <class T, int D>
class Remeshing {
 public:
  Remeshing(const Case& settings, Body<T, D>& body, const Boundaries<D>& boundaries,
            const kernels::Table<T, D>& kernels, scheduler::Workers& workers);

  /// Cells to each side that blocks can reach: a ghost, its foot point, its widest fit.
  static constexpr int block_reach = 10;
  /// Cells around interior particles that have slots: the ghost band, one cell that the surface may
  /// have moved, and one for the differences at its rim.
  static constexpr int layout_reach = 6;

  /// Lays the initial particles out; `arrival_phases(false)` then completes them.
  void place_initial(const Case& settings, const BodyCase& source);

  void departure_phases(std::vector<scheduler::Phase>& phases, int first_block);
  /// `from_particles` is false when the new fields are the initial ones: no scatter, no filter.
  void arrival_phases(std::vector<scheduler::Phase>& phases, int first_block, bool from_particles);

  /// Between the two: whether the level set is due to be reinitialised, and whether `commit` will
  /// follow. Only then are ghosts fitted, in the place of the present ones.
  void prepare_arrival(bool reinitialise, bool is_final);
  void commit();
  /// From a checkpoint: the layout first, and what follows from kinds and fits once they are read.
  void lay_out_again(const std::vector<std::int32_t>& occupancy);
  void adopt_restored();

  bool has_surface() const { return has_surface_; }

 private:
  struct Bounds {
    Cell<D> lower, upper;
  };
  void find_bounds(int block);
  void lay_out();
  void prepare_spare();
  void borrow_arrays();
  void grow_stages();
  void scatter(int block);
  /// Nodes of a new block, with the sums of (RP.22). Every worker has one.
  struct Tile {
    Buffer<T> nodes;
    std::vector<kernels::NodeRow> rows;  ///< [z][y] of the box around the block
    std::int64_t count = 0;              ///< nodes
    int width = 0;                       ///< values of a node
    Cell<D> lower, extent;

    kernels::NodeRow& row(const Cell<D>& cell) {
      std::size_t at = 0;
      for (int a = D - 1; a > 0; --a) at = at * extent[a] + (cell[a] - lower[a]);
      return rows[at];
    }
    const T* node(const Cell<D>& cell) {
      const kernels::NodeRow& own = row(cell);
      return nodes.get() + (own.first + cell[0] - lower[0] - own.begin) * width;
    }
  };
  /// Fields that take the place of S or F in the sums.
  struct MaterialFields {
    int count;
    std::array<const T*, kernels::material_components<D>> field;
  };
  void lay_tile_out(int block, Tile& tile) const;
  void fill_tile(Tile& tile, const MaterialFields& material);
  void add_source(int block, Tile& tile, const MaterialFields& material);
  void take_nodes(int block, Tile& tile);
  void take_memory(int block, Tile& tile, int first_term, int count);
  void match_volumes(int block);
  void filter(int block);
  void adopt_filtered();
  void copy_images(int block);
  void extend_level_set(int block);
  void find_closest_points(int block);
  void find_kinds(int block);
  void fit_block(int block);
  void list_surface(int block);
  void number_all();
  void resolve_block(int block);

  Body<T, D>& body_;
  const Boundaries<D>& boundaries_;
  const kernels::Table<T, D>& kernels_;
  scheduler::Workers& workers_;
  GhostTreatment treatment_;
  int stencil_reach_;
  bool is_final_ = true;
  double filter_strength_;
  bool extensive_;
  bool has_surface_ = true;
  bool reinitialise_ = false;
  Occupancy<D> occupancy_;
  LevelSet<T, D> level_set_;
  std::vector<Bounds> bounds_;              ///< [present block] cells of its particles
  std::vector<std::int64_t> particles_;     ///< [new block]
  T* inside_ = nullptr;                     ///< [new slot] 1 there where phi < 0
  T* valid_ = nullptr;                      ///< [new slot] 1 where remeshing left a particle
  std::vector<Buffer<T>> filtered_memory_;  ///< [Prony term]
  std::vector<Tile> tiles_;                 ///< [worker]
};

extern template class Remeshing<double, 2>;
extern template class Remeshing<double, 3>;

}  // namespace pliant::remeshed
