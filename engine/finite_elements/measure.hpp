#pragma once

#include "engine/finite_elements/state.hpp"
#include "engine/point_based/observe/measure.hpp"

namespace pliant::finite_elements {

/// Evaluates measurements of a state at one time: volume and strain energy of the elements, all
/// others of the nodes.
template <class T, int D>
class Measurer final : public point_based::Measurer<T, D> {
 public:
  explicit Measurer(const State<T, D>& state) : point_based::Measurer<T, D>(state), state_(state) {}

 private:
  void add_strain(int body, BodyIntegrals& sum) const override;

  const State<T, D>& state_;
};

extern template class Measurer<double, 2>;
extern template class Measurer<double, 3>;
extern template class Measurer<float, 2>;
extern template class Measurer<float, 3>;

}  // namespace pliant::finite_elements
