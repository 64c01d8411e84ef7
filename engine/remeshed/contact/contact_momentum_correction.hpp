#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

// The momentum budget of bodies in contact.
//
// Neither a step nor a remeshing conserves the momentum of a body to rounding: div sigma over
// fitted ghosts adds up to the surface traction only as far as the method is accurate, and a
// remeshing changes which nodes are inside and what they weigh. Both errors are those of the
// method, some tenths of a percent of what the body is doing, and vanish with h; but nothing makes
// those of two bodies cancel, nor those on the two sides of a contact that moves along a wall. Each
// body of a case with contact therefore has a momentum budget, which changes by the impulses of
// contacts, (RP.68), of body forces, (RP.71), and of friction on contact walls, (RP.98), alone: the
// first is one number, added to one body and taken from the other. After each step and each
// remeshing one small velocity is added to all particles of a body, so that their mean velocity is
// that of the budget, (RP.69). This changes no strain, no stress and no relative motion.
//
// What walls and loads push is known to the order of the method only. The budget takes that part
// from the particles: all of it where a wall holds the body or a load acts on it, the part along
// the normal where the body may press on a contact wall. Along a plane wall a body that slides
// loses what Coulomb's law takes; what holds a body that sticks is known from the particles alone.
//
// The mass of a body in its budget is that at t = 0, whatever the masses of its particles add up
// to: the method reads densities, which a common factor of masses does not change.
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
  /// Phases that give the particles of each body the momentum of its budget; `impulses` finds those
  /// of the step, if there was one.
  void add_phases(std::vector<scheduler::Phase>& phases, std::function<Impulses()> impulses);

 private:
  struct Sum {
    double mass = 0;
    Point<D> momentum = {};
    bool is_held = false;  ///< by a wall or a load, whose impulse no budget contains
    std::array<double, D* D> normals = {};  ///< sum of n n of contact walls
  };
  void sum(int block);
  void add_impulses(const Impulses& impulses);
  void add_friction(const Impulses& impulses);
  void fold_blocks();
  void balance();
  void shift(int block);

  State<T, D>& state_;
  const std::vector<ContactCase>& contacts_;
  std::vector<Sum> sums_;        ///< [block]
  std::vector<Sum> of_body_;     ///< [body]
  std::vector<Point<D>> shift_;  ///< [body] [m/s]
};

/// (RP.69) of one body from its particles [N s]; needs a momentum budget.
template <class T, int D>
Point<D> budget_momentum(const State<T, D>& state, int body);

extern template class ContactMomentumCorrection<double, 2>;
extern template class ContactMomentumCorrection<double, 3>;
extern template class ContactMomentumCorrection<float, 2>;
extern template class ContactMomentumCorrection<float, 3>;

}  // namespace pliant::remeshed
