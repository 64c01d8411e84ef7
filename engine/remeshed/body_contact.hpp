#pragma once

#include <vector>

#include "engine/lattice/cell_list.hpp"
#include "engine/remeshed/state.hpp"
#include "kernels/table.hpp"
#include "scheduler/phase.hpp"

// Bodies that meet.
//
//         body a         Ghosts of a body stay those of its own surface. Where the foot point of one
//     \___________/      lies on another body too, the surface is not free there: it carries the
//      g g x x g g       traction (RP.65) that two half spaces with the states of the two bodies at
//         /-----\        that point would exert on each other at once (a Riemann problem), and
//          body b        the ghost is that of a loaded surface.
//
// Nothing is shared but that traction: each body keeps its lattice, its level set and its particles,
// remeshes by itself, and materials never mix. A bonded interface is the same without the question
// whether the bodies press.
//
// Each side finds the traction at its own foot points, and what each of them does to its particles
// is right to the order of the method, not to rounding. The momentum that crosses is therefore
// booked once for each pair, as the mean of what the two sides say, and each body holds to its
// book: body_momentum.hpp.
namespace pliant::remeshed {

template <class T, int D>
class BodyContact {
 public:
  BodyContact(State<T, D>& state, const Case& settings, const kernels::Table<T, D>& kernels);

  bool is_needed() const { return !contacts_.empty(); }

  /// Once per step: where bodies touch, from the places of their surface particles.
  void add_search(std::vector<scheduler::Phase>& phases);
  /// Once per stage: the tractions there.
  void add_tractions(std::vector<scheduler::Phase>& phases, int stage);

  void prepare(double time_step);
  /// (RP.67): impulse of each contact on the second of its bodies in the step [N s], folded over
  /// the blocks in their order.
  std::vector<Point<D>> fold() const;

 private:
  static constexpr std::array<double, 4> stage_weight = {1. / 6, 1. / 3, 1. / 3, 1. / 6};

  /// A surface particle with a record, or a ghost (record -1).
  struct Sample {
    Site<D> site;
    std::int32_t record;
    double level_set;  ///< [h]
  };
  /// Samples of one body, sorted by place.
  struct Surface {
    Point<D> lower, upper;  ///< [m] of the samples; periodic directions have no end
    std::vector<std::int32_t> record;
    std::vector<double> level_set;
    CellList<D> cells;
    bool is_near_another = false;
  };
  class Partner;

  void find_samples(int block);
  void sort_samples();
  void find_touches(int block);
  void find_tractions(int block, int stage);
  Body<T, D>& body_of(int block) { return state_.bodies[state_.blocks[block].body]; }
  BlockGhosts<T, D>& ghosts_of(int block) {
    return body_of(block).population.ghosts[state_.blocks[block].block];
  }

  State<T, D>& state_;
  const std::vector<ContactCase>& contacts_;
  const kernels::Table<T, D>& kernels_;
  std::vector<std::vector<int>> contacts_of_;  ///< [body] those that it is part of
  std::vector<std::vector<Sample>> samples_;   ///< [block]
  std::vector<Surface> surfaces_;              ///< [body]
  std::vector<Point<D>> impulse_;              ///< [block][contact] on the second body
  double time_step_ = 0;
};

extern template class BodyContact<double, 2>;
extern template class BodyContact<double, 3>;

}  // namespace pliant::remeshed
