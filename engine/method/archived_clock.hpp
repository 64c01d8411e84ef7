#pragma once

#include "engine/method/step_clock.hpp"
#include "engine/output/archive.hpp"

/// What the clocks of all methods have in common, in an archive.
namespace pliant {

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

}  // namespace pliant
