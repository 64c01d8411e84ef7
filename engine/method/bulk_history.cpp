#include "engine/method/bulk_history.hpp"

#include "kernels/remeshed/stage/relaxation.hpp"

namespace pliant {

template <class T>
RelaxedPressure relaxed_pressure(const BulkHistory<T>& history, std::int64_t slot,
                                 double volume_change) {
  RelaxedPressure sum;
  for (std::size_t i = 0; i < history.prony.size(); ++i) {
    const kernels::PronyTerm<double>& term = history.prony[i];
    const auto relaxation = kernels::relaxation<double>(term, history.modulus, history.age);
    const double p = relaxation.decay * history.pressure[i][slot] +
                     relaxation.start * history.volume_change[slot] +
                     relaxation.end * volume_change;
    sum.pressure += p;
    sum.energy += kernels::relaxed_energy<double>(term, history.modulus, p, volume_change);
  }
  return sum;
}

template RelaxedPressure relaxed_pressure(const BulkHistory<double>&, std::int64_t, double);
template RelaxedPressure relaxed_pressure(const BulkHistory<float>&, std::int64_t, double);

}  // namespace pliant
