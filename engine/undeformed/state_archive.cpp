#include "engine/undeformed/state_archive.hpp"

#include "engine/method/archived_clock.hpp"
#include "engine/method/archived_points.hpp"

namespace pliant::undeformed {

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
  put_points<D>(archive, "walls/impulse", state.wall_impulse);
  put_points<D>(archive, "walls/force", state.wall_force);
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
  get_points<D>(archive, "walls/impulse", state.wall_impulse);
  get_points<D>(archive, "walls/force", state.wall_force);
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
