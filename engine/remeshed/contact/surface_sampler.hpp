#pragma once

#include <vector>

#include "engine/remeshed/contact/surface_samples.hpp"
#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// Lists the surface particles and ghosts of bodies by position, at the start of each step:
/// particles of different bodies are no fixed neighbours of each other. In two phases:
///
///     samples   surface particles and ghosts of each block, with their positions
///     cells     those of a body in a cell list, if its box meets that of another
template <class T, int D>
class SurfaceSampler {
 public:
  SurfaceSampler(State<T, D>& state, const std::vector<ContactCase>& contacts);

  /// Makes room for the present blocks, before the phases run.
  void prepare() { samples_.resize(state_.blocks.size()); }
  void add_phases(std::vector<scheduler::Phase>& phases);
  /// [body]
  const std::vector<SurfaceSamples<D>>& surfaces() const { return surfaces_; }

 private:
  /// A surface particle with a record, or a ghost (record -1).
  struct Sample {
    Site<double, D> site;  ///< its label is the number among all samples of the body
    std::int32_t record;
    double level_set;       ///< [h]
    Point<D> gradient;      ///< of phi, (RP.61), of a particle
    Point<D> displacement;  ///< since t = 0 [m]
  };

  void find_samples(int block);
  void sort_samples();
  void gather(int body);
  bool are_near(const ContactCase& contact) const;

  State<T, D>& state_;
  const std::vector<ContactCase>& contacts_;
  std::vector<char> may_touch_;               ///< [body] whether a contact names it
  std::vector<std::vector<Sample>> samples_;  ///< [block]
  std::vector<SurfaceSamples<D>> surfaces_;   ///< [body]
};

extern template class SurfaceSampler<double, 2>;
extern template class SurfaceSampler<double, 3>;
extern template class SurfaceSampler<float, 2>;
extern template class SurfaceSampler<float, 3>;

}  // namespace pliant::remeshed
