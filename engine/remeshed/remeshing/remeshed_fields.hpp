#pragma once

#include <vector>

#include "engine/case/case.hpp"
#include "engine/remeshed/remeshing/scatter_tile.hpp"
#include "scheduler/workers.hpp"

namespace pliant::remeshed {

/// How the fields of a body cross to its new lattice: `stage[0]` of the present slots into
/// `stage[1]` of the slots of `spare`. Each new block gathers from all present blocks that come
/// near into a tile of its own nodes, so that blocks share nothing and sums keep one order.
template <class T, int D>
class RemeshedFields {
 public:
  RemeshedFields(const Case& settings, Body<T, D>& body,
                 const kernels::RemeshedTable<T, D>& kernels, scheduler::Workers& workers);

  /// Room for the slots of `spare`.
  void prepare();

  /// M4' sums (RP.31), (RP.32) and fields from them, (RP.33)-(RP.36).
  void scatter(int block, const std::vector<CellBounds<D>>& bounds);
  /// Slots beyond a period repeat the fields and the validity one period away.
  void copy_images(int block);
  bool filters() const { return filter_strength_ > 0; }
  /// (RP.37), of every block before `swap_in_filtered`.
  void filter(int block);
  void swap_in_filtered();
  /// det F = rho0/rho, (RP.38).
  void match_volumes(int block);

  /// [new slot] 1 where remeshing left a particle or ghost.
  T* valid() { return valid_; }

 private:
  void take_nodes(int block, ScatterTile<T, D>& tile);
  void take_memory(int block, ScatterTile<T, D>& tile, int first_term, int count);

  Body<T, D>& body_;
  const kernels::RemeshedTable<T, D>& kernels_;
  scheduler::Workers& workers_;
  double filter_strength_;
  bool conserves_volume_;
  T* inside_ = nullptr;                     ///< [new slot] 1 there where phi < 0
  T* valid_ = nullptr;                      ///< [new slot]
  std::vector<Buffer<T>> filtered_memory_;  ///< [Prony term]
  std::vector<ScatterTile<T, D>> tiles_;    ///< [worker]
};

extern template class RemeshedFields<double, 2>;
extern template class RemeshedFields<double, 3>;
extern template class RemeshedFields<float, 2>;
extern template class RemeshedFields<float, 3>;

}  // namespace pliant::remeshed
