#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/loads/wall_push.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// Growth of the part of a wall that ghost g represents since the remeshing, (RP.65): abs(cof F n),
/// with F from the places of the slots around it at a stage.
template <class T, int D>
double growth_on_wall(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
                      int stage);

/// A ghost and the part of its wall that it represents, (RP.65) [m^(D-1)].
struct WallShare {
  std::int32_t ghost;
  double area;
};

/// The shares of a block at attached walls that are `watched`, in the order of the ghosts. They are
/// valid for one step, since walls move between steps.
template <class T, int D>
void find_wall_shares(const Body<T, D>& body, int block, const Boundaries<D>& boundaries,
                      const std::vector<char>& watched, std::vector<WallShare>& shares);

/// (RP.65) for a block in one stage: adds the push of walls to impulse[wall], and the work of their
/// centres, but not along an axis along which momentum gives the force of the wall, see LoneWalls.
/// Adds the whole push to pushes[wall], where there are any.
template <class T, int D>
class WallWork {
 public:
  /// For a stage with the weight `duration` [s] in the step.
  WallWork(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, int stage,
           const Surroundings<D>& around, double duration, std::span<const WallShare> shares,
           const std::array<int, D>& lone_walls, std::span<WallPush<D>> pushes, Point<D>* impulse,
           double& work)
      : body_(body),
        ghosts_(ghosts),
        stage_(stage),
        around_(around),
        duration_(duration),
        shares_(shares),
        lone_walls_(lone_walls),
        pushes_(pushes),
        impulse_(impulse),
        work_(work),
        impedance_(body.material) {}

  /// Adds impulse and work of the wall of ghost g, if it has a share. Called in the order of
  /// ghosts.
  void add(std::size_t g, const kernels::GhostFits<T, D>& fits,
           const kernels::WallSite<T, D>& site);

 private:
  const Body<T, D>& body_;
  const BlockGhosts<T, D>& ghosts_;
  int stage_;
  const Surroundings<D>& around_;
  double duration_;
  std::span<const WallShare> shares_;     ///< of the ghosts that follow
  const std::array<int, D>& lone_walls_;  ///< [axis]
  std::span<WallPush<D>> pushes_;         ///< [wall]; empty if no moment is needed
  Point<D>* impulse_;
  double& work_;
  kernels::Impedance<T> impedance_;
};

extern template class WallWork<double, 2>;
extern template class WallWork<double, 3>;
extern template class WallWork<float, 2>;
extern template class WallWork<float, 3>;

}  // namespace pliant::remeshed
