#pragma once

namespace pliant {

/// Energy added to the bodies since t = 0, and energy taken from them by damping and friction [J],
/// per unit thickness in 2D. With the kinetic and the strain energy it closes the balance (RP.72).
struct EnergyBudget {
  double wall_work = 0;        ///< work of moving walls on the bodies
  double load_work = 0;        ///< work of pressures and tractions
  double body_force_work = 0;  ///< work of gravity
  double cut_work = 0;         ///< change of the strain energy where cuts change bonds
  double blade_work = 0;       ///< work of the forces of blades on the bodies
  double damping = 0;          ///< lost to damping rates
  double friction = 0;         ///< lost to friction on contact walls and between bodies

  double work() const { return wall_work + load_work + body_force_work + cut_work + blade_work; }
  double losses() const { return damping + friction; }
};

inline void add(EnergyBudget& sum, const EnergyBudget& other, double factor = 1) {
  sum.wall_work += factor * other.wall_work;
  sum.load_work += factor * other.load_work;
  sum.body_force_work += factor * other.body_force_work;
  sum.cut_work += factor * other.cut_work;
  sum.blade_work += factor * other.blade_work;
  sum.damping += factor * other.damping;
  sum.friction += factor * other.friction;
}

}  // namespace pliant
