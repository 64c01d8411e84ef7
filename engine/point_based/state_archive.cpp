#include "engine/point_based/state_archive.hpp"

#include "engine/undeformed/state_archive.hpp"

namespace pliant::point_based {

namespace {

template <int D>
void put_blades(ArchiveWriter& archive, const std::vector<BladeLoad<D>>& blades) {
  std::vector<double> values;
  for (const BladeLoad<D>& blade : blades) {
    values.insert(values.end(), blade.impulse.begin(), blade.impulse.end());
    values.insert(values.end(), blade.force.begin(), blade.force.end());
    values.insert(values.end(), {blade.work, blade.power});
  }
  archive.put("blades", std::span<const double>(values));
}

template <int D>
void get_blades(const ArchiveReader& archive, std::vector<BladeLoad<D>>& blades) {
  const auto values = archive.get<double>("blades");
  for (std::size_t b = 0; b < blades.size(); ++b) {
    const std::size_t first = b * (2 * D + 2);
    for (int a = 0; a < D; ++a) {
      blades[b].impulse[a] = values.at(first + a);
      blades[b].force[a] = values.at(first + D + a);
    }
    blades[b].work = values.at(first + 2 * D);
    blades[b].power = values.at(first + 2 * D + 1);
  }
}

}  // namespace

template <class T, int D>
void put_state(ArchiveWriter& archive, const State<T, D>& state) {
  undeformed::put_state<D>(archive, state);
  put_blades<D>(archive, state.blades);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    undeformed::put_arrays(archive, b, state.bodies[b]);
  }
}

template <class T, int D>
void get_state(const ArchiveReader& archive, State<T, D>& state) {
  undeformed::get_state<D>(archive, state);
  get_blades<D>(archive, state.blades);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    undeformed::get_arrays(archive, b, state.bodies[b]);
  }
}

template void put_state<double, 2>(ArchiveWriter&, const State<double, 2>&);
template void put_state<double, 3>(ArchiveWriter&, const State<double, 3>&);
template void get_state<double, 2>(const ArchiveReader&, State<double, 2>&);
template void get_state<double, 3>(const ArchiveReader&, State<double, 3>&);
template void put_state<float, 2>(ArchiveWriter&, const State<float, 2>&);
template void put_state<float, 3>(ArchiveWriter&, const State<float, 3>&);
template void get_state<float, 2>(const ArchiveReader&, State<float, 2>&);
template void get_state<float, 3>(const ArchiveReader&, State<float, 3>&);

}  // namespace pliant::point_based
