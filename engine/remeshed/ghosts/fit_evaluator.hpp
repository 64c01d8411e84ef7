#pragma once

#include <array>

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Evaluates the fits of single ghosts of a block from the present records.
template <class T, int D>
class FitEvaluator {
 public:
  FitEvaluator(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
               const kernels::RemeshedTable<T, D>& kernels)
      : body_(body), ghosts_(ghosts), kernels_(kernels) {}

  /// Valid until the next call.
  kernels::GhostFits<T, D> of(std::size_t ghost) {
    kernels_.sum_ghosts(ghosts_.sums(ghost, 1, body_, sums_.data()));
    return ghosts_.fits(ghost, sums_.data());
  }

 private:
  const Body<T, D>& body_;
  const BlockGhosts<T, D>& ghosts_;
  const kernels::RemeshedTable<T, D>& kernels_;
  alignas(64) std::array<T, BlockGhosts<T, D>::sums_of_ghost> sums_;
};

}  // namespace pliant::remeshed
