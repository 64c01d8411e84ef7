#include "engine/undeformed/state_archive.hpp"

#include <cstdint>
#include <span>

#include "engine/method/archived_clock.hpp"
#include "engine/method/archived_points.hpp"

namespace pliant::undeformed {

namespace {

template <class NearWalls, class Act>
void for_each_near_list(NearWalls& walls, const Act& act) {
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (std::size_t s = 0; s < walls[w].soon.corners.size(); ++s) {
      act(fmt::format("walls/near/{}/{}", w, s), walls[w].soon.corners[s]);
      act(fmt::format("walls/near_later/{}/{}", w, s), walls[w].later.corners[s]);
    }
  }
}

void put_near_walls(ArchiveWriter& archive, const std::vector<NearWall>& walls) {
  std::vector<double> numbers;
  for (const NearWall& wall : walls) {
    numbers.insert(numbers.end(), {wall.speed, wall.soon.unspent, wall.later.unspent});
  }
  for_each_near_list(walls, [&](const std::string& name, const std::vector<std::int32_t>& list) {
    archive.put(name, std::span<const std::int32_t>(list));
  });
  archive.put("walls/near/numbers", std::span<const double>(numbers));
}

void get_near_walls(const ArchiveReader& archive, std::vector<NearWall>& walls) {
  const auto numbers = archive.get<double>("walls/near/numbers");
  for (std::size_t w = 0; w < walls.size(); ++w) {
    walls[w].speed = numbers.at(3 * w);
    walls[w].soon.unspent = numbers.at(3 * w + 1);
    walls[w].later.unspent = numbers.at(3 * w + 2);
  }
  for_each_near_list(walls, [&](const std::string& name, std::vector<std::int32_t>& list) {
    const auto corners = archive.get<std::int32_t>(name);
    list.assign(corners.begin(), corners.end());
  });
}

}  // namespace

template <int D>
void put_totals(ArchiveWriter& archive, const State<D>& state) {
  put_clock(archive, state.clock);
  archive.put("clock/mass_scaling", state.clock.mass_scaling);
  archive.put("clock/damping", state.clock.damping);
  archive.put("clock/next_sample", state.clock.next_sample);
  archive.put("clock/sample_interval", state.clock.sample_interval);
  archive.put("clock/step_length", state.clock.step_length);
  archive.put("clock/step_end", state.clock.step_end);
  archive.put("clock/velocity_time", state.clock.velocity_time);
  put_energy(archive, "energy", state.energy);
  put_energy(archive, "power", state.power);
  put_boundaries<D>(archive, state.boundaries);
  put_wrenches<D>(archive, "walls/impulse", state.wall_impulse);
  put_wrenches<D>(archive, "walls/force", state.wall_force);
  put_near_walls(archive, state.near_walls);
  put_points<D>(archive, "contacts/impulse", state.contact_impulse);
  put_points<D>(archive, "contacts/force", state.contact_force);
  put_points<D>(archive, "contacts/marks", state.contact_marks);
}

template <int D>
void get_totals(const ArchiveReader& archive, State<D>& state) {
  get_clock(archive, state.clock);
  state.clock.mass_scaling = archive.scalar<double>("clock/mass_scaling");
  state.clock.damping = archive.scalar<double>("clock/damping");
  state.clock.next_sample = archive.scalar<std::int64_t>("clock/next_sample");
  state.clock.sample_interval = archive.scalar<std::int64_t>("clock/sample_interval");
  state.clock.step_length = archive.scalar<double>("clock/step_length");
  state.clock.step_end = archive.scalar<double>("clock/step_end");
  state.clock.velocity_time = archive.scalar<double>("clock/velocity_time");
  get_energy(archive, "energy", state.energy);
  get_energy(archive, "power", state.power);
  get_boundaries<D>(archive, state.boundaries);
  get_wrenches<D>(archive, "walls/impulse", state.wall_impulse);
  get_wrenches<D>(archive, "walls/force", state.wall_force);
  get_near_walls(archive, state.near_walls);
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
