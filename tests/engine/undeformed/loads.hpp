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

/// Kinetic and strain energy, minus the work, plus damped energy [J].
inline double balance(pliant::Solver& solver) {
  const BodyIntegrals sum = solver.integrals();
  const EnergyBudget budget = *solver.energy_budget();
  return sum.kinetic_energy + sum.strain_energy - budget.work() + budget.losses();
}

}  // namespace pliant::test
