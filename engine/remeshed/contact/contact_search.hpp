#pragma once

#include <vector>

#include "engine/remeshed/contact/surface_samples.hpp"
#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

template <class T, int D>
class OpposingFit;

/// Finds where bodies touch, (RP.58), at the start of each step. Particles of different bodies are
/// no fixed neighbours of each other, so they are found by position, in three phases:
///
///     samples   surface particles and ghosts of each block, with their positions
///     cells     those of a body in a cell list, if its box meets that of another
///     points    ghosts whose foot point lies on another body, and the fit of that body
template <class T, int D>
class ContactSearch {
 public:
  ContactSearch(State<T, D>& state, const std::vector<ContactCase>& contacts);

  /// Makes room for the present blocks, before the phases run.
  void prepare() { samples_.resize(state_.blocks.size()); }
  void add_phases(std::vector<scheduler::Phase>& phases);

 private:
  /// A surface particle with a record, or a ghost (record -1).
  struct Sample {
    Site<double, D> site;  ///< its label is the number among all samples of the body
    std::int32_t record;
    double level_set;  ///< [h]
  };

  struct GhostPlace {
    Point<D> position, foot;  ///< [m]
    double distance;          ///< from the surface of its body [h]
  };

  void find_samples(int block);
  void sort_samples();
  void gather(int body);
  bool are_near(const ContactCase& contact) const;
  int other_body(int contact, int body) const {
    const std::array<int, 2>& pair = contacts_[contact].bodies;
    return pair[0] == body ? pair[1] : pair[0];
  }
  void find_contact_points(int block);
  bool may_be_in_contact(int owner, const BlockGhosts<T, D>& ghosts, std::int32_t ghost) const;
  double contact_gap(int contact, int owner, const GhostPlace& ghost,
                     OpposingFit<T, D>& opposing) const;
  void find_contact_point(int owner, BlockGhosts<T, D>& ghosts, std::int32_t ghost,
                          OpposingFit<T, D>& opposing) const;
  Point<D> foot_point(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                      std::int32_t ghost) const;

  State<T, D>& state_;
  const std::vector<ContactCase>& contacts_;
  std::vector<std::vector<int>> contacts_of_;  ///< [body] contacts of the body
  std::vector<std::vector<Sample>> samples_;   ///< [block]
  std::vector<SurfaceSamples<D>> surfaces_;    ///< [body]
};

extern template class ContactSearch<double, 2>;
extern template class ContactSearch<double, 3>;
extern template class ContactSearch<float, 2>;
extern template class ContactSearch<float, 3>;

}  // namespace pliant::remeshed
