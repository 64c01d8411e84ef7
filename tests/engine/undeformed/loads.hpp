#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/method/solver.hpp"

/// Boundaries and measurements of cases with loads, for all methods.
namespace pliant::test {

inline std::string half_space(const std::string& name, const std::string& rest,
                              const std::string& point, const std::string& normal) {
  return "[[boundary]]\nname = \"" + name + "\"\n" + rest +
         "\ngeometry = { shape = \"half_space\", point = " + point + ", normal = " + normal +
         " }\n";
}

inline std::string measurement(const std::string& name, const std::string& rest) {
  return "[[measurement]]\nname = \"" + name + "\"\n" + rest + "\n";
}

/// Present values of the measurements of the case, by name.
inline std::map<std::string, double> values(pliant::Solver& solver) {
  std::map<std::string, double> named;
  const std::vector<double> measured = solver.measure();
  for (std::size_t m = 0; m < measured.size(); ++m) {
    named[solver.settings().measurements[m].name] = measured[m];
  }
  return named;
}

/// Advances from now to `start` and on to `end` [s]. Returns the mean of the force `name` between
/// the two [N], or N/m in 2D; measurements of forces are impulses here.
inline double mean_force(pliant::Solver& solver, const std::string& name, double start,
                         double end) {
  solver.advance(start);
  const double impulse = values(solver)[name], from = solver.clock().time;
  solver.advance(end);
  return (values(solver)[name] - impulse) / (solver.clock().time - from);
}

/// Kinetic and strain energy, minus the work, plus damped energy [J].
inline double balance(pliant::Solver& solver) {
  const BodyIntegrals sum = solver.integrals();
  const EnergyBudget budget = *solver.energy_budget();
  return sum.kinetic_energy + sum.strain_energy - budget.work() + budget.losses();
}

}  // namespace pliant::test
