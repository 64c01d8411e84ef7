#pragma once

#include <vector>

#include "engine/blocks/numbering.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

/// The results of blocks in their last stage, combined in the order of the blocks.
class StageResults {
 public:
  /// Resets to one result for each block of `body_count` bodies, as at rest.
  void reset(const std::vector<BlockOwner>& owners, std::size_t body_count);
  kernels::StageResult& operator[](int block) { return of_block_[block]; }

  void fold(const std::vector<BlockOwner>& owners);
  /// Largest values over all blocks, and the first slot that is not finite.
  const kernels::StageResult& total() const { return total_; }
  /// The block of that slot, or -1.
  int failed_block() const { return failed_block_; }
  /// max abs(eps)_F of one body [1/s].
  double strain_rate(std::size_t body) const { return strain_rates_[body]; }

 private:
  std::vector<kernels::StageResult> of_block_;
  kernels::StageResult total_;
  std::vector<double> strain_rates_;  ///< [body]
  int failed_block_ = -1;
};

}  // namespace pliant::remeshed
