#pragma once

#include <cstddef>
#include <vector>

#include "engine/method/hyperelastic.hpp"
#include "engine/storage/buffer.hpp"
#include "engine/undeformed/listed_arrays.hpp"
#include "kernels/networks.hpp"

namespace pliant::undeformed {

/// The arrays of the networks (TL.24) of a body: [tensor * network_components + component].
template <class T>
using NetworkArrays = std::vector<Buffer<T>>;

/// The number of these arrays.
template <int D>
std::size_t network_arrays(std::size_t terms) {
  return terms == 0 ? 0 : (terms + 1) * kernels::network_components<D>;
}

/// The networks of a body as kernels read them.
template <class T>
class NetworkMemory {
 public:
  explicit NetworkMemory(const std::vector<kernels::PronyTerm<double>>& prony_shear)
      : prony_shear_(&prony_shear), relaxation_(prony_shear.size()) {
    const double lasting = long_term_share(prony_shear);
    for (const kernels::PronyTerm<double>& term : prony_shear) {
      ratio_.push_back(static_cast<T>(term.ratio / lasting));
    }
  }

  /// For the stress `age` [s] after the last one. The new tensors may replace the old ones.
  void prepare(double age, NetworkArrays<T>& tensor, NetworkArrays<T>& next_tensor) {
    for (std::size_t i = 0; i < relaxation_.size(); ++i) {
      relaxation_[i] = kernels::relaxation<T>({1, static_cast<T>((*prony_shear_)[i].time)}, 1, age);
    }
    list_arrays(tensor, tensor_);
    list_arrays(next_tensor, next_tensor_);
  }

  kernels::Networks<T> networks() const {
    return {static_cast<int>(ratio_.size()), relaxation_.data(), ratio_.data(), tensor_.data(),
            next_tensor_.data()};
  }

 private:
  const std::vector<kernels::PronyTerm<double>>* prony_shear_;
  std::vector<kernels::Relaxation<T>> relaxation_;  ///< [term]
  std::vector<T> ratio_;                            ///< [term]
  std::vector<T*> tensor_, next_tensor_;            ///< as NetworkArrays
};

}  // namespace pliant::undeformed
