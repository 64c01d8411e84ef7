#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/case/method_rules.hpp"
#include "engine/method/solver.hpp"

namespace pliant {

/// A method as the programs see it.
struct RegisteredMethod {
  MethodRules rules;  ///< for case files
  /// Makes a solver and sets up its bodies. Throws StepFailure and std::invalid_argument.
  std::unique_ptr<Solver> (*make)(const Case& settings, const SolverOptions& options);
};

/// The methods that a program can run, by their words in case files. It must outlive the cases that
/// are read with it.
class MethodRegistry {
 public:
  explicit MethodRegistry(std::vector<RegisteredMethod> methods);
  // Cases keep pointers to the rules.
  MethodRegistry(const MethodRegistry&) = delete;
  MethodRegistry& operator=(const MethodRegistry&) = delete;

  /// Throws std::invalid_argument for a word that names no method.
  const RegisteredMethod& find(std::string_view word) const;

  /// A solver of the method that the case names, at t = 0.
  std::unique_ptr<Solver> make(const Case& settings, const SolverOptions& options) const;

  MethodList rules() const { return rules_; }

 private:
  std::vector<RegisteredMethod> methods_;
  std::vector<MethodRules> rules_;
};

/// Makes an S<T, D> for the dimension of a case.
template <template <class, int> class S, class T>
std::unique_ptr<Solver> make_solver_of(const Case& settings, const SolverOptions& options) {
  switch (settings.dimension) {
    case 2:
      return std::make_unique<S<T, 2>>(settings, options);
    case 3:
      return std::make_unique<S<T, 3>>(settings, options);
    default:
      throw std::invalid_argument("a case has 2 or 3 dimensions");
  }
}

/// Makes an S<T, D> for the precision and the dimension of a case.
template <template <class, int> class S>
std::unique_ptr<Solver> make_solver(const Case& settings, const SolverOptions& options) {
  return settings.precision == Precision::binary32 ? make_solver_of<S, float>(settings, options)
                                                   : make_solver_of<S, double>(settings, options);
}

}  // namespace pliant
