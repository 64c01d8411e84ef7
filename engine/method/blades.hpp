#pragma once

#include <array>
#include <cstddef>

namespace pliant {

/// The blades of a case. A caller may move them between steps; from then on the motion of the case
/// no longer applies. Cuts are numbered as in the case. A solver whose method can cut implements
/// this interface too.
class Blades {
 public:
  virtual ~Blades() = default;

  /// Moves the edge of a blade to the line from `from` to `to` [m], in the deformed body; in 2D, to
  /// the point `from`. The next step cuts what the edge sweeps from its last place.
  virtual void put_blade(std::size_t cut, const std::array<double, 3>& from,
                         const std::array<double, 3>& to) = 0;
  /// Takes a blade out at its place in the last step. A new cut begins where it is put next.
  virtual void lift_blade(std::size_t cut) = 0;
  /// Force of a blade on its body in the last step [N], per unit thickness in 2D.
  virtual std::array<double, 3> blade_force(std::size_t cut) const = 0;
};

}  // namespace pliant
