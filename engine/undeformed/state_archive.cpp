#include "engine/undeformed/state_archive.hpp"

#include "engine/method/archived_clock.hpp"
#include "engine/method/archived_points.hpp"

namespace pliant::undeformed {

namespace {

template <int D>
void put_wrenches(ArchiveWriter& archive, const std::string& name,
                  const std::vector<Wrench<D>>& wrenches) {
  std::vector<Point<D>> forces;
  std::vector<Vector> moments;
  for (const Wrench<D>& wrench : wrenches) {
    forces.push_back(wrench.force);
    moments.push_back(wrench.moment);
  }
  put_points<D>(archive, name, forces);
  put_points<3>(archive, name + "_moment", moments);
}

template <int D>
void get_wrenches(const ArchiveReader& archive, const std::string& name,
                  std::vector<Wrench<D>>& wrenches) {
  std::vector<Point<D>> forces(wrenches.size());
  std::vector<Vector> moments(wrenches.size());
  get_points<D>(archive, name, forces);
  get_points<3>(archive, name + "_moment", moments);
  for (std::size_t w = 0; w < wrenches.size(); ++w) wrenches[w] = {forces[w], moments[w]};
}

}  // namespace

template <int D>
void put_totals(ArchiveWriter& archive, const State<D>& state) {
  put_clock(archive, state.clock);
  archive.put("clock/mass_scaling", state.clock.mass_scaling);
  archive.put("clock/damping", state.clock.damping);
  archive.put("clock/step_length", state.clock.step_length);
  archive.put("clock/step_end", state.clock.step_end);
  archive.put("clock/velocity_time", state.clock.velocity_time);
  put_energy(archive, "energy", state.energy);
  put_energy(archive, "power", state.power);
  put_boundaries<D>(archive, state.boundaries);
  put_wrenches<D>(archive, "walls/impulse", state.wall_impulse);
  put_wrenches<D>(archive, "walls/force", state.wall_force);
  put_points<D>(archive, "contacts/impulse", state.contact_impulse);
  put_points<D>(archive, "contacts/force", state.contact_force);
  put_points<D>(archive, "contacts/marks", state.contact_marks);
}

template <int D>
void get_totals(const ArchiveReader& archive, State<D>& state) {
  get_clock(archive, state.clock);
  state.clock.mass_scaling = archive.scalar<double>("clock/mass_scaling");
  state.clock.damping = archive.scalar<double>("clock/damping");
  state.clock.step_length = archive.scalar<double>("clock/step_length");
  state.clock.step_end = archive.scalar<double>("clock/step_end");
  state.clock.velocity_time = archive.scalar<double>("clock/velocity_time");
  get_energy(archive, "energy", state.energy);
  get_energy(archive, "power", state.power);
  get_boundaries<D>(archive, state.boundaries);
  get_wrenches<D>(archive, "walls/impulse", state.wall_impulse);
  get_wrenches<D>(archive, "walls/force", state.wall_force);
  get_points<D>(archive, "contacts/impulse", state.contact_impulse);
  get_points<D>(archive, "contacts/force", state.contact_force);
  get_points<D>(archive, "contacts/marks", state.contact_marks);
  state.has_new_marks = true;
}

template void put_totals<2>(ArchiveWriter&, const State<2>&);
template void put_totals<3>(ArchiveWriter&, const State<3>&);
template void get_totals<2>(const ArchiveReader&, State<2>&);
template void get_totals<3>(const ArchiveReader&, State<3>&);

}  // namespace pliant::undeformed
