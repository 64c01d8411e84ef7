#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// How much larger the part of a wall that ghost g stands for is now than at the remeshing,
/// (RP.65): abs(cof F n), F of the places of the slots around at a stage.
template <class T, int D>
double growth_on_wall(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
                      int stage);

/// A ghost that stands for a part of its wall, (RP.65) [m^(D-1)].
struct WallShare {
  std::int32_t ghost;
  double area;
};

/// Those of a block behind walls to which bodies are attached and that are `watched`, in the order
/// of the ghosts. Walls move between steps, so that they hold for a step.
template <class T, int D>
void find_wall_shares(const Body<T, D>& body, int block, const Boundaries<D>& boundaries,
                      const std::vector<char>& watched, std::vector<WallShare>& shares);

/// (RP.65) of a block in one stage: adds what walls push with to impulse[wall], and their work.
template <class T, int D>
class WallWork {
 public:
  /// For a stage that weighs `duration` [s] in the step.
  WallWork(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, int stage,
           const Surroundings<D>& around, double duration, std::span<const WallShare> shares,
           Point<D>* impulse, double& work)
      : body_(body),
        ghosts_(ghosts),
        stage_(stage),
        around_(around),
        duration_(duration),
        shares_(shares),
        impulse_(impulse),
        work_(work),
        impedance_(body.material) {}

  /// Adds what the wall of ghost g does, if the ghost has a share. Asked for in their order.
  void add(std::size_t g, const kernels::GhostFits<T, D>& fits,
           const kernels::WallSite<T, D>& site);

 private:
  const Body<T, D>& body_;
  const BlockGhosts<T, D>& ghosts_;
  int stage_;
  const Surroundings<D>& around_;
  double duration_;
  std::span<const WallShare> shares_;  ///< of ghosts that are still to come
  Point<D>* impulse_;
  double& work_;
  kernels::Impedance<T> impedance_;
};

extern template class WallWork<double, 2>;
extern template class WallWork<double, 3>;
extern template class WallWork<float, 2>;
extern template class WallWork<float, 3>;

}  // namespace pliant::remeshed
