#include "engine/finite_elements/solver.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/checks/stability.hpp"
#include "engine/finite_elements/parameters.hpp"
#include "engine/finite_elements/setup.hpp"
#include "engine/point_based/setup.hpp"

namespace pliant::finite_elements {

namespace {

/// Nodes move like those of the point-based method, with the parameters of this one.
Case with_keys_of_nodes(Case a_case) {
  const Parameters given = parameters_of(a_case);
  auto& of_nodes = a_case.parameters.as<point_based::Parameters>();
  of_nodes = {};
  of_nodes.integrator = given.integrator;
  of_nodes.damping = given.damping;
  return a_case;
}

}  // namespace

template <class T, int D>
Solver<T, D>::Solver(const Case& a_case, const SolverOptions& options)
    : Base(with_keys_of_nodes(a_case), options) {
  State<T, D>& state = this->state();
  state.elements.resize(state.bodies.size());
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    make_body(this->settings(), this->settings().bodies[b], state.boundaries, state.bodies[b],
              state.elements[b]);
    highest_frequency_ = std::max(highest_frequency_, state.elements[b].highest_frequency);
  }
  state.clock.damping = parameters_of(this->settings()).damping.value_or(0);
  const scheduler::Blocks blocks = point_based::number_blocks<T, D>(state);
  this->set_step(std::make_unique<Step<T, D>>(state, this->settings(), options.isa), blocks);
}

template <class T, int D>
double Solver<T, D>::automatic_step() const {
  return cfl_number(this->settings()) * 2 / highest_frequency_;
}

template <class T, int D>
StepFailure Solver<T, D>::failure(const undeformed::StepResult& result) const {
  const auto& body = this->state().bodies[this->state().blocks[result.failed_block].body];
  return failed_step(
      this->settings(), this->clock(),
      fmt::format("an element of body `{}` at the node that began at {} is no longer finite or has "
                  "turned inside out",
                  body.name, coordinates<D>(body.start[result.non_finite])),
      {smaller_step(this->settings()), "load more slowly", "use a mesh without flat elements"});
}

template <class T, int D>
std::size_t Solver<T, D>::bytes() const {
  std::size_t sum = Base::bytes();
  for (const Elements<T, D>& elements : this->state().elements) sum += elements.bytes();
  return sum;
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::finite_elements
