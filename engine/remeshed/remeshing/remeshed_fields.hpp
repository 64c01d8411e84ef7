#pragma once

#include <vector>

#include "engine/case/case.hpp"
#include "engine/remeshed/remeshing/scatter_tile.hpp"
#include "scheduler/workers.hpp"

namespace pliant::remeshed {

/// Transfers the fields of a body to its new lattice: from `stage[0]` of the present slots to
/// `stage[1]` of the slots of `spare`. Each new block gathers from all present blocks near it into
/// a tile of its own nodes, so that blocks share nothing and sums have a fixed order.
template <class T, int D>
class RemeshedFields {
 public:
  RemeshedFields(const Case& settings, Body<T, D>& body,
                 const kernels::RemeshedTable<T, D>& kernels, scheduler::Workers& workers);

  /// Makes room for the slots of `spare`.
  void prepare();

  /// M4' sums (RP.31), (RP.32) and fields from them, (RP.33)-(RP.36).
  void scatter(int block, const std::vector<CellBounds<D>>& bounds);
  /// Slots beyond a period copy the fields and the validity one period away.
  void copy_images(int block);
  bool filters() const { return filter_strength_ > 0; }
  /// (RP.37), for every block before `swap_in_filtered`.
  void filter(int block);
  void swap_in_filtered();
  /// det F = rho0/rho, (RP.38).
  void match_volumes(int block);

  /// [new slot] 1 where remeshing has left a particle or ghost.
  T* valid() { return valid_; }

 private:
  void take_nodes(int block, ScatterTile<T, D>& tile);
  void take_memory(int block, ScatterTile<T, D>& tile, int first_term, int count);

  Body<T, D>& body_;
  const kernels::RemeshedTable<T, D>& kernels_;
  scheduler::Workers& workers_;
  double filter_strength_;
  bool conserves_volume_;
  T* inside_ = nullptr;                     ///< [new slot] 1 if also phi < 0
  T* valid_ = nullptr;                      ///< [new slot]
  std::vector<Buffer<T>> filtered_memory_;  ///< [Prony term]
  std::vector<ScatterTile<T, D>> tiles_;    ///< [worker]
};

extern template class RemeshedFields<double, 2>;
extern template class RemeshedFields<double, 3>;
extern template class RemeshedFields<float, 2>;
extern template class RemeshedFields<float, 3>;

}  // namespace pliant::remeshed
