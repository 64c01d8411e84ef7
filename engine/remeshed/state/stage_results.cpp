#include "engine/remeshed/state/stage_results.hpp"

#include <algorithm>

namespace pliant::remeshed {

void StageResults::reset(const std::vector<BlockOwner>& owners, std::size_t body_count) {
  of_block_.assign(owners.size(), {});
  strain_rates_.resize(body_count);
}

void StageResults::fold(const std::vector<BlockOwner>& owners) {
  total_ = {};
  failed_block_ = -1;
  std::fill(strain_rates_.begin(), strain_rates_.end(), 0);
  for (std::size_t b = 0; b < of_block_.size(); ++b) {
    const kernels::StageResult& result = of_block_[b];
    total_.strain_rate = std::max(total_.strain_rate, result.strain_rate);
    total_.deformation = std::max(total_.deformation, result.deformation);
    total_.wave_speed = std::max(total_.wave_speed, result.wave_speed);
    double& of_body = strain_rates_[owners[b].body];
    of_body = std::max(of_body, result.strain_rate);
    if (result.non_finite >= 0 && failed_block_ < 0) {
      total_.non_finite = result.non_finite;
      failed_block_ = static_cast<int>(b);
    }
  }
}

}  // namespace pliant::remeshed
