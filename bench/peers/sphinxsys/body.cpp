#include "bench/peers/sphinxsys/body.hpp"

#include <cmath>
#include <cstdio>

namespace peers {

void Problem::add(const Vecd& place, const Vecd& motion, bool is_held) {
  position.push_back(place);
  velocity.push_back(motion);
  held.push_back(is_held);
}

Part::Part(SPH::SPHBody& body, std::function<bool(std::size_t)> contains)
    : SPH::BodyPartByParticle(body) {
  tagParticles(contains);
}

KeepVelocity::KeepVelocity(SPH::BodyPartByParticle& part, const Problem& problem)
    : SPH::MotionConstraint<SPH::BodyPartByParticle>(part), problem_(problem) {}

void KeepVelocity::update(std::size_t particle, Real /*step*/) {
  vel_[particle] = problem_.velocity[particle];
}

Load::Load(SPH::BodyPartByParticle& part, const Problem& problem)
    : SPH::BaseLocalDynamics<SPH::BodyPartByParticle>(part),
      problem_(problem),
      time_(sph_system_->svPhysicalTime().Data()),
      force_(particles_->registerStateVariableData<Vecd>("ForcePrior")) {}

void Load::setupDynamics(Real /*step*/) { share_ = std::min(*time_ / problem_.load_time, Real(1)); }

void Load::update(std::size_t particle, Real /*step*/) {
  force_[particle] = share_ * problem_.load[particle];
}

Damping::Damping(SPH::SPHBody& body, const Problem& problem)
    : SPH::LocalDynamics(body),
      rate_(problem.damping),
      velocity_(particles_->registerStateVariableData<Vecd>("Velocity")) {}

void Damping::setupDynamics(Real step) { factor_ = std::exp(-rate_ * step); }

void Damping::update(std::size_t particle, Real /*step*/) { velocity_[particle] *= factor_; }

Clock::Clock(SPH::SPHSystem& system, const Problem& problem)
    : stops_(problem.stops), next_(stops_.begin()), time_(system.svPhysicalTime().Data()) {}

void Clock::advance(Real step) {
  ++steps_;
  *time_ += step;
  if (*time_ < *next_ - 1e-9 * stops_.back()) return;
  *time_ = *next_;  // exactly, so that measurements find this time
  ++next_;
}

SPH::SPHSystem system_of(const Problem& problem) {
  Vecd lower = problem.position.front(), upper = lower;
  for (const Vecd& place : problem.position) {
    lower = lower.cwiseMin(place);
    upper = upper.cwiseMax(place);
  }
  const Vecd room = 0.5 * (upper - lower).minCoeff() * Vecd::Ones();
  return {SPH::BoundingBoxd(lower - room, upper + room), problem.spacing,
          static_cast<std::size_t>(problem.threads)};
}

void print_result(std::size_t particles, int steps,
                  const std::vector<std::pair<std::string, Real>>& values) {
  std::printf("{\"particles\": %zu, \"steps\": %d, \"values\": {", particles, steps);
  const char* separator = "";
  for (const auto& [name, value] : values) {
    std::printf("%s\"%s\": %.9g", separator, name.c_str(), value);
    separator = ", ";
  }
  std::puts("}}");
}

}  // namespace peers
