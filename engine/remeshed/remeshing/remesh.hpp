#pragma once

#include <vector>

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/ghosts/ghost_fill.hpp"
#include "engine/remeshed/ghosts/ghost_fits.hpp"
#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/remeshing/layout_search.hpp"
#include "engine/remeshed/remeshing/remeshed_fields.hpp"
#include "engine/remeshed/setup/particle_kinds.hpp"
#include "engine/remeshed/state/lattice_view.hpp"
#include "engine/remeshed/state/state.hpp"
#include "scheduler/workers.hpp"

namespace pliant::remeshed {

/// Moves the particles of one body back onto its lattice: section 2.3 of H&K, (RP.31)-(RP.42).
///
/// It has two parts, since the blocks of the new lattice are known only after the first:
/// `source_phases` over the present blocks (ghosts take conserved quantities, then the new layout
/// is found), and `target_phases` over the new ones (scatter, filter, level set, classification,
/// ghost fits). The result is in `spare` and `stage[1]`; the particles do not change until
/// `commit`.
template <class T, int D>
class Remeshing {
 public:
  Remeshing(const Case& settings, Body<T, D>& body, const Boundaries<D>& boundaries,
            const kernels::RemeshedTable<T, D>& kernels, scheduler::Workers& workers,
            Outside outside);

  /// Sets the layout of the initial particles; `target_phases(false)` then completes them.
  void place_initial(const Case& settings);

  void source_phases(std::vector<scheduler::Phase>& phases, int first_block);
  /// `from_particles` is false if the new fields are the initial ones: no scatter, no filter.
  void target_phases(std::vector<scheduler::Phase>& phases, int first_block, bool from_particles);

  /// Between the two parts: false if the particles are too far apart for a lattice.
  bool has_layout() const { return has_layout_; }
  /// Between the two parts: sets whether the level set is to be reinitialised, and whether `commit`
  /// will follow. Only then are ghosts fitted; they replace the present ones.
  void prepare_target(bool reinitialise, bool is_final);
  void commit();
  /// From a checkpoint: first the layout, then what follows from kinds and fits after these are
  /// read.
  void lay_out_again(const std::vector<std::int32_t>& occupancy);
  void swap_in_restored();

 private:
  void add_fields(PhaseRows& rows);
  void add_initial_surface(PhaseRows& rows);
  void add_level_set(PhaseRows& rows);
  void add_first_order_passes(PhaseRows& rows);
  void add_ghosts(PhaseRows& rows);
  void add_loads(PhaseRows& rows);

  void prepare_spare();
  void share_with_level_set();
  void find_kinds(int block);
  void find_facets(const LatticeView<T, D>& view, int block);
  void fit_block(int block);
  void grow_stages();

  Body<T, D>& body_;
  Shape initial_surface_;
  const Boundaries<D>& boundaries_;
  const kernels::RemeshedTable<T, D>& kernels_;
  Parameters parameters_;
  GhostTreatment treatment_;
  int stencil_reach_;
  Outside outside_;
  bool is_final_ = true;
  bool has_layout_ = true;
  bool reinitialise_ = false;
  LayoutSearch<T, D> layout_search_;
  RemeshedFields<T, D> fields_;
  LevelSet<T, D> level_set_;
  std::vector<std::int64_t> particles_;         ///< [new block]
  std::vector<std::vector<Point<D>>> corners_;  ///< [new block] re-entrant corners
  ReentrantCorners<D> all_corners_;
};

extern template class Remeshing<double, 2>;
extern template class Remeshing<double, 3>;
extern template class Remeshing<float, 2>;
extern template class Remeshing<float, 3>;

}  // namespace pliant::remeshed
