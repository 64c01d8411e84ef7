#include <fluid_time_step.h>
#include <continuum_integration.hpp>
#include "bench/peers/sphinxsys/body.hpp"

namespace peers {
namespace {

/// Plane strain: GeneralContinuum would take the deviator of a 2D tensor.
class PlaneStrainSolid : public SPH::GeneralContinuum {
 public:
  PlaneStrainSolid(Real density, Real sound_speed, Real youngs_modulus, Real poissons_ratio,
                   bool is_linear_in_volume)
      : SPH::GeneralContinuum(density, sound_speed, youngs_modulus, poissons_ratio),
        is_linear_in_volume_(is_linear_in_volume) {}

  Real getPressure(Real density) override {
    return is_linear_in_volume_ ? p0_ * (1 - rho0_ / density)
                                : SPH::GeneralContinuum::getPressure(density);
  }

  Matd ConstitutiveRelationShearStress(Matd& gradient, Matd& stress) override {
    const Matd strain_rate = 0.5 * (gradient + gradient.transpose());
    const Matd spin = 0.5 * (gradient - gradient.transpose());
    return 2 * G_ * (strain_rate - strain_rate.trace() / 3 * Matd::Identity()) + spin * stress -
           stress * spin;
  }

 private:
  bool is_linear_in_volume_;
};

Real largest_speed(const Problem& problem) {
  Real speed = 0;
  for (const Vecd& motion : problem.velocity) speed = std::max(speed, motion.norm());
  return speed;
}

}  // namespace

int run_updated_lagrangian(const Problem& problem, const Observe& observe) {
  SPH::SPHSystem system = system_of(problem);
  SPH::RealBody body(system, "body");
  const Real bulk_modulus = problem.youngs_modulus / (3 - 6 * problem.poissons_ratio);
  SPH::BaseParticles& particles = fill<PlaneStrainSolid>(
      body, problem, problem.density, std::sqrt(bulk_modulus / problem.density),
      problem.youngs_modulus, problem.poissons_ratio, problem.is_neo_hookean);
  SPH::InnerRelation inner(body);
  SPH::InteractionWithUpdate<SPH::LinearGradientCorrectionMatrixInner> correction(inner);
  SPH::Dynamics1Level<SPH::continuum_dynamics::Integration1stHalf> pressure_step(inner);
  SPH::Dynamics1Level<SPH::fluid_dynamics::Integration2ndHalfInnerDissipativeRiemann> density_step(
      inner);
  SPH::InteractionWithUpdate<SPH::continuum_dynamics::ShearStressRelaxationHourglassControl1stHalf>
      shear_stress(inner);
  SPH::InteractionDynamics<SPH::continuum_dynamics::ShearStressRelaxationHourglassControl2ndHalf>
      shear_acceleration(inner);
  SPH::SimpleDynamics<SPH::fluid_dynamics::ContinuumVolumeUpdate> update_volume(body);
  SPH::ReduceDynamics<SPH::fluid_dynamics::AdvectionTimeStep> advection_step(
      body, largest_speed(problem), 0.2);
  SPH::ReduceDynamics<SPH::fluid_dynamics::AcousticTimeStep> acoustic_step(body, 0.4);
  Part held(body, [&](std::size_t p) { return problem.held[p]; });
  SPH::SimpleDynamics<KeepVelocity> hold(held, problem);
  system.initializeSystemCellLinkedLists();
  system.initializeSystemConfigurations();
  correction.exec();

  Clock clock(system, problem);
  const Vecd* position = particles.getVariableDataByName<Vecd>("Position");
  observe(clock.time(), position, particles);
  while (clock.is_running()) {
    const Real search_time = clock.time() + advection_step.exec();
    update_volume.exec();
    while (clock.is_running() && clock.time() < search_time) {
      const Real step = clock.limit(acoustic_step.exec());
      pressure_step.exec(step);
      hold.exec(step);
      shear_stress.exec(step);
      shear_acceleration.exec(step);
      density_step.exec(step);
      clock.advance(step);
      observe(clock.time(), position, particles);
    }
    body.updateCellLinkedList();
    inner.updateConfiguration();
    correction.exec();
  }
  return clock.steps();
}

}  // namespace peers
