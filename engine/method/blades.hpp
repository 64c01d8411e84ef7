#pragma once

#include <array>
#include <cstddef>

namespace pliant {

/// The blades of a case, for callers that move them between steps: from then on the case moves them
/// no more. Cuts have the numbers of the case. Solvers of methods that cut are one of these too.
class Blades {
 public:
  virtual ~Blades() = default;

  /// Puts the edge of a blade from `from` to `to` [m], where the tissue is at present, in 2D to
  /// `from`. What it sweeps on its way from where it was is cut in the next step.
  virtual void put_blade(std::size_t cut, const std::array<double, 3>& from,
                         const std::array<double, 3>& to) = 0;
  /// Takes a blade out from where it was in the last step. Where it is put next, a new cut begins.
  virtual void lift_blade(std::size_t cut) = 0;
  /// Of a blade on its body in the last step [N], per unit thickness in 2D.
  virtual std::array<double, 3> blade_force(std::size_t cut) const = 0;
};

}  // namespace pliant
