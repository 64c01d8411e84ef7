#include "engine/finite_elements/measure.hpp"

#include <Eigen/Dense>

#include "engine/method/bulk_history.hpp"
#include "engine/method/initial_stress.hpp"
#include "engine/point_based/forces/node_state.hpp"

namespace pliant::finite_elements {

namespace {

template <int D>
using Matrix = Eigen::Matrix<double, D, D, Eigen::RowMajor>;

/// F of (FE.1).
template <class T, int D>
Matrix<D> gradient_of(const point_based::Body<T, D>& body, const Elements<T, D>& elements,
                      std::int64_t element) {
  Matrix<D> f = Matrix<D>::Identity();
  const auto& slots = elements.slots[element];
  for (int a = 1; a <= D; ++a) {
    for (int i = 0; i < D; ++i) {
      const double d =
          static_cast<double>(body.displacement[i][slots[a]]) - body.displacement[i][slots[0]];
      for (int j = 0; j < D; ++j) f(i, j) += d * elements.gradient(element, a, j);
    }
  }
  return f;
}

/// theta of (FE.3).
template <int D>
double dilatation(kernels::ElasticLaw law, const Matrix<D>& f) {
  if (law == kernels::ElasticLaw::st_venant_kirchhoff) {
    return ((f.transpose() * f).trace() - D) / 2;
  }
  return f.determinant() - 1;
}

}  // namespace

// psi without Lambda theta^2/2 over the elements, plus that term over the nodes if they average it.
template <class T, int D>
void Measurer<T, D>::add_strain(int index, BodyIntegrals& sum) const {
  const point_based::Body<T, D>& body = state_.bodies[index];
  const Elements<T, D>& elements = state_.elements[index];
  const double modulus = elements.volumetric_modulus;
  std::vector<double> collected(elements.averages() ? body.slots : 0, 0.);
  for (std::int64_t e = 0; e < static_cast<std::int64_t>(elements.slots.size()); ++e) {
    const double volume = elements.volume(e);
    if (volume == 0) continue;
    const Matrix<D> f = gradient_of(body, elements, e);
    const double theta = dilatation<D>(body.material.law, f);
    std::array<double, D * D> row_by_row;
    std::copy_n(f.data(), D * D, row_by_row.begin());
    sum.volume += volume * f.determinant();
    sum.strain_energy += volume * point_based::strain_energy_density(body, row_by_row);
    if (elements.is_prestressed()) {
      sum.strain_energy += volume * ConstantStress<D>(elements.prestress(e), row_by_row, 1).energy;
    }
    if (!elements.averages()) continue;
    sum.strain_energy -= volume * modulus / 2 * theta * theta;
    for (const std::int32_t slot : elements.slots[e]) collected[slot] += volume * theta / (D + 1);
  }
  if (!elements.averages()) return;
  const BulkHistory<T> history = {body.prony, body.memory_pressure, body.volume_change, modulus,
                                  body.memory_age};
  body.for_each_node([&](std::int64_t slot) {
    const double theta = collected[slot] / body.volume[slot];
    const double relaxed = relaxed_pressure(history, slot, theta).energy;
    sum.strain_energy += body.volume[slot] * (modulus / 2 * theta * theta + relaxed);
  });
}

template class Measurer<double, 2>;
template class Measurer<double, 3>;
template class Measurer<float, 2>;
template class Measurer<float, 3>;

}  // namespace pliant::finite_elements
