#include <elastic_dynamics.h>
#include "bench/peers/sphinxsys/body.hpp"

namespace peers {

int run_total_lagrangian(const Problem& problem, const Observe& observe) {
  SPH::SPHSystem system = system_of(problem);
  SPH::SolidBody body(system, "body");
  SPH::BaseParticles& particles =
      problem.is_neo_hookean
          ? fill<SPH::NeoHookeanSolid>(body, problem, problem.density, problem.youngs_modulus,
                                       problem.poissons_ratio)
          : fill<SPH::SaintVenantKirchhoffSolid>(body, problem, problem.density,
                                                 problem.youngs_modulus, problem.poissons_ratio);
  SPH::InnerRelation inner(body);
  SPH::InteractionWithUpdate<SPH::LinearGradientCorrectionMatrixInner> correction(inner);
  SPH::Dynamics1Level<SPH::solid_dynamics::Integration1stHalfPK2> first_half(inner);
  SPH::Dynamics1Level<SPH::solid_dynamics::Integration2ndHalf> second_half(inner);
  SPH::ReduceDynamics<SPH::solid_dynamics::AcousticTimeStep> stable_step(body);
  Part held(body, [&](std::size_t p) { return problem.held[p]; });
  SPH::SimpleDynamics<KeepVelocity> hold(held, problem);
  Part loaded(body,
              [&](std::size_t p) { return !problem.load.empty() && !problem.load[p].isZero(); });
  SPH::SimpleDynamics<Load> push(loaded, problem);
  SPH::SimpleDynamics<Damping> damp(body, problem);
  system.initializeSystemCellLinkedLists();
  system.initializeSystemConfigurations();
  correction.exec();

  Clock clock(system, problem);
  const Vecd* position = particles.getVariableDataByName<Vecd>("Position");
  observe(clock.time(), position, particles);
  while (clock.is_running()) {
    const Real step = clock.limit(stable_step.exec());
    push.exec(step);
    first_half.exec(step);
    if (problem.damping > 0) damp.exec(step);
    hold.exec(step);
    second_half.exec(step);
    clock.advance(step);
    observe(clock.time(), position, particles);
  }
  return clock.steps();
}

}  // namespace peers
