#include "engine/simulation/methods.hpp"

#include "engine/remeshed/solver.hpp"
#include "engine/total_lagrangian/solver.hpp"

namespace pliant {

const MethodRegistry& methods() {
  static const MethodRegistry registry({
      {"remeshed", make_solver<remeshed::Solver>},
      {"total_lagrangian", make_solver<total_lagrangian::Solver>},
  });
  return registry;
}

}  // namespace pliant
