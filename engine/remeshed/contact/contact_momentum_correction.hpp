#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/remeshed/contact/crossing_momentum.hpp"
#include "engine/remeshed/state/particle_momentum.hpp"
#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

// The momentum budget of bodies in contact.
//
// Neither a step nor a remeshing conserves the momentum of a body to rounding. The sum of div sigma
// over fitted ghosts equals the surface traction only to the accuracy of the method, and a
// remeshing changes which nodes are inside and their masses. Both errors are some tenths of a
// percent of the momenta involved and vanish with h. But those of two bodies do not cancel, nor do
// those on the two sides of a contact that moves along a wall. Therefore each body in a case with
// contact has a momentum budget. It changes only by the impulses of contacts, (RP.68), of body
// forces, (RP.71), and of friction on contact walls, (RP.98); that of a contact is one number,
// added to one body and subtracted from the other. Where one of the two is held, that number is
// what the momentum of the free one shows, (RP.104). After each step and each remeshing, one small
// velocity is added to all particles of a body, so that their mean velocity is that of the budget,
// (RP.69). This does not change strain, stress or relative motion.
//
// The impulses of walls and loads are known only to the order of the method. The budget takes this
// part of the momentum from the particles: all of it if a wall holds the body or a load acts on it,
// the part along the normal if the body may press on a contact wall. Along a plane wall, a sliding
// body loses what Coulomb's law gives; for a sticking body, only the particles know the force that
// holds it.
//
// The mass of a body in its budget is that at t = 0, whatever the sum of its particle masses: the
// method uses densities, which do not depend on a common factor of the masses.
namespace pliant::remeshed {

/// Corrects the mean velocities of the bodies of a case with contact after each step, (RP.69).
template <class T, int D>
class ContactMomentumCorrection {
 public:
  ContactMomentumCorrection(State<T, D>& state, const Case& settings);

  bool is_needed() const { return !state_.momentum_budgets.empty(); }

  /// Sets the momentum budgets at t = 0.
  void open();

  /// Impulses of one step [N s].
  struct Impulses {
    const std::vector<Point<D>>& of_contacts;     ///< [contact] on its second body
    const std::vector<Point<D>>& of_body_forces;  ///< [block]
    const std::vector<Point<D>>& of_walls;        ///< [block][wall]
    const std::vector<char>& sticks;              ///< [block] to a contact wall
  };
  /// Phases that correct the particles of each body to the momentum of its budget. `impulses`
  /// returns those of the step, if there was one.
  void add_phases(std::vector<scheduler::Phase>& phases, std::function<Impulses()> impulses);

 private:
  struct Sum : ParticleMomentum<D> {
    bool is_held = false;                   ///< by a wall or a load, whose impulse is in no budget
    std::array<double, D* D> normals = {};  ///< sum of n n of contact walls
  };
  void sum(int block);
  void add_impulses(const Impulses& impulses);
  void find_gains();
  void add_friction(const Impulses& impulses);
  void fold_blocks();
  void balance();
  void shift(int block);

  State<T, D>& state_;
  const std::vector<ContactCase>& contacts_;
  std::vector<Sum> sums_;               ///< [block]
  std::vector<Sum> of_body_;            ///< [body]
  std::vector<MomentumGain<D>> gains_;  ///< [body]
  std::vector<Point<D>> crossed_;       ///< [contact] impulse on its second body [N s]
  std::vector<Point<D>> shift_;         ///< [body] [m/s]
};

/// (RP.69) for one body, from its particles [N s]; the body must have a momentum budget.
template <class T, int D>
Point<D> budget_momentum(const State<T, D>& state, int body);

extern template class ContactMomentumCorrection<double, 2>;
extern template class ContactMomentumCorrection<double, 3>;
extern template class ContactMomentumCorrection<float, 2>;
extern template class ContactMomentumCorrection<float, 3>;

}  // namespace pliant::remeshed
