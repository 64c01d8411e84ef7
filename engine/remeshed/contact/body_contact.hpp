#pragma once

#include <vector>

#include "engine/remeshed/contact/contact_search.hpp"
#include "engine/remeshed/state/state.hpp"
#include "kernels/remeshed/table.hpp"
#include "scheduler/phase.hpp"

// Bodies in contact.
//
//          body a         Each body keeps the ghosts of its own surface. Where the foot point of a
//     \___________/       ghost also lies on another body, the surface is not free: it carries the
//      g g x x g g        traction (RP.56) that two half spaces with the states of both bodies at
//         /-----\         that point would exert on each other (a Riemann problem). The ghost is
//          body b         then that of a loaded surface, (RP.57).
//
// The bodies share only that traction. Each has its own lattice, level set and particles and is
// remeshed by itself; materials never mix. A tied interface is the same, except that ghosts nearer
// to the other body are tied to it, whether the bodies press or not, and that what has parted
// returns.
//
// Each side computes tractions at its own foot points. Their effect on its particles is accurate to
// the order of the method, not to rounding. Therefore the momentum that crosses is computed once
// for each pair, as the mean of the two sides, (RP.68), and the momentum of each body is corrected
// to its budget: contact_momentum_correction.hpp.
namespace pliant::remeshed {

/// The contact phases of a step: search, and the tractions of each stage.
template <class T, int D>
class BodyContact {
 public:
  BodyContact(State<T, D>& state, const Case& settings,
              const kernels::RemeshedTable<T, D>& kernels);

  bool is_needed() const { return !contacts_.empty(); }

  /// Once per step: finds where bodies touch.
  void add_search(std::vector<scheduler::Phase>& phases) { search_.add_phases(phases); }
  /// Once per stage: computes the tractions there.
  void add_tractions(std::vector<scheduler::Phase>& phases, int stage);

  void prepare(double time_step);
  /// (RP.68): impulse of each contact on the second of its bodies in the step [N s], summed over
  /// the blocks in their order.
  const std::vector<Point<D>>& fold();
  /// (RP.99): energy lost to friction in the step [J], summed likewise.
  double lost_by_friction() const;

 private:
  /// The effect of a body on another one at a point of their common surface.
  struct Interaction {
    std::array<T, D> traction;
    double friction;  ///< power per area lost to friction, (RP.99) [W/m^2]
  };

  void find_tractions(int block, int stage);
  Interaction interaction(const Body<T, D>& own, const Body<T, D>& other,
                          const BlockGhosts<T, D>& ghosts, std::size_t point,
                          const ContactCase& contact, const ContactDirection<D>& direction) const;

  State<T, D>& state_;
  const std::vector<ContactCase>& contacts_;
  const kernels::RemeshedTable<T, D>& kernels_;
  ContactSearch<T, D> search_;
  double time_step_ = 0;
  std::vector<Point<D>> block_impulse_;  ///< [block][contact] on the second body in this step
  std::vector<double> block_friction_;   ///< [block] energy lost to friction in this step
  std::vector<Point<D>> impulse_;        ///< [contact]
};

extern template class BodyContact<double, 2>;
extern template class BodyContact<double, 3>;
extern template class BodyContact<float, 2>;
extern template class BodyContact<float, 3>;

}  // namespace pliant::remeshed
