#include "engine/total_lagrangian/solver_archive.hpp"

#include <fmt/format.h>

#include "engine/method/archived_points.hpp"

namespace pliant {

namespace {

template <class T, int D>
void for_each_clock_value(total_lagrangian::Solver<T, D>& solver, auto&& f) {
  total_lagrangian::Clock& clock = solver.state().clock;
  f("clock/time", clock.time);
  f("clock/wave_speed", clock.wave_speed);
  f("clock/mass_scaling", clock.mass_scaling);
  f("clock/damping", clock.damping);
}

template <class T, int D>
void for_each_field(total_lagrangian::Body<T, D>& body, auto&& f) {
  for (int a = 0; a < D; ++a) {
    f(fmt::format("displacement/{}", a), body.displacement[a]);
    f(fmt::format("velocity/{}", a), body.velocity[a]);
    f(fmt::format("internal/{}", a), body.internal[a]);
  }
}

}  // namespace

template <class T, int D>
void put_solver(ArchiveWriter& archive, total_lagrangian::Solver<T, D>& solver) {
  total_lagrangian::State<T, D>& state = solver.state();
  archive.put("clock/step", state.clock.step);
  for_each_clock_value(solver, [&](const char* name, double& value) { archive.put(name, value); });
  put_offsets<D>(archive, state.boundaries.walls);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    for_each_field(state.bodies[b], [&](const std::string& name, Buffer<T>& values) {
      archive.put(fmt::format("body/{}/{}", b, name),
                  std::span<const T>(values.get(), state.bodies[b].layout.slots()));
    });
  }
}

template <class T, int D>
void get_solver(const ArchiveReader& archive, total_lagrangian::Solver<T, D>& solver) {
  total_lagrangian::State<T, D>& state = solver.state();
  state.clock.step = archive.scalar<std::int64_t>("clock/step");
  for_each_clock_value(
      solver, [&](const char* name, double& value) { value = archive.scalar<double>(name); });
  get_offsets<D>(archive, state.boundaries.walls);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    for_each_field(state.bodies[b], [&](const std::string& name, Buffer<T>& values) {
      archive.read(fmt::format("body/{}/{}", b, name),
                   std::span<T>(values.get(), state.bodies[b].layout.slots()));
    });
  }
}

template void put_solver<double, 2>(ArchiveWriter&, total_lagrangian::Solver<double, 2>&);
template void put_solver<double, 3>(ArchiveWriter&, total_lagrangian::Solver<double, 3>&);
template void get_solver<double, 2>(const ArchiveReader&, total_lagrangian::Solver<double, 2>&);
template void get_solver<double, 3>(const ArchiveReader&, total_lagrangian::Solver<double, 3>&);

}  // namespace pliant
