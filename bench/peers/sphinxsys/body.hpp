#pragma once

#include <base_particle_generator.h>
#include <dynamics_algorithms.h>
#include <general_constraint.h>
#include <inner_body_relation.h>
#include <predefined_bodies.h>
#include <kernel_correction.hpp>
#include <sph_system.hpp>

#include "bench/peers/sphinxsys/problem.hpp"

namespace SPH {

/// Makes particles at the places of the problem.
template <>
class ParticleGenerator<BaseParticles, peers::Problem> : public ParticleGenerator<BaseParticles> {
 public:
  ParticleGenerator(SPHBody& body, BaseParticles& particles, const peers::Problem& problem)
      : ParticleGenerator<BaseParticles>(body, particles), problem_(problem) {}

  void prepareGeometricData() override {
    const Real volume = std::pow(problem_.spacing, Dimensions);
    for (const Vecd& place : problem_.position) addPositionAndVolumetricMeasure(place, volume);
  }

 private:
  const peers::Problem& problem_;
};

}  // namespace SPH

namespace peers {

/// The particles with `contains(particle)`.
class Part : public SPH::BodyPartByParticle {
 public:
  Part(SPH::SPHBody& body, std::function<bool(std::size_t)> contains);
};

/// Resets the velocity of its particles to that at the start.
class KeepVelocity : public SPH::MotionConstraint<SPH::BodyPartByParticle> {
 public:
  KeepVelocity(SPH::BodyPartByParticle& part, const Problem& problem);
  void update(std::size_t particle, Real step);

 private:
  const Problem& problem_;
};

class Load : public SPH::BaseLocalDynamics<SPH::BodyPartByParticle> {
 public:
  Load(SPH::BodyPartByParticle& part, const Problem& problem);
  void setupDynamics(Real step) override;
  void update(std::size_t particle, Real step);

 private:
  const Problem& problem_;
  const Real* time_;
  Vecd* force_;
  Real share_ = 0;
};

/// Exact damping of the velocity over a step.
class Damping : public SPH::LocalDynamics {
 public:
  Damping(SPH::SPHBody& body, const Problem& problem);
  void setupDynamics(Real step) override;
  void update(std::size_t particle, Real step);

 private:
  Real rate_, factor_ = 1;
  Vecd* velocity_;
};

/// The time, and the times at which steps must end.
class Clock {
 public:
  Clock(SPH::SPHSystem& system, const Problem& problem);
  Real time() const { return *time_; }
  bool is_running() const { return next_ != stops_.end(); }
  Real limit(Real step) const { return std::min(step, *next_ - *time_); }
  void advance(Real step);
  int steps() const { return steps_; }

 private:
  const std::vector<Real>& stops_;
  std::vector<Real>::const_iterator next_;
  Real* time_;
  int steps_ = 0;
};

/// A system with bounds that contain the body and its motion.
SPH::SPHSystem system_of(const Problem& problem);

/// Makes the particles, with their initial velocities.
template <class Material, class... Parameters>
SPH::BaseParticles& fill(SPH::SPHBody& body, const Problem& problem, Parameters... parameters) {
  body.defineMatterMaterial<Material>(parameters...);
  SPH::BaseParticles& particles = body.generateParticles<SPH::BaseParticles, Problem>(problem);
  Vecd* velocity = particles.registerStateVariableData<Vecd>("Velocity");
  std::copy(problem.velocity.begin(), problem.velocity.end(), velocity);
  return particles;
}

}  // namespace peers
