#pragma once

#include <cstddef>
#include <vector>

#include "engine/storage/buffer.hpp"
#include "engine/undeformed/listed_arrays.hpp"
#include "kernels/bulk_relaxation.hpp"

namespace pliant::undeformed {

/// The arrays of the p_i of (RP.10) of a body, [term], and of J - 1.
template <class T>
struct BulkArrays {
  std::vector<Buffer<T>>& pressure;
  Buffer<T>& volume_change;
};

/// The p_i of a body as kernels read them.
template <class T>
class BulkMemory {
 public:
  explicit BulkMemory(const std::vector<kernels::PronyTerm<double>>& prony)
      : prony_(&prony), relaxation_(prony.size()) {}

  /// For the stress `age` [s] after the last one, with the instantaneous modulus K0. The new arrays
  /// may be the old ones.
  void prepare(double age, T modulus, BulkArrays<T> last, BulkArrays<T> next) {
    for (std::size_t i = 0; i < relaxation_.size(); ++i) {
      const kernels::PronyTerm<double>& term = (*prony_)[i];
      relaxation_[i] = kernels::relaxation<T>(
          {static_cast<T>(term.ratio), static_cast<T>(term.time)}, modulus, age);
    }
    list_arrays(last.pressure, pressure_);
    list_arrays(next.pressure, next_pressure_);
    volume_change_ = last.volume_change.get();
    next_volume_change_ = next.volume_change.get();
  }

  kernels::BulkRelaxation<T> relaxation() const {
    return {static_cast<int>(relaxation_.size()),
            relaxation_.data(),
            pressure_.data(),
            next_pressure_.data(),
            volume_change_,
            next_volume_change_};
  }

 private:
  const std::vector<kernels::PronyTerm<double>>* prony_;
  std::vector<kernels::Relaxation<T>> relaxation_;  ///< [term]
  std::vector<T*> pressure_, next_pressure_;        ///< [term]
  T* volume_change_ = nullptr;
  T* next_volume_change_ = nullptr;
};

}  // namespace pliant::undeformed
