#include "engine/total_lagrangian/state_archive.hpp"

#include <fmt/format.h>

#include "engine/method/archived_clock.hpp"
#include "engine/method/archived_points.hpp"

namespace pliant::total_lagrangian {

namespace {

/// Calls f(name, buffer) for every array that a checkpoint holds.
void for_each_saved_array(auto& body, auto&& f) {
  body.for_each_array([&f](Field field, auto components) {
    if (!declaration(field).is_saved) return;
    for (std::size_t c = 0; c < components.size(); ++c) {
      f(fmt::format("{}/{}", declaration(field).name, c), components[c]);
    }
  });
}

}  // namespace

template <class T, int D>
void put_state(ArchiveWriter& archive, const State<T, D>& state) {
  put_clock(archive, state.clock);
  archive.put("clock/mass_scaling", state.clock.mass_scaling);
  archive.put("clock/damping", state.clock.damping);
  archive.put("clock/step_length", state.clock.step_length);
  archive.put("clock/step_end", state.clock.step_end);
  put_energy(archive, "energy", state.energy);
  put_energy(archive, "power", state.power);
  put_boundaries<D>(archive, state.boundaries);
  put_points<D>(archive, "walls/impulse", state.wall_impulse);
  put_points<D>(archive, "walls/force", state.wall_force);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    for_each_saved_array(state.bodies[b], [&](const std::string& name, const Buffer<T>& values) {
      archive.put(fmt::format("body/{}/{}", b, name),
                  std::span<const T>(values.get(), state.bodies[b].layout.slots()));
    });
  }
}

template <class T, int D>
void get_state(const ArchiveReader& archive, State<T, D>& state) {
  get_clock(archive, state.clock);
  state.clock.mass_scaling = archive.scalar<double>("clock/mass_scaling");
  state.clock.damping = archive.scalar<double>("clock/damping");
  state.clock.step_length = archive.scalar<double>("clock/step_length");
  state.clock.step_end = archive.scalar<double>("clock/step_end");
  get_energy(archive, "energy", state.energy);
  get_energy(archive, "power", state.power);
  get_boundaries<D>(archive, state.boundaries);
  get_points<D>(archive, "walls/impulse", state.wall_impulse);
  get_points<D>(archive, "walls/force", state.wall_force);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    for_each_saved_array(state.bodies[b], [&](const std::string& name, Buffer<T>& values) {
      archive.read(fmt::format("body/{}/{}", b, name),
                   std::span<T>(values.get(), state.bodies[b].layout.slots()));
    });
  }
  state.age_memory();
}

template void put_state<double, 2>(ArchiveWriter&, const State<double, 2>&);
template void put_state<double, 3>(ArchiveWriter&, const State<double, 3>&);
template void get_state<double, 2>(const ArchiveReader&, State<double, 2>&);
template void get_state<double, 3>(const ArchiveReader&, State<double, 3>&);
template void put_state<float, 2>(ArchiveWriter&, const State<float, 2>&);
template void put_state<float, 3>(ArchiveWriter&, const State<float, 3>&);
template void get_state<float, 2>(const ArchiveReader&, State<float, 2>&);
template void get_state<float, 3>(const ArchiveReader&, State<float, 3>&);

}  // namespace pliant::total_lagrangian
