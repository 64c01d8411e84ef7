#pragma once

#include <functional>
#include <vector>

#include "engine/remeshed/state.hpp"
#include "scheduler/phase.hpp"

// The momentum budget of bodies in contact.
//
// Neither a step nor a remeshing conserves the momentum of a body to rounding: div sigma over
// fitted ghosts adds up to the surface traction only as far as the method is accurate, and a
// remeshing changes which nodes are inside and what they weigh. Both errors are those of the
// method, some tenths of a percent of what the body is doing, and vanish with h; but nothing makes
// those of two bodies cancel. Each body in contact therefore has a momentum budget, which changes
// by the impulses of contacts alone, (RP.68): one number, added to one body and taken from the
// other. After each step and each remeshing one small velocity is added to all particles of a body,
// so that their mean velocity is that of the budget, (RP.69). This changes no strain, no stress and
// no relative motion.
//
// The mass of a body in its budget is that at t = 0, whatever the masses of its particles add up
// to: the method reads densities, which a common factor of masses does not change.
namespace pliant::remeshed {

template <class T, int D>
class MomentumCorrection {
 public:
  MomentumCorrection(State<T, D>& state, const Case& settings);

  bool is_needed() const { return !state_.momentum_budgets.empty(); }

  /// Sets the momentum budgets at t = 0.
  void open();

  /// Phases that give the particles of each body the momentum of its budget; `impulses` are those
  /// of contacts on their second bodies in the step, if there was one.
  using Impulses = std::function<const std::vector<Point<D>>&()>;
  void add_phases(std::vector<scheduler::Phase>& phases, Impulses impulses);

 private:
  struct Sum {
    double mass;
    Point<D> momentum;
    bool is_held;  ///< by a wall or a pressure, whose impulse no budget contains
  };
  void sum(int block);
  void add_impulses(const std::vector<Point<D>>& impulses);
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

extern template class MomentumCorrection<double, 2>;
extern template class MomentumCorrection<double, 3>;
extern template class MomentumCorrection<float, 2>;
extern template class MomentumCorrection<float, 3>;

}  // namespace pliant::remeshed
