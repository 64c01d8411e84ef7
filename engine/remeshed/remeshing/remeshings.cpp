#include "engine/remeshed/remeshing/remeshings.hpp"

#include "engine/remeshed/state/resources.hpp"
#include "scheduler/step_graph.hpp"

namespace pliant::remeshed {

template <class T, int D>
Remeshings<T, D>::Remeshings(const Case& settings, State<T, D>& state,
                             const kernels::RemeshedTable<T, D>& kernels,
                             scheduler::Workers& workers, Outside outside)
    : settings_(settings), workers_(workers) {
  for (Body<T, D>& body : state.bodies) {
    layouts_.push_back(&body.population.layout);
    new_layouts_.push_back(&body.spare.layout);
    of_body_.push_back(std::make_unique<Remeshing<T, D>>(settings, body, state.boundaries, kernels,
                                                         workers, outside));
  }
}

template <class T, int D>
void Remeshings<T, D>::place_initial() {
  for (auto& remeshing : of_body_) {
    remeshing->place_initial(settings_);
    remeshing->prepare_target(false, true);
  }
  scheduler::StepGraph initial(target_phases(false), connect_blocks<D>(new_layouts_, 0),
                               resource::names());
  initial.run(workers_);
  commit();
}

template <class T, int D>
std::vector<scheduler::Phase> Remeshings<T, D>::source_phases() {
  std::vector<scheduler::Phase> phases;
  int first = 0;
  for (std::size_t b = 0; b < of_body_.size(); ++b) {
    of_body_[b]->source_phases(phases, first);
    first += static_cast<int>(layouts_[b]->blocks().size());
  }
  return phases;
}

template <class T, int D>
std::vector<scheduler::Phase> Remeshings<T, D>::target_phases(bool from_particles) {
  std::vector<scheduler::Phase> phases;
  int first = 0;
  for (std::size_t b = 0; b < of_body_.size(); ++b) {
    of_body_[b]->target_phases(phases, first, from_particles);
    first += static_cast<int>(new_layouts_[b]->blocks().size());
  }
  return phases;
}

template <class T, int D>
void Remeshings<T, D>::prepare_target(bool reinitialise, bool is_final) {
  for (auto& remeshing : of_body_) remeshing->prepare_target(reinitialise, is_final);
}

template <class T, int D>
void Remeshings<T, D>::commit() {
  for (auto& remeshing : of_body_) remeshing->commit();
}

template class Remeshings<double, 2>;
template class Remeshings<double, 3>;
template class Remeshings<float, 2>;
template class Remeshings<float, 3>;

}  // namespace pliant::remeshed
