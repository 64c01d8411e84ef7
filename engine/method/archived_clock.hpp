#pragma once

#include <string>

#include "engine/method/energy_budget.hpp"
#include "engine/method/step_clock.hpp"
#include "engine/output/archive/archive.hpp"

/// Archive entries for the members of clocks and energy budgets that all methods share.
namespace pliant {

/// Writes the members of a clock that all methods have.
inline void put_clock(ArchiveWriter& archive, const StepClock& clock) {
  archive.put("clock/step", clock.step);
  archive.put("clock/time", clock.time);
  archive.put("clock/wave_speed", clock.wave_speed);
}

inline void get_clock(const ArchiveReader& archive, StepClock& clock) {
  clock.step = archive.scalar<std::int64_t>("clock/step");
  clock.time = archive.scalar<double>("clock/time");
  clock.wave_speed = archive.scalar<double>("clock/wave_speed");
}

inline void put_energy(ArchiveWriter& archive, const std::string& group,
                       const EnergyBudget& energy) {
  archive.put(group + "/wall_work", energy.wall_work);
  archive.put(group + "/load_work", energy.load_work);
  archive.put(group + "/body_force_work", energy.body_force_work);
  archive.put(group + "/cut_work", energy.cut_work);
  archive.put(group + "/blade_work", energy.blade_work);
  archive.put(group + "/damping", energy.damping);
  archive.put(group + "/friction", energy.friction);
}

inline void get_energy(const ArchiveReader& archive, const std::string& group,
                       EnergyBudget& energy) {
  energy.wall_work = archive.scalar<double>(group + "/wall_work");
  energy.load_work = archive.scalar<double>(group + "/load_work");
  energy.body_force_work = archive.scalar<double>(group + "/body_force_work");
  energy.cut_work = archive.scalar<double>(group + "/cut_work");
  energy.blade_work = archive.scalar<double>(group + "/blade_work");
  energy.damping = archive.scalar<double>(group + "/damping");
  energy.friction = archive.scalar<double>(group + "/friction");
}

}  // namespace pliant
