#pragma once

#include <memory>
#include <vector>

#include "engine/lattice/layout_blocks.hpp"
#include "engine/remeshed/remeshing/remesh.hpp"
#include "engine/remeshed/state/state.hpp"
#include "scheduler/workers.hpp"

namespace pliant::remeshed {

/// The remeshings of all bodies, with their blocks in one numbering.
template <class T, int D>
class Remeshings {
 public:
  Remeshings(const Case& settings, State<T, D>& state, const kernels::RemeshedTable<T, D>& kernels,
             scheduler::Workers& workers, Outside outside);

  /// Puts the particles of all bodies on their lattices at t = 0.
  void place_initial();

  /// See Remeshing.
  std::vector<scheduler::Phase> source_phases();
  std::vector<scheduler::Phase> target_phases(bool from_particles);
  void prepare_target(bool reinitialise, bool is_final);
  void commit();

  /// Layouts of the present slots, and of the new lattices.
  const Layouts<D>& layouts() const { return layouts_; }
  const Layouts<D>& new_layouts() const { return new_layouts_; }
  Remeshing<T, D>& operator[](std::size_t body) { return *of_body_[body]; }

 private:
  const Case& settings_;
  scheduler::Workers& workers_;
  Layouts<D> layouts_, new_layouts_;
  std::vector<std::unique_ptr<Remeshing<T, D>>> of_body_;
};

extern template class Remeshings<double, 2>;
extern template class Remeshings<double, 3>;
extern template class Remeshings<float, 2>;
extern template class Remeshings<float, 3>;

}  // namespace pliant::remeshed
