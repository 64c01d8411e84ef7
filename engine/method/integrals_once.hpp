#pragma once

#include <algorithm>
#include <deque>

#include "engine/method/body_integrals.hpp"

namespace pliant {

/// The integrals of bodies at one time, each computed once for all measurements that need it.
class IntegralsOnce {
 public:
  /// Integrals of a body, with the angular momentum about `about`, from `integrate()` when they
  /// are first needed. The reference stays valid.
  template <class Integrate>
  const BodyIntegrals& of(int body, const Vector& about, Integrate&& integrate) {
    const auto known = std::ranges::find_if(
        known_, [&](const Known& one) { return one.body == body && one.about == about; });
    if (known != known_.end()) return known->sum;
    return known_.emplace_back(Known{body, about, integrate()}).sum;
  }

 private:
  struct Known {
    int body;
    Vector about;
    BodyIntegrals sum;
  };

  std::deque<Known> known_;
};

}  // namespace pliant
