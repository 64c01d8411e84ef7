#include "engine/point_based/bonds/patch_weights.hpp"

#include "engine/point_based/bonds/patch_test.hpp"

namespace pliant::point_based {

namespace {

constexpr double small_enough = 1e-6;
constexpr int most_steps = 20, most_iterations = 4000;
constexpr int most_steps_of_balance = 24, iterations_of_balance = 10;
constexpr double regularisation = 0.03;

}  // namespace

template <int D>
double make_patch_exact(WeightedNodes<D>& nodes, scheduler::Workers& workers) {
  PatchTest<D> test(nodes, workers);
  double worst = test.worst();
  // The first steps need no accuracy, since they are far from the solution.
  for (int step = 0; step < most_steps && worst > small_enough; ++step) {
    test.improve(step == 0 ? 3e-2 : step == 1 ? 1e-2 : 1e-3, most_iterations);
    worst = test.worst();
  }
  return worst;
}

template <int D>
void balance_weights(WeightedNodes<D>& nodes, double most_change, double balanced,
                     scheduler::Workers& workers) {
  PatchTest<D> test(nodes, workers, most_change, regularisation);
  for (int step = 0; step < most_steps_of_balance && test.worst() > balanced; ++step) {
    if (!test.improve(0, iterations_of_balance)) return;
  }
}

template void balance_weights(WeightedNodes<2>&, double, double, scheduler::Workers&);
template void balance_weights(WeightedNodes<3>&, double, double, scheduler::Workers&);
template double make_patch_exact(WeightedNodes<2>&, scheduler::Workers&);
template double make_patch_exact(WeightedNodes<3>&, scheduler::Workers&);

}  // namespace pliant::point_based
