#pragma once

#include <functional>
#include <vector>

#include "engine/remeshed/state.hpp"
#include "scheduler/phase.hpp"

// The momentum that bodies in contact hold to.
//
// Neither a step nor a remeshing conserves the momentum of a body to rounding: div sigma over
// fitted ghosts adds up to the surface traction only as far as the method is accurate, and a
// remeshing changes which nodes are inside and what they weigh. Both errors are those of the
// method, some tenths of a percent of what the body is doing, and vanish with h; but nothing makes
// those of two bodies cancel. Hence a book for each body in contact, which changes by the impulses
// of contacts alone, (RP.67): one number, added to one body and taken from the other. After each
// step and each remeshing all particles of a body move faster by one small velocity, so that their
// mean velocity is that of the book, (RP.68). A rigid shift changes no strain, no stress and no
// relative motion.
//
// The mass of a body in its book is that at t = 0, whatever its particles add up to: their common
// factor means nothing to the method, which reads densities.
namespace pliant::remeshed {

template <class T, int D>
class MomentumCorrection {
 public:
  MomentumCorrection(State<T, D>& state, const Case& settings);

  bool is_needed() const { return !state_.momentum_budgets.empty(); }

  /// Opens the momentum_budgets at t = 0.
  void open();

  /// Brings the particles to their momentum_budgets; `impulse` gives what contacts did to the
  /// second of their bodies in the step, if there was one.
  using Impulses = std::function<const std::vector<Point<D>>&()>;
  void add_phases(std::vector<scheduler::Phase>& phases, Impulses impulses);

 private:
  struct Sum {
    double mass;
    Point<D> momentum;
    bool is_held;  ///< by a wall or a pressure, whose impulse no book knows
  };
  void sum(int block);
  void book(const std::vector<Point<D>>& impulses);
  void balance();
  void shift(int block);

  State<T, D>& state_;
  const std::vector<ContactCase>& contacts_;
  std::vector<Sum> sums_;        ///< [block]
  std::vector<Sum> of_body_;     ///< [body]
  std::vector<Point<D>> shift_;  ///< [body] [m/s]
};

/// (RP.68) of one body from its particles [N s]; needs momentum_budgets.
template <class T, int D>
Point<D> budget_momentum(const State<T, D>& state, int body);

extern template class MomentumCorrection<double, 2>;
extern template class MomentumCorrection<double, 3>;
extern template class MomentumCorrection<float, 2>;
extern template class MomentumCorrection<float, 3>;

}  // namespace pliant::remeshed
